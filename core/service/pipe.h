// SPDX-License-Identifier: GPL-3.0-or-later
// The data pipe to one device. PipeService has one for each and gives it what concerns it; the rules stand
// at its head.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/enum_table.h"
#include "control/status.h"
#include "service/service.h"

namespace deckpipe {

// How a data pipe goes on: state × event → state. The pipe (pipe.h) asks this table and changes its state
// nowhere else.
enum class PipeMove : std::uint8_t {
  Next,      // a packet is handed over
  Nothing,   // none waits
  Hold,      // the person has paused before the next one
  Ack,       // of the packet in flight, which went once
  AckAgain,  // … which went twice: a second ack may come yet
  Silence,   // no ack in time, not on the bus, not taken by the adapter, nothing may go to the device
  LateEcho,  // the packet in flight is on the bus after all
  Resend,    // the person's decision on a packet whose fate is not known
  Skip,      // …
  GiveUp,    // nothing more of all that waits, or of the file whose packet is in flight
  Settled,   // no ack of a packet that was given up can come any more
  Joined,    // another pipe to the same device was under way: an ack of its packet may come yet
  Count,
};
inline constexpr std::size_t kPipeMoves = kCountOf<PipeMove>;
inline constexpr std::size_t kPipeStates = kCountOf<PipeStatus::Progress>;

namespace pipe_table {
using enum PipeStatus::Progress;
using Cell = std::optional<PipeStatus::Progress>;
inline constexpr Cell No;  // does not happen, or is refused: nothing changes
// clang-format off
inline constexpr EnumTable<PipeStatus::Progress, EnumArray<PipeMove, Cell>> kTable{{
    //           Next      Nothing Hold    Ack   AckAgain  Silence  LateEcho Resend   Skip      GiveUp    Settled Joined
    {Idle,     {{ Sending, Idle,   Paused, No,   No,       No,      No,      No,      No,       Idle,     No,     Settling}}},
    {Sending,  {{ No,      No,     No,     Idle, Settling, Stalled, Sending, No,      No,       Settling, No,     No}}},
    {Settling, {{ No,      No,     No,     No,   No,       No,      No,      No,      No,       Settling, Idle,   Settling}}},
    {Paused,   {{ Sending, Idle,   Paused, No,   No,       No,      No,      No,      No,       Idle,     No,     No}}},
    {Stalled,  {{ No,      No,     No,     Idle, Settling, No,      Sending, Sending, Settling, Settling, No,     No}}},
}};
// clang-format on
}  // namespace pipe_table

// The state after a move; nothing where it does not happen in this state.
constexpr std::optional<PipeStatus::Progress> after(PipeStatus::Progress state, PipeMove move) {
  return pipe_table::kTable[state][move];
}

class Pipe {
 public:
  static constexpr std::size_t kPacket = kPipePacket;
  static constexpr Duration kAckTimeout = 1s;
  static constexpr Duration kSettle = 1s;
  static constexpr std::size_t kMaxTyped = 65'536;  // characters that may wait

  // What a call is given.
  struct Turn {
    Instant now;
    const Live& live;
    Address from;  // ours
    Outgoing& out;
  };

  explicit Pipe(const DeviceKey& device) : m_device(device) {}

  const DeviceKey& device() const { return m_device; }
  const PipeStatus& status() const { return m_status; }
  // Its PIN has become known.
  void rename(const DeviceKey& device) { m_device = device; }

  Refusal write(const Turn& turn, const std::string& bytes);
  Refusal sendFile(const Turn& turn, const intent::PipeFile& intent);
  Refusal act(const Turn& turn, const intent::PipeAction& action);
  // Nothing more of all that waits; what is in flight may or may not arrive.
  void drop(const Turn& turn) { drop(turn, PipeStatus::FileEnd::Aborted); }

  void dataHeard(unsigned characters) { m_status.received += characters; }
  void ackHeard(const Turn& turn, Address source);
  // While a person decides, the device may go, or come back elsewhere. What it restarts in ends.
  void followDevice(const Turn& turn);
  void writeEnded(const Turn& turn, FrameTag tag, WriteOutcome outcome);
  void timeCame(const Turn& turn);
  Instant deadline() const { return m_deadline; }

  // Another pipe to the same device goes on in this one. Where both were under way both end, since nobody
  // could tell whose the next ack is.
  void take(const Turn& turn, Pipe&& other);

 private:
  struct Packet {
    enum class Fate : std::uint8_t {
      NotSent,
      InAdapter,  // handed over: it may go out at any time
      OnBus,      // as far as that can be told
    };
    std::string bytes;
    Address to;
    Instant sent = kNotYet;  // on the bus; handed over, until that is known
    FrameTag tag{};
    Fate fate = Fate::NotSent;
    bool isOfFile = false;
    bool wasResent = false;
  };

  std::size_t waiting() const { return m_typed.size() - m_typedFrom; }
  bool isUnderWay() const { return m_inFlight || waiting() > 0 || m_status.isSendingFile(); }
  bool isBusy() const { return isUnderWay() || m_status.progress == PipeStatus::Progress::Settling; }
  void begin(Instant now);
  bool move(Instant now, PipeMove what);
  void sendNext(const Turn& turn);
  void fly(const Turn& turn);
  void passed(const Turn& turn);
  void stall(const Turn& turn, PipeStatus::Stall why);
  PipeStatus::Stall whyNoAck(const Live& live) const;
  // An ack of what was given up may come until kSettle after it was on the bus.
  void settle(Instant now);
  void giveUpInFlight();
  void deviceRestarted(const Turn& turn);
  Refusal decide(const Turn& turn, PipeStatus::Rest what, bool forTheRest);
  Refusal resend(const Turn& turn);
  Refusal skip(const Turn& turn);
  void drop(const Turn& turn, PipeStatus::FileEnd how);
  void cancelFile(const Turn& turn);
  void endFile(const Turn& turn, PipeStatus::FileEnd how);
  void countHeld(Instant now);

  DeviceKey m_device;
  PipeStatus m_status;
  std::string m_typed;  // from m_typedFrom on it is still to be sent
  std::size_t m_typedFrom = 0;
  std::shared_ptr<const std::string> m_content;
  std::optional<Packet> m_inFlight;
  std::vector<FrameTag> m_inAdapter;  // packets that were given up there
  unsigned m_inARow = 0;              // missing acks that m_status.rest answered
  Instant m_begun = kNotYet;          // what is under way
  Instant m_deadline = kNever;        // of the ack, or of settling
  Instant m_heldSince = kNotYet;      // paused or stalled
};

}  // namespace deckpipe
