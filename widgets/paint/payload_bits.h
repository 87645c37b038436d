// SPDX-License-Identifier: GPL-3.0-or-later
// A payload byte by byte and bit by bit, with the bits of one field brought out. The decode panel gives it
// the bytes, the fields' bits and which of them is selected or pointed at; a bit is picked with the mouse or
// the arrow keys.
#pragma once

#include <QLineF>
#include <QPointF>
#include <QRectF>
#include <QSizeF>
#include <QWidget>

#include <array>
#include <cstdint>
#include <vector>

#include "base/bits.h"

namespace deckpipe {

// Where the bits of a payload are drawn: a line a byte as in the manuals' tables, bit 8 at the left, the
// byte's number before it and its two hex digits behind it. Plain numbers, tested without a window.
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

struct PayloadValues {
  Payload bytes{};
  int length = 0;
  // Sets of bits, byte 1 in the lowest eight.
  std::vector<std::uint64_t> fields{};  // lines are drawn between them
  std::uint64_t selected = 0;
  std::uint64_t pointed = 0;  // of the field under the pointer: brought out in place of the selected one
  std::uint64_t related = 0;  // further bits that the value brought out is read from
  std::uint64_t shown() const { return pointed != 0 ? pointed : selected; }
  friend bool operator==(const PayloadValues&, const PayloadValues&) = default;
};

class PayloadBits : public QWidget {
  Q_OBJECT

 public:
  explicit PayloadBits(QWidget* parent = nullptr);

  void setValues(const PayloadValues& values);
  const PayloadValues& values() const { return m_values; }

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 Q_SIGNALS:
  // A set of one bit.
  void bitPicked(std::uint64_t bit);
  // The same of the bit under the pointer; 0 where there is none any more.
  void bitPointed(std::uint64_t bit);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  bool isThere(int bit) const { return bit >= 0 && bit < 8 * m_values.length; }
  void pick(int bit);
  void point(std::uint64_t bit);
  void describe();

  PayloadValues m_values;
  std::uint64_t m_pointed = 0;
  int m_at = 7;  // where the arrow keys are: bit 8 of byte 1
};

}  // namespace deckpipe
