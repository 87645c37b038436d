// SPDX-License-Identifier: GPL-3.0-or-later
#include "misbehave_option.h"

#include <QStringList>
#include <algorithm>
#include <array>
#include <cmath>

namespace deckpipe::ctl {
namespace {

using simulator::Misbehaviour;

// In the order of the standard bench.
constexpr const char* kDevices[] = {"monitor", "riser", "io", "joystick"};

struct Fault {
  const char* word;
  void (*change)(Misbehaviour&);
};
constexpr Fault kFaults[] = {
    {"none", [](Misbehaviour& m) { m = {}; }},
    {"silent", [](Misbehaviour& m) { m.silent = true; }},
    {"wrong-lengths", [](Misbehaviour& m) { m.wrongLengths = true; }},
    {"rotation-sensor-error", [](Misbehaviour& m) { m.rotationSensorError = true; }},
    {"elevation-sensor-error", [](Misbehaviour& m) { m.elevationSensorError = true; }},
    {"not-fitted", [](Misbehaviour& m) { m.feedbackNotFitted = true; }},
    {"address-taken", [](Misbehaviour& m) { m.addressTaken = true; }},
    {"enable-off", [](Misbehaviour& m) { m.enableOff = true; }},
    {"late", [](Misbehaviour& m) { m.late = 150ms; }},
    {"jitter", [](Misbehaviour& m) { m.jitter = 80ms; }},
    {"fuse", [](Misbehaviour& m) { m.faultBits |= simulator::faultBit("internal_fuse"); }},
    {"motor-1", [](Misbehaviour& m) { m.faultBits |= simulator::faultBit("motor_axis_1"); }},
};

template <typename List>
QString words(const List& list) {
  QStringList all;
  for (const auto& entry : list) {
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(entry)>, Fault>) {
      all += QLatin1String(entry.word);
    } else {
      all += QLatin1String(entry);
    }
  }
  return all.join(QStringLiteral(", "));
}

}  // namespace

QString misbehaveHelp() {
  return QStringLiteral("What goes wrong, from when on. DEVICE is one of %1; WHAT is one of %2.")
      .arg(words(kDevices), words(kFaults));
}

bool MisbehavePlan::add(const QString& text) {
  const qsizetype colon = text.indexOf(QLatin1Char(':'));
  const qsizetype at = text.indexOf(QLatin1Char('@'));
  if (colon < 0) return false;
  const QString what = text.mid(colon + 1, at < 0 ? -1 : at - colon - 1);
  bool ok = true;
  const double seconds = at < 0 ? 0 : text.mid(at + 1).toDouble(&ok);
  if (!ok || !(seconds >= 0) || seconds > 1e6) return false;
  const auto device = std::ranges::find_if(
      kDevices, [&](const char* name) { return text.left(colon) == QLatin1String(name); });
  const auto fault =
      std::ranges::find_if(kFaults, [&](const Fault& f) { return what == QLatin1String(f.word); });
  if (device == std::end(kDevices) || fault == std::end(kFaults)) return false;
  m_entries.push_back({Duration(std::llround(seconds * 1e9)),
                       static_cast<std::size_t>(device - std::begin(kDevices)), fault->change});
  return true;
}

void MisbehavePlan::apply(simulator::StandardBench& bench) const {
  std::vector<Entry> inOrder = m_entries;
  std::ranges::stable_sort(inOrder, {}, &Entry::at);
  std::array<Misbehaviour, std::size(kDevices)> now{};
  for (const Entry& entry : inOrder) {
    entry.change(now[entry.device]);
    bench.bench.misbehave(Instant{} + entry.at, entry.device, now[entry.device]);
  }
}

}  // namespace deckpipe::ctl
