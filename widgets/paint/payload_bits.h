// SPDX-License-Identifier: GPL-3.0-or-later
// A payload byte by byte and bit by bit, with the bits of one field brought out. The decode panel gives it
// the bytes, the fields' bits and which of them is selected or pointed at; a bit is picked with the mouse or
// the arrow keys.
#pragma once

#include <QWidget>
#include <array>
#include <cstdint>
#include <vector>

#include "base/bits.h"
#include "paint/payload_geometry.h"

namespace deckpipe {

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
