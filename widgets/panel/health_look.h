// SPDX-License-Identifier: GPL-3.0-or-later
// The sign and the tone of a health, the same in the device table and on the page.
#pragma once

#include "model/device_health.h"
#include "paint/glyph.h"
#include "paint/palette.h"

namespace deckpipe {

inline Glyph glyphOf(HealthLevel level) {
  switch (level) {
    case HealthLevel::Fine: return Glyph::Fine;
    case HealthLevel::Quiet: return Glyph::NotAvailable;
    case HealthLevel::Attend: return Glyph::Attend;
    case HealthLevel::Fault: return Glyph::Fault;
    case HealthLevel::Silent: return Glyph::Stale;
  }
  return Glyph::Unknown;
}

inline const Tone& toneOf(const Colours& colours, HealthLevel level) {
  switch (level) {
    case HealthLevel::Fine: return colours.fine;
    case HealthLevel::Attend: return colours.attend;
    case HealthLevel::Fault: return colours.fault;
    case HealthLevel::Quiet:
    case HealthLevel::Silent: break;
  }
  return colours.stale;
}

}  // namespace deckpipe
