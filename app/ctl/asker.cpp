// SPDX-License-Identifier: GPL-3.0-or-later
#include "asker.h"

#include <QTimer>
#include <algorithm>
#include <utility>

#include "ask_words.h"
#include "bus/j1939.h"
#include "report/decode_lines.h"
#include "service/ask_rules.h"

namespace deckpipe::ctl {
namespace {

// The poll that a frame to us answers, and which part of its answer it is; Count where it answers none. One
// of a wrong length is told by its type alone.
struct Answer {
  Ask ask = Ask::Count;
  std::size_t part = 0;
};
Answer answerIn(const Frame& frame, const Classified& what) {
  if (!what.malformed && !what.isDecoded()) return {};
  for (const Ask ask : kAllOf<Ask>) {
    if (isCommand(ask)) continue;
    const auto& answers = ruleOf(ask).answers;
    for (std::size_t part = 0; part < answers.size(); ++part) {
      const MessageId message = answers[part];
      if (message == kNoAnswer) continue;
      if (what.malformed ? hasTypeOf(frame, message) : message == what.message) return {ask, part};
    }
  }
  return {};
}

// For a command to reach the bus.
constexpr Duration kBusPatience = 2s;

}  // namespace

Asker::Asker(LiveRun& run, bool saysAnswered) : m_run(run), m_saysAnswered(saysAnswered) {
  run.follower().onFrame = [this](const Frame& frame, const Classified& what) { frameCame(frame, what); };
  run.follower().onNote = [this](const Note& note) { noteCame(note); };
}

void Asker::begin(const std::vector<DeviceServices>& devices, AskSet asks, NotTaken notTaken) {
  m_asks = asks;
  const std::vector<Open> before = std::exchange(m_asked, {});
  m_wait.clear();
  for (const DeviceServices& device : devices) {
    bool takesAny = false;
    asks.forEach([&](Ask ask) {
      Open at{device.device, device.address, ask};
      const auto known = std::ranges::find(before, at.device, &Open::device);
      at.holder = known != before.end() ? known->holder : book().holder(at.address);
      if (!device.takes.has(ask)) {
        if (notTaken == NotTaken::IsAFailure) {
          ++m_unanswered;
          endLine(at, "not_taken");
        }
        return;
      }
      m_hasAsked = takesAny = true;
      m_asked.push_back(at);
    });
    if (takesAny) m_wait.push_back(device.device);
  }
  std::ranges::reverse(m_wait);
  m_open = m_asked;
  sendNext();
}

const RequestStatus* Asker::statusOf(const Open& at) const {
  const DeviceServices* device = m_run.services().find(at.device);
  return device != nullptr ? &device->of(at.ask) : nullptr;
}

// One device after the other, so that no refusal goes unseen.
void Asker::sendNext() {
  m_serial = 0;
  if (m_wait.empty()) return;
  m_handed = m_wait.back();
  m_wait.pop_back();
  const auto first = std::ranges::find(m_asked, m_handed, &Open::device);
  const RequestStatus* status = statusOf(*first);
  m_askedBefore = status != nullptr ? status->asked : 0;
  m_serial = m_run.session().want(wish::AskDevice{m_handed, m_asks});
  if (m_serial == 0) refused(Refusal::NoLink);
}

const AddressBook& Asker::book() const { return m_run.follower().state().channel(m_run.channel()).book; }

// Another node holds the address of a device that is nowhere else.
bool Asker::isTaken(const Open& at) const {
  const DeviceServices* now = m_run.services().find(at.device);
  const bool isElsewhere = now != nullptr && now->address != at.address && now->address != kNullAddress;
  const Name holder = book().holder(at.address);
  return !isElsewhere && !holder.isNull() && holder != at.holder;
}

void Asker::refused(Refusal refusal) {
  const auto ended =
      std::ranges::stable_partition(m_open, [this](const Open& at) { return at.device != m_handed; });
  m_unanswered += ended.size();
  for (const Open& at : ended) endLine(at, "refused", isTaken(at) ? "address_taken" : refusalWord(refusal));
  m_open.erase(ended.begin(), ended.end());
  sendNext();
}

// A command that is not on the bus yet may stay so for ever.
void Asker::giveUpWaiting() {
  const Instant now = m_run.snapshot().view.cursor.time;
  std::erase_if(m_open, [&](const Open& at) {
    const RequestStatus* status = statusOf(at);
    if (status == nullptr || status->progress != RequestStatus::Progress::NotOnBusYet ||
        now - status->sent < kBusPatience)
      return false;
    endLine(at, "not_on_bus_yet");
    return true;
  });
}

void Asker::tick() {
  giveUpWaiting();
  if (m_serial == 0) return;
  if (m_run.services().refusedSerial == m_serial) return refused(m_run.services().refusal);
  const auto first = std::ranges::find(m_asked, m_handed, &Open::device);
  const RequestStatus* status = statusOf(*first);
  if (status != nullptr && status->asked != m_askedBefore) sendNext();
}

void Asker::frameCame(const Frame& frame, const Classified& what) {
  if (!frame.isExtended() || frame.isError() || frame.length == 0) return;
  if ((frame.flags & Frame::kSent) != 0) return echoCame(frame, what);
  const J1939Id id = J1939Id::of(frame.identifier());
  if (id.pgn != pgn::kProprietaryA || id.destination != m_run.ownAddress()) return;
  const Answer answer = answerIn(frame, what);
  if (answer.ask == Ask::Count) return;
  const Device* device = m_run.follower().state().devices().byAddress(m_run.channel(), id.source);
  // What comes again, or from who has not been asked, is no answer.
  const auto asked = std::ranges::find_if(m_asked, [&](const Open& at) {
    if (at.ask != answer.ask || (at.heard >> answer.part & 1u) != 0) return false;
    return at.device.kind == DeviceKey::Kind::Pin ? device != nullptr && device->pin == at.device.pin
                                                  : id.source == at.address;
  });
  if (asked == m_asked.end()) return;
  if (!what.malformed) asked->heard |= 1u << answer.part;
  std::string decoded;
  appendDecoded(decoded, DecodeFormat::JsonLines, frame,
                m_run.snapshot().view.document->frames.channelName(frame.channel), what);
  m_run.output().text() +=
      JsonLine().add("pin", asked->device.pin).add("ask", askWord(answer.ask)).addAllOf(decoded).text();
}

void Asker::echoCame(const Frame& frame, const Classified& what) {
  if ((frame.flags & Frame::kConfirmed) == 0 || !m_run.services().echoes || !what.isDecoded()) return;
  const J1939Id id = J1939Id::of(frame.identifier());
  for (Open& at : m_open) {
    const DeviceServices* now = m_run.services().find(at.device);
    const Address address = now != nullptr ? now->address : at.address;
    if (ruleOf(at.ask).request == what.message && id.destination == address) at.isOnBus = true;
  }
}

std::optional<ExitStatus> Asker::interrupted(ExitStatus idle) {
  if (m_open.empty()) return idle;
  if (std::exchange(m_isStopping, true)) {
    stop();
    return kNotWhole;
  }
  QTimer::singleShot(kStopPatience, &m_run, [this] {
    stop();
    m_run.finish(kNotWhole);
  });
  return {};
}

void Asker::stop() {
  for (const Open& at : m_open) {
    JsonLine line = endOf(at, "stopped");
    const RequestStatus* status = statusOf(at);
    const bool isUnsent = std::ranges::find(m_wait, at.device) != m_wait.end() ||
                          (status != nullptr && status->progress == RequestStatus::Progress::Queued);
    if (at.isOnBus || isUnsent) {
      line.add("on_bus", at.isOnBus);
    } else {
      line.add("on_bus", Value());  // handed over, and no echo came: nobody can tell
    }
    m_run.output().text() += line.text();
  }
  m_unanswered += m_open.size();
  m_open.clear();
  m_wait.clear();
  m_serial = 0;
}

void Asker::noteCame(const Note& note) {
  const auto* ended = std::get_if<note::AskEnded>(&note.value);
  if (ended == nullptr) return;
  const RequestEnd end = ended->end;
  const auto isMeant = [&](const Open& at) {
    return at.ask == ended->ask && (at.device.kind == DeviceKey::Kind::Pin ? at.device.pin == ended->pin
                                                                           : at.address == ended->address);
  };
  if (end == RequestEnd::AnsweredLate) {  // after its end
    const auto asked = std::ranges::find_if(m_asked, isMeant);
    if (asked != m_asked.end()) endLine(*asked, endWord(asked->ask, end));
    return;
  }
  const auto open = std::ranges::find_if(m_open, isMeant);
  if (open == m_open.end()) return;
  if (end != RequestEnd::Answered) ++m_unanswered;
  if (end != RequestEnd::Answered || m_saysAnswered) endLine(*open, endWord(open->ask, end));
  m_open.erase(open);
}

JsonLine Asker::endOf(const Open& at, std::string_view end) const {
  JsonLine line;
  const DeviceServices* now = m_run.services().find(at.device);
  line.add("pin", at.device.pin).add("address", now != nullptr ? now->address : at.address);
  line.add("ask", askWord(at.ask)).add("end", end);
  return line;
}

void Asker::endLine(const Open& at, std::string_view end, std::string_view reason) {
  JsonLine line = endOf(at, end);
  if (!reason.empty()) line.add("reason", reason);
  const RequestStatus* status = statusOf(at);
  if (status != nullptr && status->tries > 0) {
    line.add("tries", std::int64_t{status->tries});
    if (status->end == RequestEnd::Answered || status->end == RequestEnd::AnsweredLate)
      line.add("latency_ms", Value::decimal(status->latency / 100us, 1));
  }
  m_run.output().text() += line.text();
}

}  // namespace deckpipe::ctl
