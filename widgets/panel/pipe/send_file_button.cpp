// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/pipe/send_file_button.h"

#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QLocale>

#include <algorithm>

#include "panel/common/build.h"
#include "panel/pipe/pipe_input.h"

namespace deckpipe {
namespace {

// No control characters but tabs and line ends.
bool isText(const QByteArray& content) {
  return std::ranges::all_of(content, [](char c) {
    return static_cast<unsigned char>(c) >= ' ' || c == '\t' || c == '\r' || c == '\n';
  });
}

// CR LF, CR and LF each end one line.
QByteArray withLineEnds(QByteArray text, const QByteArray& end) {
  return text.replace("\r\n", "\n").replace('\r', '\n').replace("\n", end);
}

std::shared_ptr<const std::string> shared(const QByteArray& content) {
  return std::make_shared<const std::string>(content.constData(), static_cast<std::size_t>(content.size()));
}

}  // namespace

SendFileButton::SendFileButton(const PipeInput& input, QWidget* parent)
    : QPushButton(tr("Send file…"), parent), m_input(input) {
  named(this, "pipeSendFile", text());
  setAutoDefault(false);
  connect(this, &QPushButton::clicked, this, &SendFileButton::choose);
}

void SendFileButton::setView(const PanelView& view) {
  m_view = view;
  m_question.setView(view);
}

void SendFileButton::choose() {
  Q_EMIT failed({});
  auto* dialog = new QFileDialog(this, tr("Send a file to %1").arg(m_view.name));
  dialog->setObjectName(QStringLiteral("pipeFileDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this,
          [this, device = m_view.device, name = m_view.name](const QString& path) {
            confirm(path, device, name);
          });
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
  const QByteArray content = trouble.isEmpty() ? file.readAll() : QByteArray();
  if (trouble.isEmpty() && file.error() != QFileDevice::NoError) trouble = file.errorString();
  if (!trouble.isEmpty()) {
    Q_EMIT failed(tr("%1 cannot be sent: %2").arg(path, trouble));
    return;
  }
  const QByteArray lines = withLineEnds(content, QByteArray::fromStdString(m_input.lineEnd()));
  const bool mayBeLines = lines != content && isText(content);
  PanelView view = m_view;
  view.device = device;  // the one that was chosen for, whatever is looked at now
  m_question.ask(
      this, view,
      {tr("Send a file to %1?").arg(name),
       tr("%1, %2. The device takes the characters as if they had been typed; what they do there "
          "is the device's own affair.")
           .arg(QFileInfo(path).fileName(), QLocale().formattedDataSize(content.size())),
       tr("Send"),
       {},
       mayBeLines ? tr("End each line with %1, as what is typed; otherwise as it is in the file")
                        .arg(m_input.lineEndName())
                  : QString()},
      [this, device, file = QFileInfo(path).fileName().toStdString(), content, lines](bool asLines) {
        Q_EMIT intended(intent::PipeFile{device, file, shared(asLines ? lines : content)});
      });
}

}  // namespace deckpipe
