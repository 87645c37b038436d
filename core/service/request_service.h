// SPDX-License-Identifier: GPL-3.0-or-later
// Polls and commands: each has a deadline and an end. Answers are in the State anyhow, here is only whether,
// when and how a request was answered.
//
// 1. Never two requests of one kind are in flight to one device.
// 2. Polls wait for their turn so that they and their answers keep within the budget of the bus, in order of
//    their being due; commands go out at once, and are never repeated by themselves.
// 3. A try goes to where the device is at that moment, and only an answer from there, sent to us, counts. Its
//    clock starts when it is on the bus; an answer before that cannot be its own.
// 4. A poll that does not reach the bus within its patience ends so. A command stays, since nothing takes it
//    back: it is 'not on the bus yet' until its frame goes out or goes with the interface, also after whoever
//    asked for it was told another end. Until then there is no second one.
// 5. A device that loses its address, a link that is lost, and locking end what is open.
#pragma once

#include <vector>

#include "control/intent.h"
#include "control/status.h"
#include "service/bus_budget.h"
#include "service/claim_service.h"
#include "service/request_rules.h"

namespace deckpipe {

class RequestService : public Service {
 public:
  // An answer this long after it was given up is still told from one that nobody asked for.
  static constexpr Duration kLate = 5s;
  // A device that restarts is silent for three periods of its statuses at least: its claim alone takes 250 ms.
  static constexpr Duration kRestart = 300ms;

  // Sends from the address that `own` claims.
  RequestService(BusBudget& budget, const ClaimService& own) : m_budget(budget), m_own(own) {}

  void linkChanged(Instant now, const Live& live, bool isOpen, Outgoing& out) override;
  std::optional<Refusal> intentCame(Instant now, const Live& live, const Intent& intent,
                                    Outgoing& out) override;
  void received(Instant now, const Live& live, const Frame& frame, Outgoing& out) override;
  void writeEnded(Instant now, const Live& live, FrameTag tag, WriteOutcome outcome, Outgoing& out) override;
  void timeCame(Instant now, const Live& live, Outgoing& out) override;
  Instant nextTime() const override;
  void end(Instant now, const Live& live, EndReason reason, Outgoing& out) override;
  Address source() const override { return m_own.address(); }
  void status(const Live& live, ServiceStatus& into) const override;

 private:
  struct Timing {
    Address to;            // where the last try went
    Instant due = kNever;  // of a queued one: not before
    Instant deadline = kNever;
    Instant lastStatus = kNotYet;  // from there since it was sent
    std::uint8_t answers = 0;      // bit n: the rule's n-th answer came
    FrameTag tag{};                // of the last try
    bool isOnBus = false;          // the last try
    bool wasOnBus = false;         // any try
    bool wrong = false;            // an answer of a wrong length came
    std::uint8_t spare = 0;        // answers that may yet come to tries before the one that was answered
  };
  // A command whose frame was handed over and has not ended.
  struct Handed {
    FrameTag tag{};
    DeviceKey device;
    Request request;
    Address to;
    Instant since;
    bool isSaid = false;  // that it is not on the bus yet
  };
  struct Asked {
    DeviceKey device;
    EnumArray<Request, RequestStatus> statuses;
    EnumArray<Request, Timing> timings;
    RequestStatus& status(Request request) { return statuses[request]; }
    Timing& timing(Request request) { return timings[request]; }
  };

  Refusal request(Instant now, const Live& live, const intent::SendRequests& intent, Outgoing& out);
  Refusal repeat(Instant now, const Live& live, const intent::Repeat& intent, Outgoing& out);
  Refusal cancel(Instant now, const Live& live, const intent::Cancel& intent, Outgoing& out);
  // Everything ends, nothing is repeated any more.
  void endAll(Instant now, const Live& live, RequestEnd end, Outgoing& out);
  // What was asked of an address is asked of the device there once its PIN is known.
  void adopt(Instant now, const Live& live, Outgoing& out);

  Asked& asked(const DeviceKey& device);
  const Asked* find(const DeviceKey& device) const;
  static void queue(RequestStatus& status, Timing& timing, Instant due);
  void send(Instant now, const Live& live, Asked& at, Request request, Outgoing& out);
  // Polls whose turn has come.
  void sendDue(Instant now, const Live& live, Outgoing& out);
  void commandEnded(Instant now, const Live& live, const Handed& command, RequestEnd how, Outgoing& out);
  void sayNotOnBus(const Live& live, Handed& command, Outgoing& out);
  bool isHanded(const DeviceKey& device, Request request) const;
  // The request whose last try this frame is; null where it has ended.
  Asked* openWith(FrameTag tag, Request& request);
  // Keeps what a command changes.
  static void noteAngles(const Live& live, const DeviceKey& key, Address to, Request request, Outgoing& out);
  void noteEnd(const Live& live, const DeviceKey& device, Address to, Request request, RequestEnd how,
               Outgoing& out);
  void expire(Instant now, const Live& live, Asked& at, Request request, Outgoing& out);
  void end(Instant now, const Live& live, Asked& at, Request request, RequestEnd how, Outgoing& out);
  void endDevice(Instant now, const Live& live, Asked& at, RequestEnd how, Outgoing& out);
  void answered(Instant now, const Live& live, Asked& at, Request request, std::size_t part, Outgoing& out);
  void broadcastHeard(Instant now, const Live& live, Address source, const Frame& frame, Outgoing& out);

  BusBudget& m_budget;
  const ClaimService& m_own;
  std::vector<Asked> m_devices;
  std::vector<Handed> m_commands;
  Instant m_nextPoll = kNotYet;  // not before: the budget
};

}  // namespace deckpipe
