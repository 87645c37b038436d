// SPDX-License-Identifier: GPL-3.0-or-later
// The strip across the top of the window: where the frames come from, how that goes, and how much there is.
#pragma once

#include <QWidget>

#include "paint/palette.h"
#include "session/snapshot.h"

class QLabel;

namespace deckpipe {

class StatusStrip : public QWidget {
  Q_OBJECT
 public:
  explicit StatusStrip(QWidget* parent = nullptr);

  void setColours(const Colours& colours);
  void setSnapshot(const Snapshot& snapshot);

  // The sentences, for the strip and for tests.
  static QString sourceText(const SourceStatus& source);
  static QString countsText(const Snapshot& snapshot);

 private:
  class Lamp;
  Lamp* m_lamp;
  QLabel* m_source;
  QLabel* m_counts;
};

}  // namespace deckpipe
