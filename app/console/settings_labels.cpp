// SPDX-License-Identifier: GPL-3.0-or-later
#include "settings_labels.h"

#include <QSettings>
#include <QUrl>

namespace deckpipe {
namespace {

const QString kGroup = QStringLiteral("labels");

// A PIN's letters may be any printable sign, also one that parts groups in settings.
QString settingOf(const QString& pin) { return QString::fromLatin1(QUrl::toPercentEncoding(pin)); }
QString pinOf(const QString& setting) { return QUrl::fromPercentEncoding(setting.toLatin1()); }

}  // namespace

DeviceLabels SettingsLabels::read() const {
  DeviceLabels labels;
  QSettings settings;
  settings.beginGroup(kGroup);
  for (const QString& key : settings.childKeys()) {
    const QByteArray pin = pinOf(key).toLatin1();
    if (const auto parsed = Pin::parse({pin.data(), static_cast<std::size_t>(pin.size())}))
      labels.set(*parsed, settings.value(key).toString());
  }
  return labels;
}

void SettingsLabels::write(const DeviceLabels& labels) {
  QSettings settings;
  settings.beginGroup(kGroup);
  settings.remove(QString());
  for (auto label = labels.all().cbegin(); label != labels.all().cend(); ++label)
    settings.setValue(settingOf(label.key()), label.value());
}

}  // namespace deckpipe
