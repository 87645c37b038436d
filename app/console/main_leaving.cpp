// SPDX-License-Identifier: GPL-3.0-or-later
// The main window asks before it leaves a log or quits, if something would be lost.
#include <QCloseEvent>
#include <QMessageBox>
#include <QPushButton>
#include <utility>

#include "main_window.h"
#include "recordings_list.h"
#include "save_bar.h"

namespace deckpipe {

QString MainWindow::lostMarksText(const QString& why) {
  return tr("Marks of the open log are in memory alone, and are lost: %1.").arg(why);
}

// Goes on to another source, at once or after a question.
void MainWindow::leave(std::function<void()> go) {
  const auto& why = m_snapshot.source.unkeptMarks;
  if (!why) return go();
  auto* question = new QMessageBox(QMessageBox::Warning, tr("Leave this log"), lostMarksText(*why),
                                   QMessageBox::NoButton, this);
  question->setObjectName(QStringLiteral("leaveQuestion"));
  question->setAttribute(Qt::WA_DeleteOnClose);
  const QPushButton* leave = question->addButton(tr("Leave"), QMessageBox::DestructiveRole);
  question->setDefaultButton(question->addButton(tr("Stay"), QMessageBox::RejectRole));
  connect(leave, &QPushButton::clicked, this, std::move(go));
  question->open();
}

void MainWindow::openDemo() {
  leave([this] { m_session.openDemo(); });
}

// Quitting would break these off; a line each. A recording that the disk takes is kept, and is not among them.
QStringList MainWindow::runningWork() const {
  QStringList work;
  const ServiceStatus& services = *m_snapshot.services;
  if (m_session.holdsUnwritten())
    work << tr("The disk does not take all of a recording: what is in memory alone is lost.");
  if (const auto& why = m_snapshot.source.unkeptMarks) work << lostMarksText(*why);
  if (m_recordings->isBusy()) work << tr("A copy of a recording is being saved: it is broken off.");
  if (m_saveBar->isSaving()) work << tr("A log is being saved: what is written of it so far is discarded.");
  for (const DeviceServices& device : services.devices) {
    if (device.pipe && device.pipe->isSendingFile())
      work << tr("A file is being sent: %1. The device has only a part of it then.")
                  .arg(QString::fromStdString(device.pipe->file));
  }
  if (!services.locked) work << tr("Sending is unlocked. It is locked on quitting.");
  return work;
}

void MainWindow::closeEvent(QCloseEvent* event) {
  const QStringList work = m_mayClose ? QStringList() : runningWork();
  if (!work.isEmpty()) {
    event->ignore();
    auto* question = new QMessageBox(QMessageBox::Warning, tr("Quit Deckpipe"), work.join(QLatin1Char('\n')),
                                     QMessageBox::NoButton, this);
    question->setObjectName(QStringLiteral("quitQuestion"));
    question->setAttribute(Qt::WA_DeleteOnClose);
    const QPushButton* quit = question->addButton(tr("Quit"), QMessageBox::DestructiveRole);
    question->setDefaultButton(question->addButton(tr("Stay"), QMessageBox::RejectRole));
    connect(quit, &QPushButton::clicked, this, [this] {
      m_mayClose = true;
      close();
    });
    return question->open();
  }
  saveLayout();
  QMainWindow::closeEvent(event);
}

}  // namespace deckpipe
