// SPDX-License-Identifier: GPL-3.0-or-later
// What can be chosen by pointing at a cell of the trace, or at the titles of its columns.
#include <QActionGroup>
#include <QApplication>
#include <QClipboard>
#include <QMenu>

#include "log/log_format.h"
#include "model/cell_filters.h"
#include "panel/trace/id_view.h"
#include "panel/trace/trace_panel.h"

namespace deckpipe {

void TracePanel::showCellMenu(std::optional<TraceView::Cell> cell, const QPoint& global) {
  auto* menu = new QMenu(this);
  menu->setObjectName(QStringLiteral("traceMenu"));
  menu->setAttribute(Qt::WA_DeleteOnClose);
  if (cell) {
    QMenu* hide = new QMenu(tr("Hide"), menu);
    menu->addSection(tr("Show only"));
    for (const CellFilter& filter : cellFilters(*m_model->view().document, cell->frame, cell->column)) {
      QString what = filter.what;
      what.replace(u'&', QLatin1String("&&"));
      menu->addAction(what, this, [this, filter] { setFilter(narrowed(m_expression, filter.expression)); });
      hide->addAction(what, this, [this, filter] { setFilter(reduced(m_expression, filter.expression)); });
    }
    menu->addMenu(hide);
    if (m_model->isFiltered()) menu->addAction(tr("Show all"), this, [this] { setFilter({}); });
    menu->addSeparator();
    menu->addAction(tr("In detail"), this, &TracePanel::detailRequested)->setShortcut(Qt::Key_Space);
    menu->addAction(tr("Put the cursor here"), this,
                    [this, frame = cell->frame] { Q_EMIT cursorRequested(frame); });
    if (cell->column >= 0) {
      const QModelIndex at = m_view->indexOfFrame(cell->frame, cell->column);
      if (const QString text = at.data().toString(); !text.isEmpty())
        menu->addAction(tr("Copy the cell"), this, [text] { QApplication::clipboard()->setText(text); });
    }
  }
  const std::string format(formatToWrite({}).name);
  QAction* copy =
      menu->addAction(tr("Copy as %1 text").arg(QString::fromStdString(format)), m_view, &TraceView::copy);
  copy->setShortcut(QKeySequence::Copy);
  copy->setEnabled(hasSelection());
  menu->addSeparator();
  menu->addAction(tr("Save the selection…"), this, &TracePanel::saveSelection)->setEnabled(hasSelection());
  if (isFiltered()) menu->addAction(tr("Save all that passes the filter…"), this, &TracePanel::saveShown);
  menu->popup(global);
}

// The same for the rows in order and by identifier.
void TracePanel::showColumnMenu(FlatHeader& header, const QPoint& at) {
  auto* menu = new QMenu(this);
  menu->setObjectName(QStringLiteral("traceColumnMenu"));
  menu->setAttribute(Qt::WA_DeleteOnClose);
  if (&header == m_view->header()) {
    menu->addSection(tr("How the Time column says time"));
    auto* modes = new QActionGroup(menu);
    for (int mode = 0; mode < static_cast<int>(TraceModel::TimeMode::Count); ++mode) {
      const auto what = static_cast<TraceModel::TimeMode>(mode);
      QAction* action =
          menu->addAction(TraceModel::modeText(what), this, [this, mode] { setTimeMode(mode); });
      action->setCheckable(true);
      action->setChecked(what == m_model->timeMode());
      modes->addAction(action);
    }
    menu->addSection(tr("Columns"));
  }
  const bool isLast = header.count() - header.hiddenSectionCount() == 1;
  for (int column = 0; column < header.count(); ++column) {
    QAction* action = menu->addAction(header.model()->headerData(column, Qt::Horizontal).toString());
    action->setCheckable(true);
    action->setChecked(!header.isSectionHidden(column));
    action->setEnabled(!isLast || header.isSectionHidden(column));  // one at least stays
    connect(action, &QAction::toggled, this, [this, &header, column](bool isShown) {
      if (&header == m_view->header()) {
        m_view->setColumnShown(column, isShown);
      } else {
        header.setSectionHidden(column, !isShown);
      }
    });
  }
  menu->addSeparator();
  menu->addAction(tr("Columns as they were"), this, [this, &header] {
    if (&header == m_view->header()) {
      m_view->resetColumns();
    } else {
      m_ids->resetColumns();
    }
  });
  menu->popup(header.mapToGlobal(at));
}

}  // namespace deckpipe
