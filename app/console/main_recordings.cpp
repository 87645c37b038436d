// SPDX-License-Identifier: GPL-3.0-or-later
// The main window's recordings: the page, what it is asked for, and the notice at the start.
#include <QFileDialog>
#include <QFileInfo>

#include "log/journal_reader.h"
#include "log_filters.h"
#include "main_window.h"
#include "panel/common/settings_page.h"
#include "panel/connect/recordings_page.h"
#include "recordings_list.h"

namespace deckpipe {

void MainWindow::connectRecordings() {
  const RecordingsPage* page = m_recordings->page();
  connect(page, &RecordingsPage::openRequested, this, [this](const QString& path) {
    openLog(path);
    const auto& notOpened = m_session.snapshot().notOpened;
    if (notOpened && notOpened->isInView) showExtra(nullptr);
  });
  connect(page, &RecordingsPage::saveRequested, this, &MainWindow::saveRecordingByHand);
  connect(page, &RecordingsPage::deleteRequested, this, &MainWindow::deleteRecordingByHand);
  const RecordingLimits limits = recordingLimits();
  m_settings->setRecordingLimits(static_cast<int>(limits.maxBytes >> 20), limits.maxDays);
  connect(m_settings, &SettingsPage::recordingLimitsChosen, this, [](int megabytes, int days) {
    keepRecordingLimits({.maxBytes = static_cast<std::uint64_t>(megabytes) << 20, .maxDays = days});
  });
  if (m_session.recordingFolder().isEmpty()) return;
  // The notice is for the start alone: the status strip says what is recorded from now on.
  connect(
      m_recordings, &RecordingsList::changed, this,
      [this](const std::vector<Recording>& recordings) {
        m_unsavedNotice = m_extra == m_recordings->page() ? Notice{} : unsavedNotice(recordings);
        showSnapshot();
      },
      Qt::SingleShotConnection);
  m_recordings->read();
}

void MainWindow::showRecordings() {
  m_unsavedNotice = {};
  if (!m_session.recordingFolder().isEmpty()) m_recordings->read();
  showExtra(m_recordings->page());
  showSnapshot();
}

void MainWindow::saveRecordingByHand(const QString& path) {
  QFileDialog* dialog = fileDialog(tr("Save a copy of the recording"), {filterOf(kJournalFormat)});
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(suffixOf(filterOf(kJournalFormat)));
  dialog->selectFile(QFileInfo(path).fileName());
  connect(dialog, &QFileDialog::fileSelected, this,
          [this, path](const QString& as) { m_recordings->saveCopy(path, as); });
  dialog->open();
}

void MainWindow::deleteRecordingByHand(const QString& path) {
  ask({"deleteQuestion", tr("Delete a recording"),
       tr("Delete %1? It cannot be brought back.").arg(QFileInfo(path).fileName()), tr("Delete"),
       tr("Cancel")},
      [this, path] { m_recordings->remove(path); });
}

}  // namespace deckpipe
