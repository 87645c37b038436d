// SPDX-License-Identifier: GPL-3.0-or-later
// The choices of how the window looks, by the keys that settings and the command line know them by.
#pragma once

#include <QString>
#include <optional>
#include <span>

#include "paint/app_style.h"
#include "paint/palette.h"

namespace deckpipe {

struct NamedTheme {
  Theme theme;
  const char* key;
  const char* text;  // for the menu; translate in "Appearance"
};
std::span<const NamedTheme> namedThemes();
std::optional<Theme> themeOfKey(const QString& key);
QString keyOfTheme(Theme theme);
std::optional<Density> densityOfKey(const QString& key);
QString keyOfDensity(Density density);

}  // namespace deckpipe
