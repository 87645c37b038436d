// SPDX-License-Identifier: GPL-3.0-or-later
// What the services are doing, as plain values: published with every snapshot, drawn by the panels. Answers
// themselves are not here, they are in the State like everything else that was heard.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/ids.h"
#include "base/time.h"
#include "control/motion.h"
#include "control/request.h"

namespace deckpipe {

// Why an intent was not carried out.
enum class Refusal : std::uint8_t {
  None,
  Locked,      // the transmit lock is set
  NoLink,      // the link is not up
  NoAddress,   // the console holds no address on the bus yet, or cannot claim one
  NoDevice,    // no such device, or it has no address now
  NotTaken,    // this type of device does not take it
  Busy,        // the same is under way already
  TooMuch,     // more characters than may wait
  NotLive,     // the view stood in the past; nothing is begun from there
  LogFull,     // what would be sent could not be recorded
  NotHeard,    // a command or packet to a device that was not heard for kHeardWithin
  Contested,   // … or whose address two nodes claim at this moment
  ListenOnly,  // the adapter cannot send: its driver says that it is listen-only
  Disputed,    // a command or packet while another node sends from our address: its acks would look like ours
  FormerPin,   // the device said its PIN before the link was down, and not since
  // The rest are about the joystick.
  OtherMonitors,   // those that are heard are not exactly those that were named
  SourceTaken,     // another node uses or holds the joystick's address
  WouldOutrank,    // a joystick of lower priority is heard
  EchoUnproven,    // nobody can tell whether our frames reach the bus, and that was not or cannot be accepted
  StillWaits,      // a frame of it from before may still go out
  BusTrouble,      // the adapter is bus-off or error-passive
  ArmedElsewhere,  // another Deckpipe on this computer
  NotArmed,
  NotReleased,  // it must be let go first, and then held with the stick at rest
  Disabled,     // a monitor's enable is off
};
template <>
inline constexpr Refusal kLastOf<Refusal> = Refusal::Disabled;

// A device that was silent for longer may be gone, or hear nothing: no command and no packet goes to it.
inline constexpr Duration kHeardWithin = 1s;

struct ClaimStatus {
  enum class Progress : std::uint8_t {
    Off,
    Asking,    // who is there
    Claiming,  // an address is claimed, and may be contested yet
    Claimed,
    CannotClaim,  // none is free
    SameName,     // another node on the bus has our NAME: the identity number must be changed
  };
  Progress progress = Progress::Off;
  Address address;              // claiming or claimed; null otherwise
  std::uint64_t name = 0;       // our NAME
  std::uint16_t lost = 0;       // addresses lost to a lower NAME since unlocking
  std::uint16_t won = 0;        // contests won
  std::uint16_t conflicts = 0;  // times that another was heard sending from our address
  bool isDisputed = false;      // another was heard sending from it a moment ago; we claimed again
  bool isOnBus = false;         // the claim was on the bus; also where the adapter cannot tell
  friend bool operator==(const ClaimStatus&, const ClaimStatus&) = default;
};

struct RequestStatus {
  enum class Progress : std::uint8_t {
    Idle,
    Queued,
    Waiting,
    NotOnBusYet,  // a command whose echo has not come: it may still go out
    Ended,
  };
  Progress progress = Progress::Idle;
  RequestEnd end = RequestEnd::None;  // of the last one that ended
  std::uint8_t tries = 0;             // sent so often for the present request
  Instant firstSent = kNotYet;        // the first try was on the bus; handed over, until that is known
  Instant sent = kNotYet;             // the last try …
  Instant ended = kNotYet;
  Duration latency{0};      // from the last try to the whole answer
  Duration period{0};       // repeated so often; 0 = once
  std::uint32_t asked = 0;  // requests, not tries
  std::uint32_t answered = 0;
  std::uint32_t wrong = 0;    // answers of a wrong length
  std::uint32_t unasked = 0;  // answers that came twice, or without having been asked for

  // It has not come to its end.
  bool isOpen() const { return progress != Progress::Idle && progress != Progress::Ended; }
  friend bool operator==(const RequestStatus&, const RequestStatus&) = default;
};

// Of a data pipe: after so many missing acks in a row, each answered as the person had said for all, nobody
// listens, and nothing goes on by itself.
inline constexpr unsigned kMaxMissingAcks = 5;

inline constexpr std::size_t kPipePacket = 7;  // characters, at most

struct PipeStatus {
  enum class Progress : std::uint8_t {
    Idle,
    Sending,
    Settling,  // a second ack may come yet; nothing is sent until then
    Paused,    // by the person
    Stalled,   // until the person decides, or the ack comes after all
  };
  enum class Stall : std::uint8_t {
    None,
    NoAck,     // in time
    Moved,     // and the device is at another address now
    Gone,      // and the device has none
    NotOnBus,  // the packet itself is not on the bus yet; it may still go out
    NotTaken,  // the adapter did not take the packet: it was not sent
    NotSent,   // nothing may go to the device: `refusal` says why
  };
  enum class FileEnd : std::uint8_t {
    None,
    Done,
    Cancelled,
    Aborted,
    Restarted,  // the device did, in the middle of it
  };
  // What becomes of a packet whose ack is missing.
  enum class Rest : std::uint8_t { Ask, Resend, Skip };

  Progress progress = Progress::Idle;
  Stall stall = Stall::None;
  Refusal refusal = Refusal::None;  // of the last packet, by the rules for sending to a device
  // As the person said for the rest of a file or text. It ends with that, with the next that is typed, after
  // kMaxMissingAcks, at any stall that is not for a missing ack, at a lock, and when the device restarts.
  Rest rest = Rest::Ask;
  std::uint32_t waiting = 0;  // characters typed and not yet sent
  std::uint64_t sent = 0;     // characters acknowledged or skipped
  std::uint64_t received = 0;
  std::uint32_t skipped = 0, resent = 0, lateAcks = 0, strayAcks = 0;
  // Packets of what was typed since nothing waited.
  std::uint32_t textSkipped = 0, textResent = 0;
  std::uint32_t restarts = 0;  // of the device, at which what waited was dropped
  std::uint32_t notTaken =
      0;  // characters that were typed and dropped so; until the next that is typed or sent

  std::string file;  // name of the last one; empty: none yet
  std::uint64_t fileSize = 0, fileSent = 0;
  FileEnd fileEnd = FileEnd::None;
  Instant fileBegan = kNotYet, fileEnded = kNotYet;
  Duration filePaused{0};                         // of that time it was paused or stalled
  std::uint32_t fileSkipped = 0, fileResent = 0;  // packets of it: whether all arrived is not known then
  bool isPaused = false;                          // by the person, also while it is stalled

  // Of the acks of this pipe, from a packet's being on the bus to its ack.
  std::uint32_t acks = 0;
  Duration ackLast{0}, ackWorst{0}, ackSum{0};

  bool isSendingFile() const { return !file.empty() && fileEnd == FileEnd::None; }
  friend bool operator==(const PipeStatus&, const PipeStatus&) = default;
};
template <>
inline constexpr PipeStatus::Progress kLastOf<PipeStatus::Progress> = PipeStatus::Progress::Stalled;

struct DeviceServices {
  DeviceKey device;
  Address address;
  RequestSet takes;  // what may be asked of it, by its type
  EnumArray<Request, RequestStatus> requests;
  std::optional<PipeStatus> pipe;

  const RequestStatus& of(Request request) const { return requests[request]; }
  // Period of the repeated polls, the longest if they differ; 0 if none is repeated.
  Duration longestPeriod() const {
    return std::ranges::max_element(requests, {}, &RequestStatus::period)->period;
  }
  friend bool operator==(const DeviceServices&, const DeviceServices&) = default;
};

// A command that was handed to the adapter and is not on the bus yet. Nothing takes it back: it may still go
// out, until the interface is taken down.
struct WaitingCommand {
  DeviceKey device;
  Request request{};
  Instant since;
  friend bool operator==(const WaitingCommand&, const WaitingCommand&) = default;
};

// The console's own joystick.
struct JoystickStatus {
  enum class Progress : std::uint8_t {
    Off,
    Listening,  // whether its address is silent
    Claiming,   // our claim is not on the bus yet
    Settling,   // and may be contested yet
    Armed,
    Held,
    Releasing,  // it says neutral, and may be held anew
    Ending,     // it says neutral
  };
  Progress progress = Progress::Off;
  MotionCause cause = MotionCause::None;  // of the last end of motion or arming, or why it cannot be held
  Address source{};                       // of the last arming, as all below
  std::vector<Pin> moves{};
  int limit = kSpeedLimit;      // of the speed, 0.1 %
  Instant heldSince = kNotYet;  // the last time
  std::uint32_t frames = 0;     // since then on the bus, neutral too
  Duration period{0};           // of these, the mean
  Duration worstGap{0};         // between two of one hold
  bool wentOutLate = false;     // an old motion frame has just gone out
  friend bool operator==(const JoystickStatus&, const JoystickStatus&) = default;
};
template <>
inline constexpr JoystickStatus::Progress kLastOf<JoystickStatus::Progress> =
    JoystickStatus::Progress::Ending;

struct ServiceStatus {
  bool locked = true;
  bool isEnding = false;  // a lock or close was asked for; a service still has something to say before
  bool linkUp = false;
  // The adapter gives back what was on the bus, and only that; otherwise nobody can tell whether our frames
  // reach it.
  bool echoes = true;
  bool isListenOnly = false;  // the driver says that the adapter cannot send
  ClaimStatus claim;
  JoystickStatus joystick;
  std::vector<DeviceServices> devices;  // that can be asked something, or were
  std::vector<WaitingCommand> waitingCommands;
  double busLoad = 0;               // of the last second, 0..1
  std::uint64_t sent = 0;           // frames handed to the link, second tries too
  std::uint64_t notTaken = 0;       // of these the link did not take
  std::uint64_t unconfirmed = 0;    // handed over 100 ms ago or earlier, and no echo yet: may still go out
  Refusal refusal = Refusal::None;  // of the last intent; None where it was carried out
  std::uint64_t refusedSerial = 0;

  // An address of our own to send from.
  bool canRequest() const {
    return !locked && !isEnding && linkUp && claim.progress == ClaimStatus::Progress::Claimed;
  }
  const DeviceServices* find(const DeviceKey& key) const {
    for (const DeviceServices& device : devices) {
      if (device.device == key) return &device;
    }
    return nullptr;
  }
  friend bool operator==(const ServiceStatus&, const ServiceStatus&) = default;
};

}  // namespace deckpipe
