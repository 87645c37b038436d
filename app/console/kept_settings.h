// SPDX-License-Identifier: GPL-3.0-or-later
// What the console keeps in its settings beside the layout: how the window looks, by the keys that the command line knows
// too; the logs that were opened and the buses that were connected to last; the person's own labels.
#pragma once

#include <QDateTime>
#include <QList>
#include <QString>
#include <QStringList>
#include <optional>
#include <span>

#include "model/device_labels.h"
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

// The logs that were opened or saved last, newest first, kept in the settings.
inline constexpr int kMaxRecentLogs = 10;

QStringList recentLogs();
void rememberLog(const QString& path);
void forgetLogs();

// The buses that were connected to last, newest first, each once.
struct KeptLink {
  QString plugin{};
  QString interfaceName{};
  int bitRate = 0;  // bit/s; 0: as the interface had it
  QDateTime when{};
};
inline constexpr int kMaxRecentLinks = 4;

QList<KeptLink> recentLinks();
void rememberLink(const KeptLink& link);

// The person's labels of devices in the program's settings, one key a PIN. MainWindow passes one to the
// workspace, which reads it at the start and writes it at every edit.
class SettingsLabels : public LabelStorage {
 public:
  DeviceLabels read() const override;
  void write(const DeviceLabels& labels) override;
};

}  // namespace deckpipe
