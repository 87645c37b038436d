// SPDX-License-Identifier: GPL-3.0-or-later
// The three themes as plain values. The application's style (app_style.h) has the colours of the theme that a
// person chose, and gives them to every painted widget and delegate.
//
// What a colour means is the same in all three: accent = can be touched, attend = look here, fault = a
// fault, fine = good, stale = old; a stop is none of them, but text. Each has a glyph (glyph.h) beside it.
// A test lists every pair in use, and holds text to 4.5:1 and graphics to 3:1.
#pragma once

#include <QColor>
#include <QPalette>
#include <array>
#include <cstdint>

namespace deckpipe {

enum class Theme : std::uint8_t { Light, Dark, Sunlight };
inline constexpr std::array kThemes{Theme::Light, Theme::Dark, Theme::Sunlight};

// One meaning. `ink` writes and draws on window and surface, `fill` covers an area (always outlined with ink,
// for a fill alone need not stand out), `onFill` writes and draws on the fill.
struct Tone {
  QColor ink;
  QColor fill;
  QColor onFill;
  friend bool operator==(const Tone&, const Tone&) = default;
};

struct Colours {
  Theme theme = Theme::Light;
  QColor window;            // behind everything
  QColor surface;           // what content stands on: lists, fields, a dial's face
  QColor surfaceAlternate;  // every other row; the inside of shapes drawn on the surface
  QColor text;              // also what was measured: needles
  QColor textSecondary;     // units, labels, ages
  QColor outline;           // lines without a meaning of their own: scales, frames, the apparatus
  QColor travel;            // the band between soft limits
  Tone accent;
  Tone warning;
  Tone fault;
  Tone fine;
  Tone stale;
  double stroke = 1.0;  // factor on every line width: in the sun thin lines vanish first
  friend bool operator==(const Colours&, const Colours&) = default;
};

// What words and signs are written in.
enum class Ink : std::uint8_t { Text, Secondary, Accent, Warning, Fault, Fine, Stale };
const QColor& inkOf(const Colours& colours, Ink ink);

const Colours& coloursOf(Theme theme);
QPalette qtPalette(const Colours& colours);

}  // namespace deckpipe
