// SPDX-License-Identifier: GPL-3.0-or-later
// The traffic by identifier, sorted as a person likes. In the trace panel; the row that is chosen is a frame
// to look at in detail, a double click or Enter shows these frames in order.
#pragma once

#include <QTableView>

#include "model/id_model.h"

class QSortFilterProxyModel;

namespace deckpipe {

class FlatHeader;

class IdView : public QTableView {
  Q_OBJECT

 public:
  explicit IdView(QWidget* parent = nullptr);

  IdModel* rows() const { return m_rows; }
  void setView(const LogView& view);
  // The last frame of the row that is chosen.
  std::optional<std::uint64_t> currentFrame() const;
  FlatHeader* header() const { return m_header; }
  // Widths, order and which are hidden, for the caller's settings.
  QByteArray saveState() const;
  bool restoreState(const QByteArray& state);
  void resetColumns();

 Q_SIGNALS:
  void currentFrameChanged(std::optional<std::uint64_t> frame);
  void filterRequested(const QString& expression);
  void detailRequested();

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void tellCurrent();
  void updateFonts();

  IdModel* m_rows;
  QSortFilterProxyModel* m_sorted;
  FlatHeader* m_header = nullptr;
  std::optional<std::uint64_t> m_told;
};

}  // namespace deckpipe
