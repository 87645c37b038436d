// SPDX-License-Identifier: GPL-3.0-or-later
#include "paint/contrast.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace deckpipe {
namespace {

double linear(float channel) {
  const double c = static_cast<double>(channel);
  return c <= 0.03928 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

double luminance(const QColor& c) {
  return 0.2126 * linear(c.redF()) + 0.7152 * linear(c.greenF()) + 0.0722 * linear(c.blueF());
}

}  // namespace

double contrastRatio(const QColor& a, const QColor& b) {
  const auto [dark, bright] = std::minmax({luminance(a), luminance(b)});
  return (bright + 0.05) / (dark + 0.05);
}

std::vector<ContrastPair> contrastPairs(const Colours& c) {
  std::vector<ContrastPair> pairs;
  const std::pair<const char*, QColor> grounds[] = {
      {"window", c.window}, {"surface", c.surface}, {"alternate surface", c.surfaceAlternate}};
  const std::pair<const char*, const Tone&> tones[] = {
      {"accent", c.accent}, {"attend", c.warning}, {"fault", c.fault}, {"fine", c.fine}, {"stale", c.stale}};
  for (const auto& [ground, back] : grounds) {
    const std::string on = std::string(" on ") + ground;
    pairs.push_back({"text" + on, c.text, back, kTextContrast});
    pairs.push_back({"secondary text" + on, c.textSecondary, back, kTextContrast});
    pairs.push_back({"outline" + on, c.outline, back, kGraphicsContrast});
    pairs.push_back({"travel" + on, c.travel, back, kGraphicsContrast});
    for (const auto& [name, tone] : tones) pairs.push_back({name + on, tone.ink, back, kTextContrast});
  }
  for (const auto& [name, tone] : tones)
    pairs.push_back({std::string("on ") + name, tone.onFill, tone.fill, kTextContrast});
  pairs.push_back({"stale text on stale fill", c.stale.onFill, c.stale.fill, kTextContrast});
  // The timeline after its cursor.
  pairs.push_back({"density on stale fill", c.textSecondary, c.stale.fill, kGraphicsContrast});
  pairs.push_back({"attend on stale fill", c.warning.ink, c.stale.fill, kGraphicsContrast});
  pairs.push_back({"accent on stale fill", c.accent.ink, c.stale.fill, kGraphicsContrast});
  return pairs;
}

}  // namespace deckpipe
