// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/connect/recordings_page.h"

#include <QListWidget>
#include <QPushButton>
#include "panel/common/build.h"

namespace deckpipe {

RecordingsPage::RecordingsPage(QWidget* parent)
    : ExtraPage(parent),
      m_intro(makeWords(this, "recordingsIntro", {})),
      m_list(named(new QListWidget(this), "recordingsList", tr("Recordings"))),
      m_outcome(makeWords(this, "recordingsOutcome", {})),
      m_open(makeButton(this, "recordingOpen", tr("Open"))),
      m_save(makeButton(this, "recordingSave", tr("Save a copy as…"))),
      m_delete(makeButton(this, "recordingDelete", tr("Delete…"))) {
  named(this, "recordingsPage", tr("Recordings"));
  m_list->setSpacing(2);
  m_list->setWordWrap(true);
  m_list->setResizeMode(QListView::Adjust);
  m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  QPushButton* done = makeDone("recordingsDone", tr("Close this page"));
  inColumn(this, {24, 16, 24, 16}, 8,
           {makeTitle(this, "recordingsTitle", tr("Recordings")),
            m_intro,
            {m_list, 1},
            m_outcome,
            inRow(8, {m_open, m_save, m_delete, LayoutPart::rest(), done})});

  connect(m_list, &QListWidget::currentRowChanged, this, &RecordingsPage::showButtons);
  connect(m_list, &QListWidget::itemActivated, m_open, &QPushButton::click);
  const auto askFor = [this](QPushButton* button, void (RecordingsPage::*request)(const QString& path)) {
    connect(button, &QPushButton::clicked, this, [this, request] {
      if (const RecordingRow* row = chosen()) (this->*request)(row->path);
    });
  };
  askFor(m_open, &RecordingsPage::openRequested);
  askFor(m_save, &RecordingsPage::saveRequested);
  askFor(m_delete, &RecordingsPage::deleteRequested);
  setReading();
  setOutcome({});
  showButtons();
}

const RecordingRow* RecordingsPage::chosen() const {
  const int row = m_list->currentRow();
  return row >= 0 && row < static_cast<int>(m_rows.size()) ? &m_rows[static_cast<std::size_t>(row)] : nullptr;
}

void RecordingsPage::setRows(const std::vector<RecordingRow>& rows, const QString& folder) {
  m_intro->setText(
      rows.empty() ? tr("Nothing was recorded yet. What is received is written to %1.").arg(folder)
                   : tr("Everything that was received is in %1. What was not saved stays until you delete "
                        "it here; saved ones go when they are old or the folder grows large.")
                         .arg(folder));
  const RecordingRow* before = chosen();
  const QString path = before != nullptr ? before->path : QString();
  m_rows = rows;
  m_list->clear();
  int current = rows.empty() ? -1 : 0;
  for (const RecordingRow& row : rows) {
    if (row.path == path) current = m_list->count();
    m_list->addItem(row.title + QLatin1Char('\n') + row.details);
  }
  m_list->setCurrentRow(current);
  showButtons();
}

void RecordingsPage::setReading() {
  if (m_rows.empty()) m_intro->setText(tr("Looking through the recordings…"));
}

void RecordingsPage::setOutcome(const QString& text) {
  m_outcome->setText(text);
  m_outcome->setVisible(!text.isEmpty());
}

void RecordingsPage::showButtons() {
  const RecordingRow* row = chosen();
  m_open->setEnabled(row != nullptr && row->isReadable);
  m_save->setEnabled(row != nullptr && row->isReadable && !row->isGrowing);
  m_delete->setEnabled(row != nullptr && !row->isGrowing);
}

}  // namespace deckpipe
