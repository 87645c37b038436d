// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/connect/recordings_page.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

namespace deckpipe {

RecordingsPage::RecordingsPage(QWidget* parent)
    : QWidget(parent),
      m_intro(new QLabel(this)),
      m_list(new QListWidget(this)),
      m_outcome(new QLabel(this)),
      m_open(new QPushButton(tr("Open"), this)),
      m_save(new QPushButton(tr("Save a copy as…"), this)),
      m_delete(new QPushButton(tr("Delete…"), this)) {
  setObjectName(QStringLiteral("recordingsPage"));
  setAccessibleName(tr("Recordings"));
  auto* title = new QLabel(tr("Recordings"), this);
  QFont large = title->font();
  large.setPointSizeF(large.pointSizeF() * 1.5);
  large.setWeight(QFont::DemiBold);
  title->setFont(large);
  for (QLabel* label : {m_intro, m_outcome}) {
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
  }
  m_intro->setObjectName(QStringLiteral("recordingsIntro"));
  m_outcome->setObjectName(QStringLiteral("recordingsOutcome"));
  m_list->setObjectName(QStringLiteral("recordingsList"));
  m_list->setAccessibleName(tr("Recordings"));
  m_list->setSpacing(2);
  m_list->setUniformItemSizes(true);
  m_open->setObjectName(QStringLiteral("recordingOpen"));
  m_save->setObjectName(QStringLiteral("recordingSave"));
  m_delete->setObjectName(QStringLiteral("recordingDelete"));
  auto* done = new QPushButton(tr("Done"), this);
  done->setObjectName(QStringLiteral("recordingsDone"));
  done->setAccessibleName(tr("Close this page"));
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(8);
  for (QPushButton* button : {m_open, m_save, m_delete}) buttons->addWidget(button);
  buttons->addStretch(1);
  buttons->addWidget(done);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(24, 16, 24, 16);
  column->setSpacing(8);
  column->addWidget(title);
  column->addWidget(m_intro);
  column->addWidget(m_list, 1);
  column->addWidget(m_outcome);
  column->addLayout(buttons);

  connect(m_list, &QListWidget::currentRowChanged, this, &RecordingsPage::showButtons);
  connect(m_list, &QListWidget::itemActivated, m_open, &QPushButton::click);
  connect(m_open, &QPushButton::clicked, this, [this] {
    if (const RecordingRow* row = chosen()) Q_EMIT openRequested(row->path);
  });
  connect(m_save, &QPushButton::clicked, this, [this] {
    if (const RecordingRow* row = chosen()) Q_EMIT saveRequested(row->path);
  });
  connect(m_delete, &QPushButton::clicked, this, [this] {
    if (const RecordingRow* row = chosen()) Q_EMIT deleteRequested(row->path);
  });
  connect(done, &QPushButton::clicked, this, &RecordingsPage::closeRequested);
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

void RecordingsPage::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) {
    Q_EMIT closeRequested();
    return;
  }
  QWidget::keyPressEvent(event);
}

}  // namespace deckpipe
