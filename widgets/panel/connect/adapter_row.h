// SPDX-License-Identifier: GPL-3.0-or-later
// One adapter on the connection page: its name, how it stands, what to do about that, and a button to
// connect.
#pragma once

#include <QString>
#include <QWidget>

#include <vector>

#include "panel/common/status_cell.h"

class QLabel;
class QPushButton;

namespace deckpipe {

// An adapter as the connection page offers it: in words, with what stands in the way and how to mend it.
// Filled in by the console, which knows the adapters.
struct AdapterOffer {
  QString plugin{};
  QString interfaceName{};
  QString title{};  // "can0"
  QString maker{};  // "SocketCAN", "PEAK-System · PCAN-USB · 12345"
  Severity tone = Severity::Plain;
  QString state{};    // "up at 250 kbit/s, listen-only; frames are heard"
  QString problem{};  // what to do first, if anything
  QString command{};  // … in a terminal
  bool canConnect = true;
  bool isVirtual = false;  // no truck is on it
  friend bool operator==(const AdapterOffer&, const AdapterOffer&) = default;
};

struct AdapterOffers {
  std::vector<AdapterOffer> adapters{};
  QString missing{};  // what cannot be used here and why, a line each
  QString nothing{};  // instead of adapters, where there are none
  QString command{};  // … and what to type
  bool isSearching = false;
  friend bool operator==(const AdapterOffers&, const AdapterOffers&) = default;
};

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
