// SPDX-License-Identifier: GPL-3.0-or-later
// Where the bits of a payload are drawn: a line a byte as in the manuals' tables, bit 8 at the left, the
// byte's number before it and its two hex digits behind it. Plain numbers, tested without a window.
#pragma once

#include <QLineF>
#include <QPointF>
#include <QRectF>
#include <QSizeF>
#include <cstdint>
#include <vector>

namespace deckpipe {

struct PayloadGeometry {
  static constexpr int kBytes = 8;
  static constexpr double kTop = 22;    // the bits' numbers
  static constexpr double kLeft = 36;   // the bytes' numbers
  static constexpr double kRight = 48;  // the bytes in hex

  double cellWidth = 28;
  double cellHeight = 21;

  // Cells as large as fit, within reason.
  static PayloadGeometry fitting(QSizeF size);
  QSizeF size() const { return {kLeft + 8 * cellWidth + kRight, kTop + kBytes * cellHeight + 1}; }

  // Bits as in a set with byte 1 in the lowest eight: bit 0 is the lowest of byte 1.
  QRectF cell(int bit) const;
  QRectF byteLabel(int byte) const;
  QRectF hexLabel(int byte) const;
  QRectF bitLabel(int column) const;
  // -1 beside the cells.
  int bitAt(QPointF point) const;

  // The lines around a set of bits, bits that touch as one shape.
  std::vector<QLineF> outline(std::uint64_t bits) const;
};

}  // namespace deckpipe
