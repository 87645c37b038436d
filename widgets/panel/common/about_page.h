// SPDX-License-Identifier: GPL-3.0-or-later
// What this program is: version, licence, what it is built on, where it keeps things, and which manuals its
// words come from. The console says the facts it knows.
#pragma once

#include "panel/common/build.h"

namespace deckpipe {

struct AboutFacts {
  QString version{};
  QString settingsPath{};
  QString spillFolder{};  // where a log larger than memory goes
};

class AboutPage : public ExtraPage {
  Q_OBJECT

 public:
  explicit AboutPage(const AboutFacts& facts, QWidget* parent = nullptr);
};

}  // namespace deckpipe
