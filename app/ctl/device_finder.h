// SPDX-License-Identifier: GPL-3.0-or-later
// Waits on a live bus until the device that was named is heard, asking everyone for their NAME first: Akron's
// devices follow that with their PIN. For subcommands that send, which call it once they are ready.
#pragma once

#include <QElapsedTimer>
#include <vector>

#include "live_run.h"

namespace deckpipe::ctl {

class DeviceFinder {
 public:
  static constexpr int kHearEveryone = 2'000, kPatience = 3'000, kAskAgain = 900;  // ms

  DeviceFinder(LiveRun& run, DeviceName name) : m_run(run), m_name(name) {}
  void begin();
  // Call on every tick until it has found what it can, which ends the run where that is nothing.
  bool hasFound();
  // As they are now. Of --all everyone with an address.
  std::vector<DeviceServices> devices() const;

 private:
  void request();
  QString whyNotFound() const;

  LiveRun& m_run;
  DeviceName m_name;
  QElapsedTimer m_since;
  qint64 m_asked = 0;  // ms since then
  bool m_hasFound = false;
};

// "NAME 90004200280A1C0B"
QString nameText(Name name);

// "1032AE100801035 (6032 Universal II) at address 80"
QString deviceText(const DeviceServices& device);

}  // namespace deckpipe::ctl
