// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipe_talk.h"

#include <unistd.h>

#include <QSocketNotifier>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <utility>

#include "bus/j1939.h"
#include "command.h"
#include "control/pipe_event.h"
#include "counts.h"
#include "request_words.h"

namespace deckpipe::ctl {
namespace {

using Progress = PipeStatus::Progress;
using What = intent::PipeAction::What;

// Enough to keep the pipe busy between two ticks many times over; the rest waits where it came from.
constexpr std::uint64_t kMaxAhead = 1'024;
constexpr qint64 kTellEvery = 1'000;  // ms

double milliseconds(Duration duration) { return std::chrono::duration<double, std::milli>(duration).count(); }

}  // namespace

PipeTalk::PipeTalk(LiveRun& run, PipePlan plan)
    : m_run(run), m_plan(std::move(plan)), m_finder(run, m_plan.whom) {
  run.onReady = [this] { m_finder.begin(); };
  run.onTick = [this] { tick(); };
  run.onStop = [this] { return stop(); };
  run.follower().onFrame = [this](const Frame& frame, const Classified&) { frameCame(frame); };
  run.follower().onNote = [this](const Note& note) {
    const auto* pipe = std::get_if<note::Pipe>(&note.value);
    if (pipe != nullptr && pipe->event == PipeEvent::Stalled) ++m_stalls;
  };
}

PipeTalk::~PipeTalk() = default;

PipeStatus PipeTalk::status() const {
  const DeviceServices* device = m_run.services().find(m_device);
  return device != nullptr && device->pipe ? *device->pipe : PipeStatus{};
}

void PipeTalk::tick() {
  if (m_phase == Phase::Finding) {
    if (m_finder.hasFound()) begin(m_finder.devices().front());
    return;
  }
  const PipeStatus pipe = status();
  if (m_run.services().claim.progress != ClaimStatus::Progress::Claimed)
    return fail(QStringLiteral("our address was lost to another node"), pipe);
  if (m_firstSerial != 0 && m_run.services().refusedSerial >= m_firstSerial) {
    return fail(QLatin1String(kRefusalWords[m_run.services().refusal].sentence), pipe);
  }
  talk(pipe);
}

void PipeTalk::begin(const DeviceServices& device) {
  m_device = device.device;
  m_address = device.address;
  m_quiet.start();
  if (!m_run.follower().state().channel(m_run.channel()).book.isAkron(m_address))
    return fail(
        deviceText(device) + QStringLiteral(" is not known to be Akron's, which alone have a data pipe"), {});
  m_phase = Phase::Before;
  if (!m_plan.before.empty()) write(m_plan.before);
}

void PipeTalk::talk(const PipeStatus& pipe) {
  if (pipe.acks != m_acks) m_inARow = 0;
  m_acks = pipe.acks;
  if (pipe.restarts != 0 && m_phase != Phase::Listening)
    return fail(QStringLiteral("the device restarted meanwhile"), pipe);
  if (pipe.progress == Progress::Stalled) return ackMissing(pipe);
  const bool isIdle = pipe.progress == Progress::Idle && pipe.sent >= m_handed + pipe.fileSent;
  if (m_isStopping) {
    if (isIdle || pipe.progress == Progress::Paused) fail(QStringLiteral("stopped"), pipe);
    return;
  }
  switch (m_phase) {
    case Phase::Finding: return;
    case Phase::Before:
      if (isIdle) beginSending();
      return;
    case Phase::Sending:
      if (sendsFile()) {
        if (pipe.file.empty()) return;  // not begun yet
        if (pipe.isSendingFile()) return sayProgress(pipe);
        if (pipe.fileEnd != PipeStatus::FileEnd::Done)
          return fail(QStringLiteral("not sent to its end"), pipe);
        sayEnd(pipe);
      } else {
        if (m_input != nullptr) m_input->setEnabled(m_handed - pipe.sent < kMaxAhead);
        if (!m_inputEnded || !isIdle) return;
      }
      m_phase = Phase::Listening;
      m_quiet.start();
      return;
    case Phase::Listening:
      if (m_quiet.elapsed() < static_cast<qint64>(m_plan.idle * 1000)) return;
      if (!sendsFile()) sayDoubts(pipe);
      // Nobody knows whether the device got what was skipped.
      m_run.finish(pipe.skipped == 0 ? kDone : kNotWhole);
  }
}

void PipeTalk::beginSending() {
  m_phase = Phase::Sending;
  if (sendsFile()) {
    m_sending.start();
    m_progress.start();
    const std::uint64_t serial =
        m_run.session().intend(intent::PipeFile{m_device, m_plan.fileName, m_plan.content});
    if (m_firstSerial == 0) m_firstSerial = serial;
    return;
  }
  m_input = std::make_unique<QSocketNotifier>(STDIN_FILENO, QSocketNotifier::Read);
  QObject::connect(m_input.get(), &QSocketNotifier::activated, &m_run, [this] { readInput(); });
}

void PipeTalk::write(std::string bytes) {
  m_handed += bytes.size();
  const std::uint64_t serial = m_run.session().intend(intent::PipeWrite{m_device, std::move(bytes)});
  if (m_firstSerial == 0) m_firstSerial = serial;
}

// A tick enables it again once enough has been acknowledged.
void PipeTalk::readInput() {
  m_input->setEnabled(false);
  char buffer[512];
  const ssize_t count = ::read(STDIN_FILENO, buffer, sizeof buffer);
  if (count < 0 && (errno == EINTR || errno == EAGAIN)) return;
  if (count < 0)
    return fail(QStringLiteral("standard input: %1. What to send was expected there; --file sends a file")
                    .arg(QString::fromLocal8Bit(std::strerror(errno))),
                status());
  std::string bytes = withLineEnds({buffer, static_cast<std::size_t>(count)});
  if (count == 0) {
    if (std::exchange(m_endsInCr, false)) bytes = '\r';
    m_inputEnded = true;
    m_input.reset();
  }
  if (!bytes.empty()) write(std::move(bytes));
}

// A CR at the end is kept back until it is known whether an LF follows.
std::string PipeTalk::withLineEnds(std::string_view input) {
  std::string bytes;
  for (const char c : input) {
    const bool hadCr = std::exchange(m_endsInCr, c == '\r');
    if (hadCr && c != '\n') bytes += '\r';
    if (c == '\n') {
      bytes += m_plan.lineEnd;
    } else if (c != '\r') {
      bytes += c;
    }
  }
  return bytes;
}

void PipeTalk::frameCame(const Frame& frame) {
  if (m_phase == Phase::Finding || !frame.isExtended() || frame.isRemote() || frame.isError()) return;
  if ((frame.flags & Frame::kSent) != 0 || frame.length < 2) return;
  const J1939Id id = J1939Id::of(frame.identifier());
  if (id.pgn != pgn::kProprietaryA || !hasTypeOf(frame, MessageId::PipeData) ||
      id.destination != m_run.ownAddress())
    return;
  const Device* device = m_run.follower().state().devices().byAddress(m_run.channel(), id.source);
  const bool isIt = m_device.kind == DeviceKey::Kind::Pin ? device != nullptr && device->pin == m_device.pin
                                                          : id.source == m_address;
  if (!isIt) return;
  for (std::size_t i = 1; i < frame.length; ++i) m_run.output().text() += static_cast<char>(frame.data[i]);
  m_quiet.start();
}

void PipeTalk::ackMissing(const PipeStatus& pipe) {
  if (pipe.stall == PipeStatus::Stall::Gone)
    return fail(QStringLiteral("the device has no address any more"), pipe);
  if (pipe.stall == PipeStatus::Stall::NotSent)
    return fail(QStringLiteral("the next packet was not sent (%1)")
                    .arg(QLatin1String(kRefusalWords[pipe.refusal].word.data())),
                pipe);
  if (pipe.stall == PipeStatus::Stall::NotOnBus)
    return fail(QStringLiteral("the packet is not on the bus yet; it may still go out"), pipe);
  const bool wasSent = pipe.stall != PipeStatus::Stall::NotTaken;
  const QString why = wasSent ? QStringLiteral("no acknowledgement")
                              : QStringLiteral("the adapter did not take the packet: it was not sent");
  if (m_isStopping || m_plan.missingAck == PipePlan::MissingAck::Stop || m_inARow >= kMaxMissingAcks)
    return fail(why, pipe);
  if (m_decided == m_stalls) return;  // what was decided is on its way
  m_decided = m_stalls;
  ++m_inARow;
  const bool resends = m_plan.missingAck == PipePlan::MissingAck::Resend;
  m_run.say(why + (!resends  ? QStringLiteral("; going on with the next packet")
                   : wasSent ? QStringLiteral("; sending the packet again, it may arrive twice")
                             : QStringLiteral("; sending the packet again")));
  act(resends ? What::Resend : What::Skip);
}

void PipeTalk::act(What what) { m_run.session().intend(intent::PipeAction{m_device, what}); }

void PipeTalk::sayProgress(const PipeStatus& pipe) {
  if (m_progress.elapsed() < kTellEvery) return;
  m_progress.start();
  const double seconds =
      static_cast<double>(m_sending.elapsed()) / 1000 - milliseconds(pipe.filePaused) / 1000;
  const double rate = seconds > 0 ? static_cast<double>(pipe.fileSent) / seconds : 0;
  std::string text = std::to_string(pipe.fileSent) + " of " + counted(pipe.fileSize, "byte", "bytes") + ", " +
                     std::to_string(std::lround(rate)) + " bytes/s";
  if (rate > 0) {
    const std::chrono::duration<double> left(static_cast<double>(pipe.fileSize - pipe.fileSent) / rate);
    text += ", " + lengthText(std::chrono::duration_cast<Duration>(left)) + " left";
  }
  const bool isTerminal = ::isatty(STDERR_FILENO) != 0;
  std::fprintf(stderr, "%s%s%s", isTerminal ? "\r" : "", text.c_str(), isTerminal ? "    " : "\n");
}

void PipeTalk::sayEnd(const PipeStatus& pipe) {
  const double seconds = milliseconds(pipe.fileEnded - pipe.fileBegan - pipe.filePaused) / 1000;
  std::fprintf(stderr, "%s%s in %.1f s, %s, the slowest after %.0f ms\n",
               ::isatty(STDERR_FILENO) != 0 ? "\r" : "", counted(pipe.fileSent, "byte", "bytes").c_str(),
               seconds, counted(pipe.acks, "acknowledgement", "acknowledgements").c_str(),
               milliseconds(pipe.ackWorst));
  sayDoubts(pipe);
}

void PipeTalk::sayDoubts(const PipeStatus& pipe) {
  if (pipe.skipped + pipe.resent > 0)
    std::fprintf(stderr, "%s skipped, %u sent again\n", counted(pipe.skipped, "packet", "packets").c_str(),
                 pipe.resent);
}

// After the packet in flight; a second time at once.
std::optional<ExitStatus> PipeTalk::stop() {
  if (m_phase == Phase::Listening) return status().skipped == 0 ? kDone : kNotWhole;
  if (m_phase == Phase::Sending && !sendsFile() && status().sent >= m_handed) return kDone;
  if (m_isStopping || m_phase == Phase::Finding) return kNotWhole;
  m_isStopping = true;
  act(What::Pause);
  return {};
}

void PipeTalk::fail(const QString& why, const PipeStatus& pipe) {
  const std::uint64_t all = sendsFile() && m_phase >= Phase::Sending ? m_plan.content->size() : m_handed;
  const std::uint64_t acknowledged = sendsFile() && m_phase >= Phase::Sending ? pipe.fileSent : pipe.sent;
  m_run.say(m_phase < Phase::Before
                ? why
                : QStringLiteral("%1; %2 of %3 %4 acknowledged")
                      .arg(why)
                      .arg(acknowledged)
                      .arg(QString::fromStdString(counted(all, "byte", "bytes")))
                      .arg(acknowledged == 1 ? QLatin1String("was") : QLatin1String("were")));
  if (pipe.skipped + pipe.resent > 0)
    m_run.say(QStringLiteral("packets skipped: %1, sent again: %2").arg(pipe.skipped).arg(pipe.resent));
  m_run.finish(kNotWhole);
}

}  // namespace deckpipe::ctl
