// SPDX-License-Identifier: GPL-3.0-or-later
// Asks devices and writes what comes of it: a line for every answer, and one for everything asked that came
// to another end. For `poll` and `command`, on every tick of their run.
#pragma once

#include <vector>

#include "json_line.h"
#include "live_run.h"

namespace deckpipe::ctl {

class Requester {
 public:
  // `saysAnswered`: an end line for what was answered too; commands have no answer worth a line.
  Requester(LiveRun& run, bool saysAnswered);

  static constexpr std::chrono::milliseconds kStopPatience{150};

  enum class NotTaken : std::uint8_t { IsLeftOut, IsAFailure };
  // Everything of these once; the last round must be over.
  void begin(const std::vector<DeviceServices>& devices, RequestSet requests, NotTaken notTaken);
  void tick();
  // Ctrl+C. What is open gets kStopPatience more and then a line that says whether it is on the bus, since its
  // answer is not awaited any more. The run ends after that, or with `idle` if nothing is open.
  std::optional<ExitStatus> interrupted(ExitStatus idle);
  bool isStopping() const { return m_isStopping; }
  bool isOver() const { return m_open.empty(); }
  // Of all rounds; there must have been something.
  bool allAnswered() const { return m_unanswered == 0 && m_hasAsked; }

 private:
  struct Open {
    DeviceKey device;
    Address address;
    Request request;
    unsigned heard = 0;    // bit n: the rule's n-th answer came
    Name holder{};         // of the address, when the device was first asked
    bool isOnBus = false;  // our request came back as an echo that proves it
  };
  void stop();
  void sendNext();
  void frameCame(const Frame& frame, const Classified& what);
  void echoCame(const Frame& frame, const Classified& what);
  void noteCame(const Note& note);
  JsonLine endOf(const Open& at, std::string_view end) const;
  void endLine(const Open& at, std::string_view end, std::string_view reason = {});
  void refused(Refusal refusal);
  bool isTaken(const Open& at) const;
  const AddressBook& book() const;
  const RequestStatus* statusOf(const Open& at) const;
  void giveUpWaiting();

  LiveRun& m_run;
  bool m_saysAnswered;
  std::vector<Open> m_open;       // not ended yet
  std::vector<Open> m_asked;      // of this round
  std::vector<DeviceKey> m_wait;  // not handed on yet
  RequestSet m_requests;
  // The intent that was handed on and not seen carried out or refused yet.
  std::uint64_t m_serial = 0;
  DeviceKey m_handed;
  std::uint32_t m_askedBefore = 0;
  std::uint64_t m_unanswered = 0;
  bool m_hasAsked = false;
  bool m_isStopping = false;
};

}  // namespace deckpipe::ctl
