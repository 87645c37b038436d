// SPDX-License-Identifier: GPL-3.0-or-later
// One adapter on the connection page: its name, how it stands, what to do about that, and a button to
// connect.
#pragma once

#include <QWidget>

#include "panel/connect/adapter_offer.h"

class QLabel;
class QPushButton;

namespace deckpipe {

class GlyphLabel;

class AdapterRow : public QWidget {
  Q_OBJECT

 public:
  explicit AdapterRow(QWidget* parent = nullptr);

  void setOffer(const AdapterOffer& offer);
  const AdapterOffer& offer() const { return m_offer; }

 Q_SIGNALS:
  void connectRequested();

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  AdapterOffer m_offer;
  GlyphLabel* m_sign;
  QLabel* m_title;
  QLabel* m_maker;
  QLabel* m_state;
  QLabel* m_problem;
  QLabel* m_command;
  QPushButton* m_copy;
  QPushButton* m_connect;
};

}  // namespace deckpipe
