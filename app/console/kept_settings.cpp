// SPDX-License-Identifier: GPL-3.0-or-later
#include "kept_settings.h"

#include <QFileInfo>
#include <QSettings>
#include <QUrl>
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

const QString kRecentKey = QStringLiteral("logs/recent");

const QString kLinksKey = QStringLiteral("link/recent"), kPluginKey = QStringLiteral("plugin"),
              kInterfaceKey = QStringLiteral("interface"), kRateKey = QStringLiteral("bitRate"),
              kWhenKey = QStringLiteral("when");

const QString kLabelGroup = QStringLiteral("labels");

// A PIN's letters may be any printable sign, also one that parts groups in settings.
QString settingOf(const QString& pin) { return QString::fromLatin1(QUrl::toPercentEncoding(pin)); }
QString pinOf(const QString& setting) { return QUrl::fromPercentEncoding(setting.toLatin1()); }

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

QStringList recentLogs() { return QSettings().value(kRecentKey).toStringList(); }

void rememberLog(const QString& path) {
  const QString whole = QFileInfo(path).absoluteFilePath();
  QStringList logs = recentLogs();
  logs.removeAll(whole);
  logs.prepend(whole);
  QSettings().setValue(kRecentKey, logs.mid(0, kMaxRecentLogs));
}

void forgetLogs() { QSettings().remove(kRecentKey); }

QList<KeptLink> recentLinks() {
  QList<KeptLink> links;
  QSettings settings;
  const int count = std::min(settings.beginReadArray(kLinksKey), kMaxRecentLinks);
  for (int i = 0; i < count; ++i) {
    settings.setArrayIndex(i);
    links.append({settings.value(kPluginKey).toString(), settings.value(kInterfaceKey).toString(),
                  settings.value(kRateKey).toInt(), settings.value(kWhenKey).toDateTime()});
  }
  return links;
}

void rememberLink(const KeptLink& link) {
  QList<KeptLink> links = recentLinks();
  links.removeIf([&link](const KeptLink& kept) {
    return kept.plugin == link.plugin && kept.interfaceName == link.interfaceName &&
           kept.bitRate == link.bitRate;
  });
  links.prepend(link);
  QSettings settings;
  settings.beginWriteArray(kLinksKey, static_cast<int>(std::min<qsizetype>(links.size(), kMaxRecentLinks)));
  for (int i = 0; i < links.size() && i < kMaxRecentLinks; ++i) {
    settings.setArrayIndex(i);
    settings.setValue(kPluginKey, links[i].plugin);
    settings.setValue(kInterfaceKey, links[i].interfaceName);
    settings.setValue(kRateKey, links[i].bitRate);
    settings.setValue(kWhenKey, links[i].when);
  }
}

DeviceLabels SettingsLabels::read() const {
  DeviceLabels labels;
  QSettings settings;
  settings.beginGroup(kLabelGroup);
  for (const QString& key : settings.childKeys()) {
    const QByteArray pin = pinOf(key).toLatin1();
    if (const auto parsed = Pin::parse({pin.data(), static_cast<std::size_t>(pin.size())}))
      labels.set(*parsed, settings.value(key).toString());
  }
  return labels;
}

void SettingsLabels::write(const DeviceLabels& labels) {
  QSettings settings;
  settings.beginGroup(kLabelGroup);
  settings.remove(QString());
  for (auto label = labels.all().cbegin(); label != labels.all().cend(); ++label)
    settings.setValue(settingOf(label.key()), label.value());
}

}  // namespace deckpipe
