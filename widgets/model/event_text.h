// SPDX-License-Identifier: GPL-3.0-or-later
// Events and notes of a log as sentences, and whom they concern. For the list of events and the
// marks of the timeline.
#pragma once

#include <QString>

#include "model/device_labels.h"
#include "state/log_view.h"

namespace deckpipe {

// "Moved from address 80 to 85"; "Disabled: it cannot move, since 0:00:05.101" where it holds for longer than
// it is listed. `begin`: of the log. Whom it concerns says keyOf().
QString eventText(const Event& event, Instant begin);
// Whom an event concerns; null where the whole bus is.
DeviceKey keyOf(const Event& event);
// The device's label, or its PIN, "Address 80", "Node 24", "Joystick 33"; empty of no device.
QString deviceNameText(const DeviceKey& key, const DeviceLabels& labels);

QString noteText(const LogDocument& log, const Note& note);
DeviceKey keyOf(const Note& note);

// "Addresses"
QString eventGroupText(EventGroup group);
// "Fault", "Warning", "Information"
QString eventWeightText(Severity weight);

}  // namespace deckpipe
