// SPDX-License-Identifier: GPL-3.0-or-later
// The main window asks before it leaves a log or quits, if something would be lost.
#include <QCloseEvent>
#include <QMessageBox>
#include <QPushButton>
#include <utility>

#include "kept_settings.h"
#include "main_window.h"
#include "recordings_list.h"
#include "save_bar.h"
#include "status_text.h"

namespace deckpipe {

QString MainWindow::lostMarksText(const UnkeptMarks& marks) {
  return tr("Marks of the open log are in memory alone, and are lost: %1.").arg(unkeptMarksText(marks));
}

// Calls `go` once marks that are being written are in their file, or are known not to be. This takes
// MarkKeeper::kHangs at most.
void MainWindow::onceMarksAreKept(std::function<void()> go) {
  if (!m_snapshot.source.isKeepingMarks) return go();
  m_onceMarksAreKept = std::move(go);
}

// Goes on to another source, at once or after a question.
void MainWindow::leave(std::function<void()> go) {
  if (m_snapshot.source.isKeepingMarks)
    return onceMarksAreKept([this, go = std::move(go)]() mutable { leave(std::move(go)); });
  QStringList lines;
  if (const auto waiting = m_snapshot.services->unconfirmed; waiting > 0) lines << waitingText(waiting);
  if (const auto& marks = m_snapshot.source.unkeptMarks) lines << lostMarksText(*marks);
  if (lines.isEmpty()) return go();
  ask({"leaveQuestion", tr("Leave this log"), lines.join(QLatin1Char('\n')), tr("Leave"), tr("Stay")},
      std::move(go));
}

void MainWindow::ask(const Question& question, std::function<void()> act) {
  auto* box =
      new QMessageBox(QMessageBox::Warning, question.title, question.text, QMessageBox::NoButton, this);
  box->setObjectName(QLatin1String(question.name));
  box->setAttribute(Qt::WA_DeleteOnClose);
  const QPushButton* verb = box->addButton(question.verb, QMessageBox::DestructiveRole);
  box->setDefaultButton(box->addButton(question.otherwise, QMessageBox::RejectRole));
  connect(verb, &QPushButton::clicked, this, std::move(act));
  box->open();
}

void MainWindow::openLog(const QString& path) {
  leave([=, this] { m_session.openLog(path); });
}

void MainWindow::addUpTimes() {
  leave([=, this, path = m_snapshot.source.name] { m_session.openLog(path, Session::TimesOf::Differences); });
}

void MainWindow::openLink(const LinkSettings& link) {
  leave([=, this] { m_session.openLink(link); });
}

void MainWindow::reconnect() {
  leave([this] { m_session.reconnect(); });
}

void MainWindow::openDemo() {
  leave([this] { m_session.openDemo(); });
}

void MainWindow::closeSource() {
  leave([this] {
    m_session.closeSource();
    showSnapshot();
  });
}

// A line for each work that quitting would break off. A recording that the disk takes is kept, and is none of them.
QStringList MainWindow::runningWork() const {
  QStringList work;
  const ServiceStatus& services = *m_snapshot.services;
  if (m_session.holdsUnwritten())
    work << tr("The disk does not take all of a recording: what is in memory alone is lost.");
  if (const auto& marks = m_snapshot.source.unkeptMarks) work << lostMarksText(*marks);
  if (m_recordings->isBusy()) work << tr("A copy of a recording is being saved: it is broken off.");
  if (m_saveBar->isSaving()) work << tr("A log is being saved: what is written of it so far is discarded.");
  for (const DeviceServices& device : services.devices) {
    if (device.pipe && device.pipe->isSendingFile())
      work << tr("A file is being sent: %1. The device has only a part of it then.")
                  .arg(QString::fromStdString(device.pipe->file));
  }
  if (services.unconfirmed > 0) work << waitingText(services.unconfirmed);
  if (!services.locked) work << tr("Sending is unlocked. It is locked on quitting.");
  return work;
}

void MainWindow::quit() {
  m_mayClose = true;
  close();
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (m_snapshot.source.isKeepingMarks) {
    event->ignore();
    return onceMarksAreKept([this] { close(); });
  }
  const QStringList work = m_mayClose ? QStringList() : runningWork();
  if (!work.isEmpty()) {
    event->ignore();
    return ask({"quitQuestion", tr("Quit Deckpipe"), work.join(QLatin1Char('\n')), tr("Quit"), tr("Stay")},
               [this] { quit(); });
  }
  saveLayout();
  QMainWindow::closeEvent(event);
}

}  // namespace deckpipe
