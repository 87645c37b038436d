// SPDX-License-Identifier: GPL-3.0-or-later
// What a person wants sent. A view makes one from a deliberate act, the session stamps it and hands it to the
// bus thread, where the services carry it out or refuse it. Devices are named by DeviceKey, never by an
// address that may be another's by then; the services look up where it is at the moment of sending.
#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "base/ids.h"
#include "base/overload.h"
#include "base/time.h"
#include "control/motion.h"
#include "control/request.h"

namespace deckpipe {
namespace intent {

// The transmit lock. Unlocked, the console claims an address of its own.
struct Unlock {};
struct Lock {};
// A request for the NAME to everyone.
struct RequestNames {};
// Once; polls and commands alike. A null device means every device, and then polls only.
struct SendRequests {
  DeviceKey device;
  RequestSet requests;
};
// Polls again and again, every `period` (at least kShortestPeriod); zero ends it. Null device: every one.
struct Repeat {
  static constexpr Duration kShortestPeriod = 500ms;
  DeviceKey device;
  RequestSet requests;
  Duration period{0};
};
// Gives up what is asked of a device and not yet answered, repeated polls too. Null device: every one.
struct Cancel {
  DeviceKey device;
};
// Characters into the data pipe of a device.
struct PipeWrite {
  DeviceKey device;
  std::string bytes;
};
struct PipeFile {
  DeviceKey device;
  std::string name;  // for people
  std::shared_ptr<const std::string> content;
};
struct PipeAction {
  enum class What : std::uint8_t {
    Pause,   // after the packet in flight
    Resume,  // goes on after a pause
    Cancel,  // no more of the file
    Resend,  // after a missing ack: the packet again. It may then arrive twice
    Skip,    // … as if it had been acknowledged
    Abort,   // … nothing more of all that waits
  };
  DeviceKey device;
  What what = What::Pause;
  // Resend and Skip: the same at each further missing ack of this file or text (PipeStatus::rest).
  bool forTheRest = false;
};

// Makes the console's joystick ready to be held. A joystick message has no addressee, so it names whom it moves:
// every monitor that is heard, and no other.
struct ArmJoystick {
  Address source{};  // 33..38 hex
  std::vector<Pin> moves{};
  int limit = kSpeedLimit;       // of the speed, 0.1 %
  bool acceptsUnproven = false;  // the person accepts that nobody can tell whether our frames reach the bus
  std::string platform{};        // what the hand is on, for the record
};
// A hand's word that it holds the joystick, or does not: 'held' lets go by itself after 100 ms. It is refused
// until 'not held' was said, and then until the stick is at rest.
struct HoldJoystick {
  bool isHeld = false;
  Deflection x{}, y{};  // right and forward positive
  Instant verified{};   // CLOCK_BOOTTIME when it was seen that it is held
};
struct DisarmJoystick {
  MotionCause cause = MotionCause::Disarmed;
};

}  // namespace intent

using Intent =
    std::variant<intent::Lock, intent::Unlock, intent::RequestNames, intent::SendRequests, intent::Repeat,
                 intent::Cancel, intent::PipeWrite, intent::PipeFile, intent::PipeAction, intent::ArmJoystick,
                 intent::HoldJoystick, intent::DisarmJoystick>;

// Whether it only holds or ends what is under way: that is offered whatever the cursor shows. What begins
// something wants the live edge.
constexpr bool onlyStops(intent::PipeAction::What what) {
  using What = intent::PipeAction::What;
  switch (what) {
    case What::Pause:
    case What::Cancel:
    case What::Abort: return true;
    case What::Resume:
    case What::Resend:
    case What::Skip: return false;
  }
  return false;
}
inline bool onlyStops(const Intent& intent) {
  return std::visit(
      Overload{[](const intent::Lock&) { return true; }, [](const intent::Cancel&) { return true; },
               [](const intent::Repeat& repeat) { return repeat.period == Duration{0}; },
               [](const intent::PipeAction& action) { return onlyStops(action.what); },
               [](const intent::Unlock&) { return false; }, [](const intent::RequestNames&) { return false; },
               [](const intent::SendRequests&) { return false; },
               [](const intent::PipeWrite&) { return false; }, [](const intent::PipeFile&) { return false; },
               [](const intent::ArmJoystick&) { return false; },
               [](const intent::HoldJoystick& hold) { return !hold.isHeld; },
               [](const intent::DisarmJoystick&) { return true; }},
      intent);
}

struct StampedIntent {
  Intent value;
  Instant stamp{};  // CLOCK_BOOTTIME when the person asked
  std::uint64_t serial = 0;
};

}  // namespace deckpipe
