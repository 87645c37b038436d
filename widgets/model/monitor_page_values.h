// SPDX-License-Identifier: GPL-3.0-or-later
// All that a device's page draws, as plain values in the person's language. monitorPageOf() makes it from a
// view; MonitorPage (room panel) only lays it out. What is not there has no part: a page has a dial, a stick,
// lamps and facts as far as the device has something to say with them.
#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "model/device_rows.h"

namespace deckpipe {

// One axis of the dial. Position is from feedback only, never from commands.
struct PageAxis {
  struct Command {
    double speed = 0;             // −1 (left, down) .. +1 (right, up)
    QString source;               // "Joystick 33"
    Address from = kNullAddress;  // null: not known, by way of the gateway
    friend bool operator==(const Command&, const Command&) = default;
  };

  std::optional<PositionReading> reading;  // nothing: no such message ever came
  bool isStale = false;
  std::optional<Duration> age;
  std::optional<Status2> plusStop, minusStop;
  std::optional<SoftLimits> limits;  // 0.1 degree
  bool areLimitsStale = false;
  std::optional<Command> command;
  friend bool operator==(const PageAxis&, const PageAxis&) = default;
};

struct PageDial {
  PageAxis rotation, elevation;
  std::optional<bool> enable, stowed;  // nothing: the outputs never came, or are stale
  friend bool operator==(const PageDial&, const PageDial&) = default;
};

enum class LampTone : std::uint8_t { Plain, Fine, Attend, Stop };

struct PageLamp {
  QString label{};
  QString spoken{};              // for who does not see where the lamp stands; empty: the label
  std::optional<Status2> state;  // nothing: never came
  LampTone whenOn = LampTone::Plain;
  friend bool operator==(const PageLamp&, const PageLamp&) = default;
};

// Lamps that came with one message.
struct PageLampGroup {
  QString key{};  // for object names; never shown
  QString title{};
  QString remark{};  // who sent it, what its number means
  std::optional<Duration> age;
  bool isStale = false;
  std::vector<PageLamp> lamps{};
  friend bool operator==(const PageLampGroup&, const PageLampGroup&) = default;
};

struct PageStop {
  QString axis{};
  QString remark{};
  PageLamp minus, plus;
  friend bool operator==(const PageStop&, const PageStop&) = default;
};

struct PageStops {
  std::optional<Duration> age;
  bool isStale = false;
  std::vector<PageStop> axes{};
  friend bool operator==(const PageStops&, const PageStops&) = default;
};

enum class FactTone : std::uint8_t { Plain, Fine, Attend, Fault, Stale };

struct PageFact {
  QString label{};
  QString value{};  // lines
  FactTone tone = FactTone::Plain;
  std::optional<Duration> age;
  friend bool operator==(const PageFact&, const PageFact&) = default;
};

struct PageFactGroup {
  QString key{};
  QString title{};
  std::vector<PageFact> facts{};
  friend bool operator==(const PageFactGroup&, const PageFactGroup&) = default;
};

// A joystick's stick or grip: −1 .. +1, right and forward positive; nothing where the message gives none.
struct PageStick {
  QString title{};
  std::optional<double> x, y;
  QString xText, yText;  // "50.0 % right", "error"
  QString thetaText;     // of a grip; empty: it has none
  std::optional<Duration> age;
  bool isStale = false;
  friend bool operator==(const PageStick&, const PageStick&) = default;
};

struct MonitorPageValues {
  bool isFound = false;  // otherwise only `key` says anything
  DeviceKey key{};

  QString title{};     // the person's label, or what identifies it
  QString identity{};  // PIN, where the title is a label
  QString type{};
  QString address{};      // "address 80 hex", "address lost"
  QString channel{};      // empty where there is one only
  QString traceFilter{};  // lets only its frames into the trace; empty where it holds no address
  std::optional<Duration> age;
  Health health;
  QStringList reasons{};  // sentences, the worst first; all of them stand in the facts too

  std::optional<PageDial> dial;
  std::vector<PageStick> sticks{};  // a joystick's own, then its grip
  PageStops stops;
  std::vector<PageLampGroup> lamps{};
  std::vector<PageFactGroup> facts{};
  friend bool operator==(const MonitorPageValues&, const MonitorPageValues&) = default;
};

}  // namespace deckpipe
