// SPDX-License-Identifier: GPL-3.0-or-later
// A button of the transport bar: a drawn sign, with or without words, flat and large enough for gloves. Used
// for what moves the cursor through a log. Filled while it is checked.
#pragma once

#include <QAbstractButton>
#include <cstdint>

namespace deckpipe {

class TransportButton : public QAbstractButton {
  Q_OBJECT

 public:
  enum class Sign : std::uint8_t { Play, Pause, StepBack, StepForward, ToEnd, Live, Loop, Skip };

  explicit TransportButton(Sign sign, QWidget* parent = nullptr);

  void setSign(Sign sign);
  Sign sign() const { return m_sign; }
  // Filled: what the button does is what holds now.
  void setOn(bool isOn);
  bool isOn() const { return m_isOn; }
  // Words that may be shown later, so that changing them moves nothing.
  void setWidestText(const QString& text);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Sign m_sign;
  QString m_widest;
  bool m_isOn = false;
};

}  // namespace deckpipe
