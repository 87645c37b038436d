// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/terminal_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QFontDatabase>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSaveFile>
#include <QScrollBar>
#include <QVBoxLayout>
#include <algorithm>

#include "panel/danger_dialog.h"
#include "panel/file_send_bar.h"
#include "panel/label_ink.h"
#include "panel/secondary_font.h"
#include "text/service_text.h"

namespace deckpipe {
namespace {

constexpr int kLeastText = 48;
constexpr int kMostBlocks = 20'000;
constexpr qint64 kLargestFile = 8 << 20;  // at some hundred bytes a second more would take days

}  // namespace

TerminalPanel::TerminalPanel(QWidget* parent)
    : QWidget(parent),
      m_colours(coloursOf(Theme::Light)),
      m_caution(new QLabel(this)),
      m_text(new QPlainTextEdit(this)),
      m_file(new FileSendBar(this)) {
  setObjectName(QStringLiteral("terminalPanel"));
  setAccessibleName(tr("Data pipe terminal"));
  m_caution->setObjectName(QStringLiteral("pipeCaution"));
  m_caution->setText(
      tr("The manual calls the data pipe “simplistic”, “not appropriate for control-related "
         "messaging” and “not available for integrator use”."));
  m_caution->setAccessibleName(m_caution->text());
  m_caution->setWordWrap(true);
  m_caution->setFont(secondaryFont(font()));
  m_text->setObjectName(QStringLiteral("pipeText"));
  m_text->setAccessibleName(tr("What went through the data pipe"));
  m_text->setReadOnly(true);
  m_text->setMinimumHeight(kLeastText);
  m_text->setUndoRedoEnabled(false);
  m_text->setMaximumBlockCount(kMostBlocks);
  m_text->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  m_text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  m_text->installEventFilter(this);

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 6, 8, 6);
  layout->setSpacing(6);
  layout->addWidget(m_caution);
  layout->addWidget(makeHint());
  layout->addWidget(makeStallBar());
  layout->addWidget(m_text, 1);
  layout->addWidget(m_file);
  layout->addWidget(makeInput());
  layout->addWidget(makeTools());
  connect(m_file, &FileSendBar::pauseRequested, this, [this](bool pause) {
    act(pause ? wish::PipeAction::What::Pause : wish::PipeAction::What::Resume);
  });
  connect(m_file, &FileSendBar::cancelRequested, this, [this] { act(wish::PipeAction::What::Cancel); });
  setFocusProxy(m_input);
  setColours(m_colours);
  showState();
}

QPushButton* TerminalPanel::makeButton(const char* name, const QString& text) {
  auto* button = new QPushButton(text, this);
  button->setObjectName(QString::fromLatin1(name));
  button->setAccessibleName(text);
  button->setAutoDefault(false);
  return button;
}

QWidget* TerminalPanel::makeHint() {
  m_hintBar = new QWidget(this);
  m_hint = new QLabel(m_hintBar);
  m_hint->setObjectName(QStringLiteral("pipeHint"));
  m_hint->setAccessibleName(tr("Why nothing can be sent"));
  m_hint->setWordWrap(true);
  m_unlock = makeButton("pipeUnlock", tr("Unlock…"));
  connect(m_unlock, &QPushButton::clicked, this, &TerminalPanel::unlockRequested);
  auto* row = new QHBoxLayout(m_hintBar);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(m_hint, 1);
  row->addWidget(m_unlock);
  return m_hintBar;
}

QWidget* TerminalPanel::makeStallBar() {
  m_stallBar = new QWidget(this);
  m_stallBar->setObjectName(QStringLiteral("pipeStall"));
  m_stall = new QLabel(m_stallBar);
  m_stall->setObjectName(QStringLiteral("pipeStallText"));
  m_stall->setAccessibleName(tr("Why sending stopped"));
  m_stall->setWordWrap(true);
  auto* row = new QHBoxLayout(m_stallBar);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(m_stall, 1);
  const auto add = [&](const char* name, const QString& text, const QString& tip,
                       wish::PipeAction::What what) {
    QPushButton* button = makeButton(name, text);
    button->setToolTip(tip);
    row->addWidget(button);
    connect(button, &QPushButton::clicked, this, [this, what] { act(what); });
    return button;
  };
  m_resend =
      add("pipeResend", tr("Resend"), tr("The packet once more. If only its ack was lost, it arrives twice."),
          wish::PipeAction::What::Resend);
  m_skip =
      add("pipeSkip", tr("Skip"), tr("Goes on as if the packet had arrived."), wish::PipeAction::What::Skip);
  add("pipeAbort", tr("Abort"), tr("Sends nothing more of what waits."), wish::PipeAction::What::Abort);
  return m_stallBar;
}

QWidget* TerminalPanel::makeInput() {
  auto* widget = new QWidget(this);
  m_mode = new QComboBox(widget);
  m_mode->setObjectName(QStringLiteral("pipeMode"));
  m_mode->setAccessibleName(tr("How typing is sent"));
  m_mode->addItems({tr("Lines"), tr("Every key")});
  m_mode->setToolTip(
      tr("Lines: what is typed goes with Enter. Every key: each goes at once; Ctrl+[ sends ESC."));
  m_input = new QLineEdit(widget);
  m_input->setObjectName(QStringLiteral("pipeInput"));
  m_input->setAccessibleName(tr("Characters to send"));
  m_input->setFont(m_text->font());
  m_input->installEventFilter(this);
  m_lineEnd = new QComboBox(widget);
  m_lineEnd->setObjectName(QStringLiteral("pipeLineEnd"));
  m_lineEnd->setAccessibleName(tr("Line end"));
  m_lineEnd->addItems({tr("CR LF"), tr("CR"), tr("LF"), tr("No line end")});
  m_send = makeButton("pipeSend", tr("Send"));
  m_sendFile = makeButton("pipeSendFile", tr("Send file…"));
  m_mode->installEventFilter(this);
  m_lineEnd->installEventFilter(this);
  auto* row = new QHBoxLayout(widget);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(m_mode);
  row->addWidget(m_input, 1);
  row->addWidget(m_lineEnd);
  row->addWidget(m_send);
  row->addWidget(m_sendFile);
  m_more = makeButton("pipeMore", tr("More"));
  m_more->setCheckable(true);
  m_more->setToolTip(tr("What is shown, search, and saving"));
  row->addWidget(m_more);
  connect(m_more, &QPushButton::toggled, this, [this](bool isOn) { m_tools->setVisible(isOn); });
  connect(m_input, &QLineEdit::returnPressed, this, &TerminalPanel::sendLine);
  connect(m_send, &QPushButton::clicked, this, &TerminalPanel::sendLine);
  connect(m_sendFile, &QPushButton::clicked, this, &TerminalPanel::chooseFile);
  connect(m_mode, &QComboBox::activated, this, [this] {
    showState();
    m_input->setFocus();
  });
  return widget;
}

QWidget* TerminalPanel::makeTools() {
  auto* widget = m_tools = new QWidget(this);
  m_tools->hide();
  m_echo = new QCheckBox(tr("Show what is sent"), widget);
  m_echo->setObjectName(QStringLiteral("pipeEcho"));
  m_echo->setChecked(true);
  m_hex = new QCheckBox(tr("Bytes"), widget);
  m_hex->setObjectName(QStringLiteral("pipeHex"));
  m_hex->setToolTip(tr("Every character as its byte in hex"));
  m_search = new QLineEdit(widget);
  m_search->setObjectName(QStringLiteral("pipeSearch"));
  m_search->setAccessibleName(tr("Search the transcript"));
  m_search->setPlaceholderText(tr("Search"));
  m_search->setClearButtonEnabled(true);
  m_search->setMaximumWidth(240);
  m_search->installEventFilter(this);
  m_saveText = makeButton("pipeSave", tr("Save transcript…"));
  m_saveLedger = makeButton("pipeSaveLedger", tr("Save ack times…"));
  for (QCheckBox* box : {m_echo, m_hex}) {
    box->setAccessibleName(box->text());
    connect(box, &QCheckBox::toggled, this, &TerminalPanel::rebuild);
  }
  auto* row = new QHBoxLayout(widget);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(m_echo);
  row->addWidget(m_hex);
  row->addWidget(m_search, 1);
  row->addStretch(1);
  row->addWidget(m_saveText);
  row->addWidget(m_saveLedger);
  connect(m_search, &QLineEdit::textEdited, this, [this] {
    m_text->moveCursor(QTextCursor::End);
    find(true);
  });
  connect(m_search, &QLineEdit::returnPressed, this, [this] { find(true); });
  connect(m_saveText, &QPushButton::clicked, this,
          [this] { save(tr("Save the transcript"), QStringLiteral("data-pipe.txt"), m_transcript.text()); });
  connect(m_saveLedger, &QPushButton::clicked, this, [this] {
    save(tr("Save the ack times"), QStringLiteral("data-pipe-acks.csv"), m_transcript.ledger());
  });
  return widget;
}

void TerminalPanel::setDevice(const DeviceKey& device, const QString& name) {
  if (device != m_device) {
    m_input->clear();  // what was typed was meant for the other
    m_trouble.clear();
  }
  m_device = device;
  m_name = name;
}

void TerminalPanel::setView(const LogView& view, const Conversations& talk, const ServiceStatus& services,
                            bool isLive) {
  m_view = view;
  m_services = services;
  m_isLive = isLive;
  if (view.document != nullptr && m_transcript.take(view, talk, m_device)) {
    rebuild();
  } else {
    appendPackets(m_shown);
  }
  showState();
}

void TerminalPanel::setColours(const Colours& colours) {
  m_colours = colours;
  setPalette(qtPalette(colours));
  setInk(*m_caution, colours.textSecondary);
  setInk(*m_hint, colours.attend.ink);
  setInk(*m_stall, colours.fault.ink);
  rebuild();
}

bool TerminalPanel::isRaw() const { return m_mode->currentIndex() == 1; }

void TerminalPanel::showState() {
  const DeviceServices* device = m_services.find(m_device);
  const PipeStatus pipe = device != nullptr && device->pipe ? *device->pipe : PipeStatus{};
  const bool canSend =
      m_isLive && m_services.canAsk() && device != nullptr && device->address != kNullAddress;
  QString hint = m_trouble;
  if (!hint.isEmpty()) {
    // Said until the next deed.
  } else if (!m_isLive) {
    hint = m_services.linkUp ? tr("Paused: nothing new is sent while the view stands in the past.")
                             : tr("No live link: what is shown went through the pipe in the log.");
  } else if (m_services.locked) {
    hint = tr("Sending is locked: the device is not answered either.");
  } else if (!m_services.canAsk()) {
    hint = tr("The console cannot send yet: %1.").arg(claimText(m_services.claim));
  } else if (device == nullptr) {
    hint = tr("Choose an Akron device to talk to.");
  } else if (device->address == kNullAddress) {
    hint = tr("%1 has no address now.").arg(m_name);
  } else if (m_services.refusal == Refusal::Busy || m_services.refusal == Refusal::TooMuch) {
    hint = refusalText(m_services.refusal);
  }
  setText(*m_hint, hint);
  m_hintBar->setVisible(!hint.isEmpty());
  m_unlock->setVisible(m_isLive && m_services.locked);
  const bool isStalled = pipe.progress == PipeStatus::Progress::Stalled;
  m_stallBar->setVisible(isStalled);
  m_caution->setVisible(!isStalled);  // a small screen has room for one of them
  if (isStalled)
    setText(*m_stall, tr("%1 Whether the packet arrived is not known.").arg(stallText(pipe.stall)));
  m_file->setStatus(pipe, std::max(m_view.cursor.time, m_view.end), m_isLive);
  m_resend->setEnabled(m_isLive);
  m_skip->setEnabled(m_isLive);
  const bool mayType = canSend && !pipe.isSendingFile();
  m_input->setEnabled(mayType);
  m_send->setEnabled(mayType && !isRaw());
  m_lineEnd->setEnabled(mayType);
  m_sendFile->setEnabled(mayType && !isStalled);
  m_input->setPlaceholderText(isRaw()
                                  ? tr("Keys go to %1 at once").arg(m_name)
                                  : tr("A line for %1").arg(m_name.isEmpty() ? tr("the device") : m_name));
  m_saveText->setEnabled(!m_transcript.packets().empty());
  m_saveLedger->setEnabled(!m_transcript.packets().empty());
}

void TerminalPanel::rebuild() {
  m_text->clear();
  m_shown = 0;
  m_wasFromDevice = true;
  m_isLineOpen = false;
  appendPackets(0);
}

// What a device says and what we sent stand on lines of their own; ours begin with ›, in the accent's colour.
void TerminalPanel::appendPackets(std::size_t from) {
  const std::vector<PipePacket>& packets = m_transcript.packets();
  if (from >= packets.size()) return;
  QScrollBar* bar = m_text->verticalScrollBar();
  const bool isAtEnd = bar->value() == bar->maximum();
  QTextCursor cursor(m_text->document());
  cursor.movePosition(QTextCursor::End);
  QTextCharFormat format;
  for (; from < packets.size(); ++from) {
    const PipePacket& packet = packets[from];
    if (!packet.isFromDevice && !m_echo->isChecked()) continue;
    format.setForeground(packet.isFromDevice ? m_colours.text : m_colours.accent.ink);
    if (packet.isFromDevice != m_wasFromDevice && m_isLineOpen) {
      cursor.insertText(QStringLiteral("\n"), format);
      m_isLineOpen = false;
    }
    m_wasFromDevice = packet.isFromDevice;
    const QString text =
        m_hex->isChecked() ? pipeHex(packet.bytes) + QLatin1Char(' ') : pipeText(packet.bytes);
    QString out;
    for (const QChar c : text) {
      if (!m_isLineOpen) out += packet.isFromDevice ? QStringLiteral("  ") : QStringLiteral("› ");
      out += c;
      m_isLineOpen = c != QLatin1Char('\n');
    }
    cursor.insertText(out, format);
  }
  m_shown = packets.size();
  if (isAtEnd) bar->setValue(bar->maximum());
}

std::string TerminalPanel::lineEnd() const {
  constexpr const char* kEnds[] = {"\r\n", "\r", "\n", ""};
  return kEnds[m_lineEnd->currentIndex()];
}

void TerminalPanel::sendLine() {
  if (isRaw() || !m_send->isEnabled()) return;
  const QString line = m_input->text();
  m_trouble.clear();
  if (std::ranges::any_of(line, [](QChar c) { return c.unicode() > 0xFF; }))
    return say(tr("The pipe takes characters of one byte only; there is another in this line."));
  const QByteArray bytes = line.toLatin1();
  std::string text(bytes.constData(), static_cast<std::size_t>(bytes.size()));
  text += lineEnd();
  if (text.empty()) return;
  if (!line.isEmpty() && (m_history.isEmpty() || m_history.last() != line)) m_history.append(line);
  m_recalled = m_history.size();
  m_input->clear();
  Q_EMIT wished(wish::PipeWrite{m_device, std::move(text)});
}

// The bytes of a key as a terminal sends them; false for keys that are none.
bool TerminalPanel::sendKey(const QKeyEvent& event) {
  std::string bytes;
  if (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter) {
    bytes = lineEnd();
  } else if (event.key() == Qt::Key_Backspace) {
    bytes = "\b";
  } else if (event.key() == Qt::Key_BracketLeft && event.modifiers() == Qt::ControlModifier) {
    bytes = "\x1B";
  } else if (event.modifiers() == Qt::ControlModifier && event.key() >= Qt::Key_A &&
             event.key() <= Qt::Key_Z) {
    bytes = static_cast<char>(event.key() - Qt::Key_A + 1);
  } else if ((event.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) == 0 &&
             event.key() != Qt::Key_Escape) {
    if (!event.text().isEmpty() && event.text().front().unicode() <= 0xFF)
      bytes = event.text().toLatin1().toStdString();
  }
  if (bytes.empty()) return false;
  Q_EMIT wished(wish::PipeWrite{m_device, std::move(bytes)});
  return true;
}

bool TerminalPanel::eventFilter(QObject* watched, QEvent* event) {
  const bool isCombo = watched == m_mode || watched == m_lineEnd;
  if (isCombo && event->type() == QEvent::Wheel) {
    event->ignore();  // scrolling past it is no choice
    return true;
  }
  if (watched == m_input && isRaw() && event->type() == QEvent::ShortcutOverride) {
    const auto& shortcut = static_cast<const QKeyEvent&>(*event);
    // Control characters are the device's here, not the menu's.
    if (shortcut.modifiers() == Qt::ControlModifier && shortcut.key() <= Qt::Key_BracketLeft) event->accept();
    return true;
  }
  if (event->type() != QEvent::KeyPress) return QWidget::eventFilter(watched, event);
  const auto& key = static_cast<const QKeyEvent&>(*event);
  if (key.matches(QKeySequence::Find)) {
    m_more->setChecked(true);
    m_search->setFocus();
    m_search->selectAll();
    return true;
  }
  if (watched == m_search && (key.key() == Qt::Key_Escape || key.key() == Qt::Key_F3)) {
    if (key.key() == Qt::Key_F3) {
      find((key.modifiers() & Qt::ShiftModifier) == 0);
    } else {
      m_input->setFocus();
    }
    return true;
  }
  if (watched == m_input) {
    if (isRaw()) return sendKey(key);
    if (key.key() == Qt::Key_Up || key.key() == Qt::Key_Down) {
      recall(key.key() == Qt::Key_Up ? -1 : 1);
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

void TerminalPanel::recall(int by) {
  if (m_history.isEmpty()) return;
  m_recalled = std::clamp<qsizetype>(m_recalled + by, 0, m_history.size());
  m_input->setText(m_recalled < m_history.size() ? m_history[m_recalled] : QString());
}

// From the newest on backwards, as in a log that grows at its end.
void TerminalPanel::find(bool backwards) {
  const QString wanted = m_search->text();
  const QTextDocument::FindFlags flags = backwards ? QTextDocument::FindBackward : QTextDocument::FindFlags();
  bool isFound = wanted.isEmpty() || m_text->find(wanted, flags);
  if (!isFound) {
    m_text->moveCursor(backwards ? QTextCursor::End : QTextCursor::Start);
    isFound = m_text->find(wanted, flags);
  }
  m_search->setToolTip(isFound ? QString() : tr("Not found"));
  m_search->setAccessibleDescription(m_search->toolTip());
  QPalette palette = qtPalette(m_colours);
  if (!isFound) palette.setColor(QPalette::Text, m_colours.fault.ink);
  m_search->setPalette(palette);
}

void TerminalPanel::say(const QString& trouble) {
  m_trouble = trouble;
  showState();
}

void TerminalPanel::chooseFile() {
  say({});
  auto* dialog = new QFileDialog(this, tr("Send a file over the data pipe"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, &TerminalPanel::confirmFile);
  dialog->open();
}

void TerminalPanel::confirmFile(const QString& path) {
  QFile file(path);
  QString trouble;
  if (!file.open(QIODevice::ReadOnly)) {
    trouble = file.errorString();
  } else if (file.size() > kLargestFile) {
    trouble = tr("It is larger than %1.").arg(QLocale().formattedDataSize(kLargestFile));
  }
  if (!trouble.isEmpty()) {
    return say(tr("%1 cannot be sent: %2").arg(path, trouble));
  }
  const QByteArray content = file.readAll();
  const wish::PipeFile wanted{
      m_device, QFileInfo(path).fileName().toStdString(),
      std::make_shared<const std::string>(content.constData(), static_cast<std::size_t>(content.size()))};
  DangerDialog::ask(
      this,
      {tr("Send a file to %1?").arg(m_name),
       tr("%1, %2. The device takes the characters as if they had been typed; what they do there "
          "is the device's own affair.")
           .arg(QFileInfo(path).fileName(), QLocale().formattedDataSize(content.size())),
       tr("Send")},
      [this, wanted] { Q_EMIT wished(wanted); });
}

void TerminalPanel::save(const QString& title, const QString& name, const QString& text) {
  say({});
  auto* dialog = new QFileDialog(this, title);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->selectFile(name);
  connect(dialog, &QFileDialog::fileSelected, this, [this, text](const QString& path) {
    QSaveFile file(path);
    const QByteArray bytes = text.toUtf8();
    if (file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size() && file.commit()) return;
    say(tr("%1 could not be written: %2").arg(path, file.errorString()));
  });
  dialog->open();
}

}  // namespace deckpipe
