// SPDX-License-Identifier: GPL-3.0-or-later
#include "appearance.h"

#include <QtGlobal>
#include <algorithm>

namespace deckpipe {
namespace {

constexpr NamedTheme kThemeNames[] = {
    {Theme::Light, "light", QT_TRANSLATE_NOOP("Appearance", "&Light")},
    {Theme::Dark, "dark", QT_TRANSLATE_NOOP("Appearance", "&Dark")},
    {Theme::Sunlight, "sunlight", QT_TRANSLATE_NOOP("Appearance", "&Sunlight")},
};
const QString kDesk = QStringLiteral("desk"), kField = QStringLiteral("field");

}  // namespace

std::span<const NamedTheme> namedThemes() { return kThemeNames; }

std::optional<Theme> themeOfKey(const QString& key) {
  for (const NamedTheme& named : kThemeNames) {
    if (key == QLatin1String(named.key)) return named.theme;
  }
  return {};
}

QString keyOfTheme(Theme theme) {
  const auto* found = std::find_if(std::begin(kThemeNames), std::end(kThemeNames),
                                   [theme](const NamedTheme& named) { return named.theme == theme; });
  return found == std::end(kThemeNames) ? QString() : QLatin1String(found->key);
}

std::optional<Density> densityOfKey(const QString& key) {
  if (key == kDesk) return Density::Desk;
  if (key == kField) return Density::Field;
  return {};
}

QString keyOfDensity(Density density) { return density == Density::Field ? kField : kDesk; }

}  // namespace deckpipe
