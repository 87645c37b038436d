// SPDX-License-Identifier: GPL-3.0-or-later
#include "requester.h"

#include <QTimer>
#include <algorithm>
#include <utility>

#include "bus/j1939.h"
#include "report/decode_lines.h"
#include "request_words.h"
#include "service/request_rules.h"

namespace deckpipe::ctl {
namespace {

// The poll that a frame to us answers, and which part of its answer it is; Count where it answers none. One
// of a wrong length is told by its type alone.
struct Answer {
  Request request = Request::Count;
  std::size_t part = 0;
};
Answer answerIn(const Frame& frame, const Classified& what) {
  if (!what.malformed && !what.isDecoded()) return {};
  for (const Request request : kAllOf<Request>) {
    if (isCommand(request)) continue;
    const auto& answers = ruleOf(request).answers;
    for (std::size_t part = 0; part < answers.size(); ++part) {
      const MessageId message = answers[part];
      if (message == kNoAnswer) continue;
      if (what.malformed ? hasTypeOf(frame, message) : message == what.message) return {request, part};
    }
  }
  return {};
}

// For a command to reach the bus.
constexpr Duration kBusPatience = 2s;

}  // namespace

Requester::Requester(LiveRun& run, bool saysAnswered) : m_run(run), m_saysAnswered(saysAnswered) {
  run.follower().onFrame = [this](const Frame& frame, const Classified& what) { frameCame(frame, what); };
  run.follower().onNote = [this](const Note& note) { noteCame(note); };
}

void Requester::begin(const std::vector<DeviceServices>& devices, RequestSet requests, NotTaken notTaken) {
  m_requests = requests;
  const std::vector<Open> before = std::exchange(m_asked, {});
  m_wait.clear();
  for (const DeviceServices& device : devices) {
    bool takesAny = false;
    requests.forEach([&](Request request) {
      Open at{device.device, device.address, request};
      const auto known = std::ranges::find(before, at.device, &Open::device);
      at.holder = known != before.end() ? known->holder : book().holder(at.address);
      if (!device.takes.has(request)) {
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

const RequestStatus* Requester::statusOf(const Open& at) const {
  const DeviceServices* device = m_run.services().find(at.device);
  return device != nullptr ? &device->of(at.request) : nullptr;
}

// One device after the other, so that no refusal goes unseen.
void Requester::sendNext() {
  m_serial = 0;
  if (m_wait.empty()) return;
  m_handed = m_wait.back();
  m_wait.pop_back();
  const auto first = std::ranges::find(m_asked, m_handed, &Open::device);
  const RequestStatus* status = statusOf(*first);
  m_askedBefore = status != nullptr ? status->asked : 0;
  m_serial = m_run.session().intend(intent::SendRequests{m_handed, m_requests});
  if (m_serial == 0) refused(Refusal::NoLink);
}

const AddressBook& Requester::book() const { return m_run.follower().state().channel(m_run.channel()).book; }

// Another node holds the address of a device that is nowhere else.
bool Requester::isTaken(const Open& at) const {
  const DeviceServices* now = m_run.services().find(at.device);
  const bool isElsewhere = now != nullptr && now->address != at.address && now->address != kNullAddress;
  const Name holder = book().holder(at.address);
  return !isElsewhere && !holder.isNull() && holder != at.holder;
}

void Requester::refused(Refusal refusal) {
  const auto ended =
      std::ranges::stable_partition(m_open, [this](const Open& at) { return at.device != m_handed; });
  m_unanswered += ended.size();
  for (const Open& at : ended)
    endLine(at, "refused", isTaken(at) ? "address_taken" : kRefusalWords[refusal].word);
  m_open.erase(ended.begin(), ended.end());
  sendNext();
}

// A command that is not on the bus yet may stay so for ever.
void Requester::giveUpWaiting() {
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

void Requester::tick() {
  giveUpWaiting();
  if (m_serial == 0) return;
  if (m_run.services().refusedSerial == m_serial) return refused(m_run.services().refusal);
  const auto first = std::ranges::find(m_asked, m_handed, &Open::device);
  const RequestStatus* status = statusOf(*first);
  if (status != nullptr && status->asked != m_askedBefore) sendNext();
}

void Requester::frameCame(const Frame& frame, const Classified& what) {
  if (!frame.isExtended() || frame.isError() || frame.length == 0) return;
  if ((frame.flags & Frame::kSent) != 0) return echoCame(frame, what);
  const J1939Id id = J1939Id::of(frame.identifier());
  if (id.pgn != pgn::kProprietaryA || id.destination != m_run.ownAddress()) return;
  const Answer answer = answerIn(frame, what);
  if (answer.request == Request::Count) return;
  const Device* device = m_run.follower().state().devices().byAddress(m_run.channel(), id.source);
  // What comes again, or from who has not been asked, is no answer.
  const auto asked = std::ranges::find_if(m_asked, [&](const Open& at) {
    if (at.request != answer.request || (at.heard >> answer.part & 1u) != 0) return false;
    return at.device.kind == DeviceKey::Kind::Pin ? device != nullptr && device->pin == at.device.pin
                                                  : id.source == at.address;
  });
  if (asked == m_asked.end()) return;
  if (!what.malformed) asked->heard |= 1u << answer.part;
  std::string decoded;
  appendDecoded(decoded, DecodeFormat::JsonLines, frame,
                m_run.snapshot().view.document->frames.channelName(frame.channel), what);
  m_run.output().text() += JsonLine()
                               .add("pin", asked->device.pin)
                               .add("ask", requestWord(answer.request))
                               .addAllOf(decoded)
                               .text();
}

void Requester::echoCame(const Frame& frame, const Classified& what) {
  if ((frame.flags & Frame::kConfirmed) == 0 || !m_run.services().echoes || !what.isDecoded()) return;
  const J1939Id id = J1939Id::of(frame.identifier());
  for (Open& at : m_open) {
    const DeviceServices* now = m_run.services().find(at.device);
    const Address address = now != nullptr ? now->address : at.address;
    if (ruleOf(at.request).request == what.message && id.destination == address) at.isOnBus = true;
  }
}

std::optional<ExitStatus> Requester::interrupted(ExitStatus idle) {
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

void Requester::stop() {
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

void Requester::noteCame(const Note& note) {
  const auto* ended = std::get_if<note::RequestEnded>(&note.value);
  if (ended == nullptr) return;
  const RequestEnd end = ended->end;
  const auto isMeant = [&](const Open& at) {
    return at.request == ended->request &&
           (at.device.kind == DeviceKey::Kind::Pin ? at.device.pin == ended->pin
                                                   : at.address == ended->address);
  };
  if (end == RequestEnd::AnsweredLate) {  // after its end
    const auto asked = std::ranges::find_if(m_asked, isMeant);
    if (asked != m_asked.end()) endLine(*asked, endWord(asked->request, end));
    return;
  }
  const auto open = std::ranges::find_if(m_open, isMeant);
  if (open == m_open.end()) return;
  if (end != RequestEnd::Answered) ++m_unanswered;
  if (end != RequestEnd::Answered || m_saysAnswered) endLine(*open, endWord(open->request, end));
  m_open.erase(open);
}

JsonLine Requester::endOf(const Open& at, std::string_view end) const {
  JsonLine line;
  const DeviceServices* now = m_run.services().find(at.device);
  line.add("pin", at.device.pin).add("address", now != nullptr ? now->address : at.address);
  line.add("ask", requestWord(at.request)).add("end", end);
  return line;
}

void Requester::endLine(const Open& at, std::string_view end, std::string_view reason) {
  JsonLine line = endOf(at, end);
  if (!reason.empty()) line.add("reason", reason);
  // What was refused was not sent; the status is that of the request before.
  const RequestStatus* status = reason.empty() ? statusOf(at) : nullptr;
  if (status != nullptr && status->tries > 0) {
    line.add("tries", status->tries);
    if (status->end == RequestEnd::Answered || status->end == RequestEnd::AnsweredLate)
      line.add("latency_ms", Value::decimal(status->latency / 100us, 1));
  }
  m_run.output().text() += line.text();
}

}  // namespace deckpipe::ctl
