// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/send_file_button.h"

#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QLocale>

#include "panel/danger_dialog.h"

namespace deckpipe {

SendFileButton::SendFileButton(QWidget* parent) : QPushButton(tr("Send file…"), parent) {
  setObjectName(QStringLiteral("pipeSendFile"));
  setAccessibleName(text());
  setAutoDefault(false);
  connect(this, &QPushButton::clicked, this, &SendFileButton::choose);
}

void SendFileButton::setDevice(const DeviceKey& device, const QString& name) {
  m_device = device;
  m_name = name;
}

void SendFileButton::choose() {
  Q_EMIT failed({});
  auto* dialog = new QFileDialog(this, tr("Send a file to %1").arg(m_name));
  dialog->setObjectName(QStringLiteral("pipeFileDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this,
          [this, device = m_device, name = m_name](const QString& path) { confirm(path, device, name); });
  dialog->open();
}

void SendFileButton::confirm(const QString& path, const DeviceKey& device, const QString& name) {
  QFile file(path);
  QString trouble;
  if (!file.open(QIODevice::ReadOnly)) {
    trouble = file.errorString();
  } else if (file.size() > kLargest) {
    trouble = tr("It is larger than %1.").arg(QLocale().formattedDataSize(kLargest));
  }
  if (!trouble.isEmpty()) {
    Q_EMIT failed(tr("%1 cannot be sent: %2").arg(path, trouble));
    return;
  }
  const QByteArray content = file.readAll();
  const wish::PipeFile wanted{
      device, QFileInfo(path).fileName().toStdString(),
      std::make_shared<const std::string>(content.constData(), static_cast<std::size_t>(content.size()))};
  DangerDialog::ask(
      this,
      {tr("Send a file to %1?").arg(name),
       tr("%1, %2. The device takes the characters as if they had been typed; what they do there "
          "is the device's own affair.")
           .arg(QFileInfo(path).fileName(), QLocale().formattedDataSize(content.size())),
       tr("Send")},
      [this, wanted] { Q_EMIT wished(wanted); });
}

}  // namespace deckpipe
