// SPDX-License-Identifier: GPL-3.0-or-later
// Events and notes of a log as sentences, and how much each wants attention. For the list of events and the
// marks of the timeline.
#pragma once

#include <QString>

#include "state/events.h"

namespace deckpipe {

// Fault: something stopped working. Attend: look here. Mark: a person's own. Plain: how things go.
enum class EventWeight : std::uint8_t { Plain, Mark, Attend, Fault };

QString eventText(const Event& event);
EventWeight weightOf(const Event& event);

QString noteText(const LogDocument& log, const Note& note);
EventWeight weightOf(const Note& note);

}  // namespace deckpipe
