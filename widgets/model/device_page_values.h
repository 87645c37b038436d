// SPDX-License-Identifier: GPL-3.0-or-later
// All that a device's page draws, as plain values in the person's language. devicePageOf() makes it from a
// view; DevicePage (room panel) only lays it out. What is not there has no part: a page has a dial, a stick,
// lamps and facts as far as the device has something to say with them.
#pragma once

#include <QString>

#include <optional>
#include <vector>

#include "model/device_rows.h"
#include "paint/dial_values.h"
#include "paint/glyph.h"
#include "paint/stick_values.h"
#include "state/log_view.h"

namespace deckpipe {

struct PageLamp {
  QString label{};
  QString spoken{};              // for who does not see where the lamp stands; empty: the label
  std::optional<Status2> state;  // nothing: never came
  Severity whenOn = Severity::Plain;
  std::optional<Glyph> sign{};  // when on; nothing: the severity's own
  friend bool operator==(const PageLamp&, const PageLamp&) = default;
};

// Lamps that came with one message.
struct PageLampGroup {
  QString key{};  // for object names; never shown
  QString title{};
  QString remark{};  // who sent it, what its number means
  Age age;
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
  Age age;
  bool isStale = false;
  std::vector<PageStop> axes{};
  friend bool operator==(const PageStops&, const PageStops&) = default;
};

struct PageFact {
  QString label{};
  QString value{};  // lines
  Severity tone = Severity::Plain;
  std::optional<Duration> age;  // nothing: none is shown
  friend bool operator==(const PageFact&, const PageFact&) = default;
};

struct PageFactGroup {
  QString key{};
  QString title{};
  std::vector<PageFact> facts{};
  friend bool operator==(const PageFactGroup&, const PageFactGroup&) = default;
};

// A joystick's stick or grip, and what is written of it.
struct PageStick : StickValues {
  QString title{};
  QString xText, yText;  // "50.0 % right", "error"
  QString thetaText;     // of a grip; empty: it has none
  Age age;
  friend bool operator==(const PageStick&, const PageStick&) = default;
};

// Why a device is as it is, in a sentence.
struct PageReason {
  QString text{};
  Severity tone = Severity::Plain;
  QString advice{};  // what to check; may be empty
  friend bool operator==(const PageReason&, const PageReason&) = default;
};

struct DevicePageValues {
  bool isFound = false;  // otherwise only `key` says anything
  DeviceKey key{};

  QString title{};     // the person's label, or what identifies it
  QString identity{};  // PIN, where the title is a label
  QString type{};
  QString address{};      // "address 80 hex", "address lost"
  QString channel{};      // empty where there is one only
  QString traceFilter{};  // lets only its frames into the trace; empty where it holds no address
  Age age;
  Health health;
  std::vector<PageReason> reasons{};  // at least one, the worst first

  std::optional<DialValues> dial;
  std::vector<PageStick> sticks{};  // a joystick's own, then its grip
  PageStops stops;
  std::vector<PageLampGroup> lamps{};
  std::vector<PageFactGroup> facts{};
  friend bool operator==(const DevicePageValues&, const DevicePageValues&) = default;
};

// A device's page as a pure function of the view: the same cursor gives the same page, live or from a file.
// Ages are of the state's own cursor, so that a page never mixes two instants.
DevicePageValues devicePageOf(const LogView& view, const DeviceKey& key, const DeviceLabels& labels = {});

}  // namespace deckpipe
