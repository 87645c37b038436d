// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/pipe/file_send_bar.h"

#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>

#include <algorithm>

#include "panel/common/build.h"
#include "panel/common/labels.h"
#include "panel/pipe/pipe_input.h"
#include "text/plural.h"
#include "text/service_text.h"
#include "text/time_text.h"

namespace deckpipe {
namespace {

constexpr int kNameLetters = 28;

// Seconds that the file has been going, pauses and stalls left out.
double secondsGone(const PipeStatus& pipe, Instant now) {
  const Instant end = pipe.fileEnded != kNotYet ? pipe.fileEnded : now;
  return static_cast<double>((end - pipe.fileBegan - pipe.filePaused).count()) * 1e-9;
}

double bytesPerSecond(const PipeStatus& pipe, Instant now) {
  const double seconds = secondsGone(pipe, now);
  return pipe.fileSent == 0 || seconds <= 0 ? 0 : static_cast<double>(pipe.fileSent) / seconds;
}

bool hasDoubts(const PipeStatus& pipe) { return pipe.fileSkipped != 0 || pipe.fileResent != 0; }

QString countsText(const PipeStatus& pipe) {
  return FileSendBar::tr("%n packets skipped, %1 sent again", nullptr, forPlural(pipe.fileSkipped))
      .arg(pipe.fileResent);
}

// A longer time says only that hardly anything has gone out yet.
constexpr double kLongestTold = 7 * 24 * 3600;  // s

// What was skipped or sent again may be missing, or be there twice.
QString doneText(const PipeStatus& pipe) {
  if (!hasDoubts(pipe)) return FileSendBar::tr("Sent");
  return FileSendBar::tr("Gone through, but %n packets skipped and %1 sent again: what arrived is not known",
                         nullptr, forPlural(pipe.fileSkipped))
      .arg(pipe.fileResent);
}

}  // namespace

QString rateText(const PipeStatus& pipe, Instant now) {
  const double rate = bytesPerSecond(pipe, now);
  if (rate <= 0) return {};
  if (rate < 1000) return FileSendBar::tr("%1 B/s").arg(QLocale().toString(rate, 'f', 0));
  return FileSendBar::tr("%1 kB/s").arg(QLocale().toString(rate / 1000, 'f', 1));
}

QString timeLeftText(const PipeStatus& pipe, Instant now) {
  const double rate = bytesPerSecond(pipe, now);
  if (rate <= 0 || !pipe.isSendingFile()) return {};
  const double seconds = static_cast<double>(pipe.fileSize - pipe.fileSent) / rate;
  if (seconds > kLongestTold) return {};
  return FileSendBar::tr("about %1 left")
      .arg(briefAge(Duration(static_cast<std::int64_t>(seconds) * 1'000'000'000)));
}

FileSendBar::FileSendBar(QWidget* parent)
    : QWidget(parent),
      m_name(named(new ElidedLabel(this, Qt::ElideMiddle), "fileName", tr("File that is sent"))),
      m_progress(named(new QProgressBar(this), "fileProgress", tr("How much of the file was acknowledged"))),
      m_figures(named(new ElidedLabel(this), "fileFigures", tr("Rate, time left and acks"))),
      m_pause(makeButton(this, "filePause", tr("Pause"))),
      m_cancel(makeButton(this, "fileCancel", tr("Cancel file"))) {
  named(this, "fileSendBar", tr("Sending a file"));
  m_name->setMaximumWidth(kNameLetters * fontMetrics().averageCharWidth());
  m_progress->setRange(0, 1000);
  inRow(this, {m_name, {m_progress, 1}, m_figures, m_pause, m_cancel});
  connect(m_pause, &QPushButton::clicked, this, [this] { Q_EMIT pauseRequested(!m_isPaused); });
  connect(m_cancel, &QPushButton::clicked, this, &FileSendBar::cancelRequested);
  hide();
}

void FileSendBar::setStatus(const PipeStatus& pipe, Instant now, bool isLive) {
  setVisible(!pipe.file.empty());
  if (pipe.file.empty()) return;
  const QLocale locale;
  setText(*m_name, QString::fromStdString(pipe.file));
  m_name->setToolTip(m_name->text());
  m_progress->setValue(pipe.fileSize == 0 ? 1000 : static_cast<int>(1000 * pipe.fileSent / pipe.fileSize));
  QStringList parts{tr("%1 of %Ln bytes", nullptr, forPlural(pipe.fileSize))
                        .arg(locale.toString(static_cast<qulonglong>(pipe.fileSent)))};
  switch (pipe.fileEnd) {
    case PipeStatus::FileEnd::None: break;
    case PipeStatus::FileEnd::Done: parts.prepend(doneText(pipe)); break;
    case PipeStatus::FileEnd::Cancelled: parts.prepend(tr("Cancelled")); break;
    case PipeStatus::FileEnd::Aborted: parts.prepend(tr("Given up")); break;
    case PipeStatus::FileEnd::Restarted: parts.prepend(tr("Stopped: the device restarted")); break;
  }
  if (pipe.isSendingFile() && pipe.rest != PipeStatus::Rest::Ask) {
    parts.prepend(restText(pipe));
  } else if (pipe.fileEnd != PipeStatus::FileEnd::Done && hasDoubts(pipe)) {
    parts.append(countsText(pipe));
  }
  m_isPaused = pipe.isPaused && pipe.isSendingFile();
  if (m_isPaused) parts.prepend(tr("Paused"));
  // Neither is known while it waits.
  if (!m_isPaused && pipe.progress != PipeStatus::Progress::Stalled) {
    for (const QString& part : {rateText(pipe, now), timeLeftText(pipe, now)}) {
      if (!part.isEmpty()) parts.append(part);
    }
  }
  if (pipe.acks > 0)
    parts.append(tr("acks %1, worst %2").arg(periodText(pipe.ackSum / pipe.acks), periodText(pipe.ackWorst)));
  setText(*m_figures, parts.join(QStringLiteral(" · ")));
  m_figures->setToolTip(m_figures->text());
  m_pause->setText(m_isPaused ? tr("Go on") : tr("Pause"));
  m_pause->setAccessibleName(m_pause->text());
  m_pause->setEnabled(isLive || !m_isPaused);
  m_pause->setVisible(pipe.isSendingFile());
  m_cancel->setVisible(pipe.isSendingFile());
}

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
