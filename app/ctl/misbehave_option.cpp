// SPDX-License-Identifier: GPL-3.0-or-later
#include "misbehave_option.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace deckpipe::ctl {
namespace {

using Button = simulator::Simulator::Button;

// In the order of the standard simulator; more monitors follow them.
constexpr const char* kDevices[] = {"monitor", "riser", "io", "joystick"};

// Buttons rather than misbehaviours: they happen once.
constexpr const char *kOff = "off", *kOn = "on", *kReset = "reset";
constexpr MisbehaveWord kOffFor{kOff, "", nullptr, MisbehaveWord::Takes::Milliseconds, 0, 86'400'000};

}  // namespace

QString misbehaveTable() {
  QString text = QStringLiteral(
      "--misbehave DEVICE:WHAT[=VALUE][@SECONDS]\n\n"
      "DEVICE is monitor, riser, io, joystick or all; with --monitors also monitor-2, monitor-3 …\n"
      "SECONDS count from power-on. What is wrong with one device adds up.\n\n"
      "WHAT, with MS in milliseconds:\n");
  const auto line = [&](const QString& what, const char* help) {
    text += QStringLiteral("  %1 %2\n").arg(what, -28).arg(QString::fromUtf8(help));
  };
  line(QStringLiteral("off[=MS]"), "power off, for good or for so long");
  line(QStringLiteral("on"), "power on");
  line(QStringLiteral("reset"), "as by message 45");
  for (const MisbehaveWord& word : misbehaveWords()) {
    line(QLatin1String(word.word) + valueHelp(word), word.help);
    if (word.leftOut == 0) continue;
    text.chop(1);
    text += word.takes == MisbehaveWord::Takes::Losses
                ? QStringLiteral("; all by default\n")
                : QStringLiteral("; %1 by default\n").arg(word.leftOut);
  }
  return text;
}

std::vector<std::size_t> MisbehavePlan::devicesOf(const QString& name) const {
  if (name == QLatin1String("all")) {
    std::vector<std::size_t> all(std::size(kDevices) + m_monitors - 1);
    std::iota(all.begin(), all.end(), 0u);
    return all;
  }
  const auto device = std::ranges::find_if(kDevices, [&](const char* d) { return name == QLatin1String(d); });
  if (device != std::end(kDevices)) return {static_cast<std::size_t>(device - std::begin(kDevices))};
  const QString another = QStringLiteral("monitor-");
  if (!name.startsWith(another)) return {};
  bool ok = false;
  const unsigned number = QStringView(name).mid(another.size()).toUInt(&ok);
  if (!ok || number < 1 || number > m_monitors) return {};
  return {number == 1 ? 0u : std::size(kDevices) + number - 2};
}

bool MisbehavePlan::add(const QString& text) {
  const qsizetype colon = text.indexOf(QLatin1Char(':'));
  const qsizetype at = text.indexOf(QLatin1Char('@'));
  if (colon < 0) return false;
  Entry entry;
  entry.devices = devicesOf(text.left(colon));
  bool ok = true;
  const double seconds = at < 0 ? 0 : text.mid(at + 1).toDouble(&ok);
  if (!ok || !(seconds >= 0) || seconds > 1e6 || entry.devices.empty()) return false;
  entry.at = Duration(std::llround(seconds * 1e9));
  const QString what = text.mid(colon + 1, at < 0 ? -1 : at - colon - 1);
  const qsizetype equals = what.indexOf(QLatin1Char('='));
  const QString value = equals < 0 ? QString() : what.mid(equals + 1);
  return addWhat(std::move(entry), equals < 0 ? what : what.left(equals),
                 equals >= 0 && value.isNull() ? QLatin1String("") : value);
}

bool MisbehavePlan::addWhat(Entry entry, const QString& what, const QString& value) {
  const auto press = [&](Button button, Duration later = Duration{0}) {
    Entry pressed = entry;
    pressed.button = button;
    pressed.at += later;
    m_entries.push_back(std::move(pressed));
    return true;
  };
  if (what == QLatin1String(kOff)) {
    if (value.isNull()) return press(Button::PowerOff);
    const auto away = valueFor(kOffFor, value);
    return away && press(Button::PowerOff) && press(Button::PowerOn, away->milliseconds());
  }
  if (value.isNull() && what == QLatin1String(kOn)) return press(Button::PowerOn);
  if (value.isNull() && what == QLatin1String(kReset)) return press(Button::Reset);
  entry.word = misbehaveWord(what);
  const auto number = entry.word == nullptr ? std::nullopt : valueFor(*entry.word, value);
  if (!number) return false;
  entry.value = *number;
  m_entries.push_back(std::move(entry));
  return true;
}

void MisbehavePlan::apply(simulator::StandardSimulator& simulator) const {
  std::vector<Entry> inOrder = m_entries;
  std::ranges::stable_sort(inOrder, {}, &Entry::at);
  std::vector<simulator::Misbehaviour> now(simulator.simulator.size());
  for (const Entry& entry : inOrder) {
    const Instant when = Instant{} + entry.at;
    for (const std::size_t device : entry.devices) {
      if (entry.word == nullptr) {
        simulator.simulator.press(when, device, entry.button);
      } else {
        entry.word->change(now[device], entry.value);
        simulator.simulator.misbehave(when, device, now[device]);
      }
    }
  }
}

}  // namespace deckpipe::ctl
