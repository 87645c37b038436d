// SPDX-License-Identifier: GPL-3.0-or-later
// One frame in full: what it says field by field, and on demand its bytes bit by bit. The field that is selected in
// the list, or pointed at, has its bits brought out; a bit that is picked selects its field, and one that is
// pointed at marks it.
#pragma once

#include <QWidget>

#include "model/decode_model.h"
#include "panel/common/panel_view.h"

class QBoxLayout;
class QTableView;
class QToolButton;

namespace deckpipe {

class DecodeDelegate;
class FlatHeader;
class PayloadBits;

class DecodePanel : public QWidget {
  Q_OBJECT

 public:
  explicit DecodePanel(QWidget* parent = nullptr);

  void setView(const PanelView& view);
  DecodeModel* model() const { return m_model; }
  QTableView* list() const { return m_list; }
  PayloadBits* payload() const { return m_payload; }
  // The bits, and which of them each field takes. Folded at first.
  bool areBitsShown() const;
  void showBits(bool areShown);

  QSize sizeHint() const override { return {520, 480}; }

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void layOut();
  void showFrame();
  void tellBits();
  void pick(std::uint64_t bit);
  void point(int row);
  void shareWidth();

  DecodeModel* m_model;
  int m_rowHeight = 0;
  int m_pointed = -1;  // the row under the pointer, or whose bit is
  QBoxLayout* m_layout;
  QWidget* m_around;  // of the bits
  QToolButton* m_fold;
  PayloadBits* m_payload;
  QTableView* m_list;
  FlatHeader* m_header;
  DecodeDelegate* m_delegate;
};

}  // namespace deckpipe
