// SPDX-License-Identifier: GPL-3.0-or-later
#include "paint/palette.h"

namespace deckpipe {
namespace {

Colours light() {
  Colours c;
  c.theme = Theme::Light;
  c.window = QColor(0xECEFF2);
  c.surface = QColor(0xFFFFFF);
  c.surfaceAlternate = QColor(0xF4F6F8);
  c.text = QColor(0x12171C);
  c.textSecondary = QColor(0x4A5661);
  c.outline = QColor(0x75818D);
  c.travel = QColor(0x5B7F97);
  c.accent = {QColor(0x0A5CA8), QColor(0x0A5CA8), QColor(0xFFFFFF)};
  c.warning = {QColor(0x7D4E00), QColor(0xFFB61F), QColor(0x241600)};
  c.fault = {QColor(0xB3141B), QColor(0xC81E25), QColor(0xFFFFFF)};
  c.fine = {QColor(0x156B35), QColor(0x1B7A3E), QColor(0xFFFFFF)};
  c.stale = {QColor(0x5D6770), QColor(0xD5DADF), QColor(0x3C454D)};
  return c;
}

Colours dark() {
  Colours c;
  c.theme = Theme::Dark;
  c.window = QColor(0x14181C);
  c.surface = QColor(0x1C2126);
  c.surfaceAlternate = QColor(0x242A31);
  c.text = QColor(0xF1F4F6);
  c.textSecondary = QColor(0xAAB5BF);
  c.outline = QColor(0x76828E);
  c.travel = QColor(0x6C93AD);
  c.accent = {QColor(0x62B0F7), QColor(0x62B0F7), QColor(0x0B1722)};
  c.warning = {QColor(0xFFBE45), QColor(0xFFB61F), QColor(0x241600)};
  c.fault = {QColor(0xFF7F78), QColor(0xCC2A2F), QColor(0xFFFFFF)};
  c.fine = {QColor(0x5FCB81), QColor(0x5FCB81), QColor(0x08200F)};
  c.stale = {QColor(0x97A2AC), QColor(0x39424B), QColor(0xC6CED6)};
  return c;
}

// Glare lifts every dark tone towards the white, so there are no mid tones to lose: near black on white,
// heavier lines, meaning by shape first.
Colours sunlight() {
  Colours c;
  c.theme = Theme::Sunlight;
  c.window = QColor(0xFFFFFF);
  c.surface = QColor(0xFFFFFF);
  c.surfaceAlternate = QColor(0xF0F0F0);
  c.text = QColor(Qt::black);
  c.textSecondary = QColor(0x1E1E1E);
  c.outline = QColor(0x4A4A4A);
  c.travel = QColor(0x1F4E6B);
  c.accent = {QColor(0x00387A), QColor(0x00387A), QColor(0xFFFFFF)};
  c.warning = {QColor(0x4F3000), QColor(0xFFB300), QColor(Qt::black)};
  c.fault = {QColor(0x9C0008), QColor(0xA8000A), QColor(0xFFFFFF)};
  c.fine = {QColor(0x004D1C), QColor(0x004D1C), QColor(0xFFFFFF)};
  c.stale = {QColor(0x4F4F4F), QColor(0xD0D0D0), QColor(0x202020)};
  c.stroke = 1.5;
  return c;
}

}  // namespace

const Colours& coloursOf(Theme theme) {
  static const Colours ofLight = light(), ofDark = dark(), ofSunlight = sunlight();
  switch (theme) {
    case Theme::Light: break;
    case Theme::Dark: return ofDark;
    case Theme::Sunlight: return ofSunlight;
  }
  return ofLight;
}

const QColor& inkOf(const Colours& colours, Ink ink) {
  switch (ink) {
    case Ink::Text: break;
    case Ink::Secondary: return colours.textSecondary;
    case Ink::Accent: return colours.accent.ink;
    case Ink::Warning: return colours.warning.ink;
    case Ink::Fault: return colours.fault.ink;
    case Ink::Fine: return colours.fine.ink;
    case Ink::Stale: return colours.stale.ink;
  }
  return colours.text;
}

QPalette qtPalette(const Colours& c) {
  QPalette p;
  p.setColor(QPalette::Window, c.window);
  p.setColor(QPalette::WindowText, c.text);
  p.setColor(QPalette::Base, c.surface);
  p.setColor(QPalette::AlternateBase, c.surfaceAlternate);
  p.setColor(QPalette::Text, c.text);
  p.setColor(QPalette::PlaceholderText, c.stale.ink);
  p.setColor(QPalette::Button, c.surfaceAlternate);
  p.setColor(QPalette::ButtonText, c.text);
  p.setColor(QPalette::BrightText, c.fault.ink);
  p.setColor(QPalette::ToolTipBase, c.surface);
  p.setColor(QPalette::ToolTipText, c.text);
  p.setColor(QPalette::Highlight, c.accent.fill);
  p.setColor(QPalette::HighlightedText, c.accent.onFill);
  p.setColor(QPalette::Link, c.accent.ink);
  p.setColor(QPalette::LinkVisited, c.accent.ink);
  // Fusion shades its bevels with these; derived from the window so that the three themes look alike.
  const bool isDark = c.theme == Theme::Dark;
  p.setColor(QPalette::Light, isDark ? c.window.lighter(160) : c.surface);
  p.setColor(QPalette::Midlight, isDark ? c.window.lighter(130) : c.window.lighter(103));
  p.setColor(QPalette::Mid, c.outline);
  p.setColor(QPalette::Dark, isDark ? c.window.darker(160) : c.outline);
  p.setColor(QPalette::Shadow, isDark ? QColor(0, 0, 0) : c.textSecondary);
  // What cannot be used now is greyed but still read: a technician must see what is locked.
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    p.setColor(QPalette::Disabled, role, c.stale.ink);
  p.setColor(QPalette::Disabled, QPalette::Highlight, c.stale.fill);
  p.setColor(QPalette::Disabled, QPalette::HighlightedText, c.stale.onFill);
  return p;
}

}  // namespace deckpipe
