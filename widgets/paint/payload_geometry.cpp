// SPDX-License-Identifier: GPL-3.0-or-later
#include "paint/payload_geometry.h"

#include <algorithm>
#include <cmath>

namespace deckpipe {
namespace {

constexpr double kMinWidth = 18, kMaxWidth = 44;
constexpr double kMinHeight = 17, kMaxHeight = 32;

}  // namespace

PayloadGeometry PayloadGeometry::fitting(QSizeF size) {
  PayloadGeometry g;
  g.cellWidth = std::floor(std::clamp((size.width() - kLeft - kRight) / 8, kMinWidth, kMaxWidth));
  g.cellHeight = std::floor(std::clamp((size.height() - kTop - 1) / kBytes, kMinHeight, kMaxHeight));
  return g;
}

QRectF PayloadGeometry::cell(int bit) const {
  const int column = 7 - bit % 8;
  return {kLeft + column * cellWidth, kTop + bit / 8 * cellHeight, cellWidth, cellHeight};
}

QRectF PayloadGeometry::byteLabel(int byte) const {
  return {0, kTop + byte * cellHeight, kLeft - 8, cellHeight};
}

QRectF PayloadGeometry::hexLabel(int byte) const {
  return {kLeft + 8 * cellWidth + 8, kTop + byte * cellHeight, kRight - 8, cellHeight};
}

QRectF PayloadGeometry::bitLabel(int column) const {
  return {kLeft + column * cellWidth, 0, cellWidth, kTop};
}

int PayloadGeometry::bitAt(QPointF point) const {
  const double x = point.x() - kLeft, y = point.y() - kTop;
  if (x < 0 || y < 0 || x >= 8 * cellWidth || y >= kBytes * cellHeight) return -1;
  return static_cast<int>(y / cellHeight) * 8 + 7 - static_cast<int>(x / cellWidth);
}

std::vector<QLineF> PayloadGeometry::outline(std::uint64_t bits) const {
  std::vector<QLineF> lines;
  const auto has = [bits](int byte, int column) {
    return byte >= 0 && byte < kBytes && column >= 0 && column < 8 &&
           (bits >> (byte * 8 + 7 - column) & 1) != 0;
  };
  for (int byte = 0; byte < kBytes; ++byte) {
    for (int column = 0; column < 8; ++column) {
      if (!has(byte, column)) continue;
      const QRectF r = cell(byte * 8 + 7 - column);
      if (!has(byte - 1, column)) lines.emplace_back(r.topLeft(), r.topRight());
      if (!has(byte + 1, column)) lines.emplace_back(r.bottomLeft(), r.bottomRight());
      if (!has(byte, column - 1)) lines.emplace_back(r.topLeft(), r.bottomLeft());
      if (!has(byte, column + 1)) lines.emplace_back(r.topRight(), r.bottomRight());
    }
  }
  return lines;
}

}  // namespace deckpipe
