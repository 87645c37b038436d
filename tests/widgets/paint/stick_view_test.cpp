// SPDX-License-Identifier: GPL-3.0-or-later
#include "paint/stick_view.h"
#include "support/look.h"

#include <gtest/gtest.h>

#include <QImage>

namespace deckpipe {
namespace {

constexpr QRectF kSquare(0, 0, 200, 200);

TEST(StickGeometry, PutsForwardUpAndRightToTheRight) {
  const StickGeometry rest = stickGeometry({0.0, 0.0, false}, kSquare);
  EXPECT_EQ(rest.knob, rest.gate.center());
  const StickGeometry corner = stickGeometry({1.0, 1.0, false}, kSquare);
  EXPECT_NEAR(corner.knob.x(), corner.gate.right(), 1e-9);
  EXPECT_NEAR(corner.knob.y(), corner.gate.top(), 1e-9);
}

TEST(StickGeometry, KeepsTheKnobInsideWhateverIsSaid) {
  for (const double value : {-3.0, -1.0, 1.0, 3.0}) {
    const StickGeometry g = stickGeometry({value, value, false}, kSquare);
    const double r = g.knobRadius;
    EXPECT_TRUE(kSquare.contains(QRectF(g.knob.x() - r, g.knob.y() - r, 2 * r, 2 * r))) << value;
  }
}

int inkPixels(const StickValues& values, Theme theme) {
  const test::Look look(theme);
  StickView view;
  view.setValues(values);
  view.resize(176, 176);
  QImage image(view.size(), QImage::Format_RGB32);
  image.fill(coloursOf(theme).surface);
  view.render(&image, {}, {}, QWidget::DrawChildren);
  int count = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) count += image.pixelColor(x, y) == coloursOf(theme).text;
  return count;
}

TEST(StickView, PaintsASolidKnobForAFreshAndWholePositionOnly) {
  for (const Theme theme : kThemes) {
    EXPECT_GT(inkPixels({0.5, -0.4, false}, theme), 300);
    EXPECT_LT(inkPixels({0.5, -0.4, true}, theme), 20) << "stale";
    EXPECT_LT(inkPixels({0.5, std::nullopt, false}, theme), 20) << "an axis without a value";
  }
}

}  // namespace
}  // namespace deckpipe
