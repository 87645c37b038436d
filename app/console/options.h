// SPDX-License-Identifier: GPL-3.0-or-later
// What the command line of deckpipe asks for.
#pragma once

#include <QSize>
#include <QString>
#include <QStringList>
#include <optional>

#include "link/can_link.h"

namespace deckpipe {

struct Options {
  QString logFile;                   // open this log
  bool demo = false;                 // start with the simulator
  std::optional<LinkSettings> link;  // connect to this adapter
  QString theme;                     // light, dark or sunlight; empty = as last time
  QString density;                   // desk or field; empty = as last time
  QString grabFile;                  // save a picture of the window there after grabAfter seconds, and end
  double grabAfter = 5;
  QSize grabSize{1366, 720};  // of that picture, in pixels
};

// Understands the arguments, or says what is wrong (or prints help) and gives the exit status.
std::optional<int> parseOptions(const QStringList& arguments, Options& options);

}  // namespace deckpipe
