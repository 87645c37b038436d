// SPDX-License-Identifier: GPL-3.0-or-later
// Stands around the panel of each dock. The dock opens as large as the panel likes, and can be made as small
// as a column of tabs: however many docks are open, they never push the window beyond its screen. A panel
// scrolls or squeezes what it has in a place that is too small.
#pragma once

#include <QWidget>

#include "paint/app_style.h"
#include "panel/common/build.h"

namespace deckpipe {

class DockFrame : public QWidget {
 public:
  explicit DockFrame(QWidget* panel) { inColumn(this, {{panel, 1}}); }

  QSize minimumSizeHint() const override { return {kLeastWidth, targetHeight(this)}; }

 private:
  static constexpr int kLeastWidth = 160;
};

}  // namespace deckpipe
