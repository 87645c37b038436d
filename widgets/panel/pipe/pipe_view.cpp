// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/pipe/pipe_view.h"

#include <QCheckBox>
#include <QFileDialog>
#include <QFontDatabase>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSaveFile>
#include <QScrollBar>

#include <utility>

#include "model/field_text.h"
#include "paint/app_style.h"
#include "panel/common/build.h"

namespace deckpipe {
namespace {

constexpr int kMinText = 48;
constexpr int kMaxBlocks = 20'000;

}  // namespace

PipeView::PipeView(QWidget* parent)
    : QWidget(parent),
      m_text(named(new QPlainTextEdit(this), "pipeText", tr("What went through the data pipe"))) {
  m_text->setReadOnly(true);
  m_text->setMinimumHeight(kMinText);
  m_text->setUndoRedoEnabled(false);
  m_text->setMaximumBlockCount(kMaxBlocks);
  m_text->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  m_text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  m_text->installEventFilter(this);
  // At the end it stays there, also when it gets less room.
  QScrollBar* bar = m_text->verticalScrollBar();
  connect(bar, &QScrollBar::valueChanged, this,
          [this, bar](int value) { m_isFollowing = value >= bar->maximum(); });
  connect(bar, &QScrollBar::rangeChanged, this, [this, bar](int, int most) {
    if (m_isFollowing) bar->setValue(most);
  });
  inColumn(this, {0, 0, 0, 0}, 6, {{m_text, 1}, makeTools()});
}

QWidget* PipeView::makeTools() {
  m_tools = new QWidget(this);
  m_tools->hide();
  m_echo = new QCheckBox(tr("Show what is sent"), m_tools);
  m_echo->setObjectName(QStringLiteral("pipeEcho"));
  m_echo->setChecked(true);
  m_hex = new QCheckBox(tr("Bytes"), m_tools);
  m_hex->setObjectName(QStringLiteral("pipeHex"));
  m_hex->setToolTip(tr("Every character as its byte in hex"));
  for (QCheckBox* box : {m_echo, m_hex}) {
    box->setAccessibleName(box->text());
    connect(box, &QCheckBox::toggled, this, &PipeView::rebuild);
  }
  m_search = named(new QLineEdit(m_tools), "pipeSearch", tr("Search the transcript"));
  m_search->setPlaceholderText(tr("Search"));
  m_search->setClearButtonEnabled(true);
  m_search->setMaximumWidth(240);
  m_search->installEventFilter(this);
  m_saveText = makeButton(m_tools, "pipeSave", tr("Save transcript…"));
  m_saveLedger = makeButton(m_tools, "pipeSaveLedger", tr("Save ack times…"));
  inRow(m_tools, {m_echo, m_hex, {m_search, 1}, LayoutPart::rest(), m_saveText, m_saveLedger});
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
  return m_tools;
}

void PipeView::setView(const LogView& view, const DeviceKey& device) {
  if (view.document != nullptr && m_transcript.take(view, device)) {
    rebuild();
  } else {
    append(m_shown);
  }
  m_saveText->setEnabled(!m_transcript.packets().empty());
  m_saveLedger->setEnabled(m_saveText->isEnabled());
}

void PipeView::showTools(bool isOn) { m_tools->setVisible(isOn); }

void PipeView::beginSearch() {
  Q_EMIT toolsWanted();
  m_search->setFocus();
  m_search->selectAll();
}

void PipeView::rebuild() {
  m_theme = coloursOf(this).theme;
  m_text->clear();
  m_shown = 0;
  m_lastSender = {};
  m_isLineOpen = false;
  m_restartsShown = 0;
  append(0);
}

// What a device says and what is sent to it stand on lines of their own; ours begin with ›, in the accent's
// colour, those of another console with its address before it.
void PipeView::append(std::size_t from) {
  const std::vector<PipePacket>& packets = m_transcript.packets();
  const std::span<const Instant> restarts = m_transcript.restarts();
  if (from >= packets.size() && m_restartsShown >= restarts.size()) return;
  QTextCursor cursor(m_text->document());
  cursor.movePosition(QTextCursor::End);
  QTextCharFormat format;
  const Colours& c = coloursOf(this);
  const auto showRestartsBefore = [&](Instant time) {
    for (; m_restartsShown < restarts.size() && restarts[m_restartsShown] < time; ++m_restartsShown) {
      format.setForeground(c.warning.ink);
      if (std::exchange(m_isLineOpen, false)) cursor.insertText(QStringLiteral("\n"), format);
      cursor.insertText(pipeRestartText() + QLatin1Char('\n'), format);
    }
  };
  for (; from < packets.size(); ++from) {
    const PipePacket& packet = packets[from];
    showRestartsBefore(packet.time);
    if (!packet.isFromDevice && !m_echo->isChecked()) continue;
    format.setForeground(packet.isFromDevice ? c.text : packet.isOurs ? c.accent.ink : c.textSecondary);
    if (packet.sender != m_lastSender && m_isLineOpen) {
      cursor.insertText(QStringLiteral("\n"), format);
      m_isLineOpen = false;
    }
    m_lastSender = packet.sender;
    const QString text =
        m_hex->isChecked() ? pipeHex(packet.bytes) + QLatin1Char(' ') : pipeText(packet.bytes);
    QString out;
    for (const QChar letter : text) {
      if (!m_isLineOpen) {
        out += packet.isFromDevice ? QStringLiteral("  ")
               : packet.isOurs     ? QStringLiteral("› ")
                                   : QStringLiteral("%1› ").arg(hexText(packet.sender.value, 2));
      }
      out += letter;
      m_isLineOpen = letter != QLatin1Char('\n');
    }
    cursor.insertText(out, format);
  }
  showRestartsBefore(kNever);
  m_shown = packets.size();
  if (m_isFollowing) m_text->verticalScrollBar()->setValue(m_text->verticalScrollBar()->maximum());
}

// The letters keep the colours that they were written in.
void PipeView::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::StyleChange && coloursOf(this).theme != m_theme) rebuild();
}

bool PipeView::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::KeyPress) return QWidget::eventFilter(watched, event);
  const auto& key = static_cast<const QKeyEvent&>(*event);
  if (key.matches(QKeySequence::Find)) return beginSearch(), true;
  if (watched != m_search) return QWidget::eventFilter(watched, event);
  if (key.key() == Qt::Key_F3) return find((key.modifiers() & Qt::ShiftModifier) == 0), true;
  if (key.key() != Qt::Key_Escape) return QWidget::eventFilter(watched, event);
  Q_EMIT searchLeft();
  return true;
}

// From the newest on backwards, as in a log that grows at its end.
void PipeView::find(bool backwards) {
  const QString wanted = m_search->text();
  const QTextDocument::FindFlags flags = backwards ? QTextDocument::FindBackward : QTextDocument::FindFlags();
  bool isFound = wanted.isEmpty() || m_text->find(wanted, flags);
  if (!isFound) {
    m_text->moveCursor(backwards ? QTextCursor::End : QTextCursor::Start);
    isFound = m_text->find(wanted, flags);
  }
  m_search->setToolTip(isFound ? QString() : tr("Not found"));
  m_search->setAccessibleDescription(m_search->toolTip());
  setInk(*m_search, isFound ? Ink::Text : Ink::Fault);
}

void PipeView::save(const QString& title, const QString& name, const QString& text) {
  Q_EMIT failed({});
  auto* dialog = new QFileDialog(this, title);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->selectFile(name);
  connect(dialog, &QFileDialog::fileSelected, this, [this, text](const QString& path) {
    QSaveFile file(path);
    const QByteArray bytes = text.toUtf8();
    const auto fail = [&] { Q_EMIT failed(tr("%1 could not be written: %2").arg(path, file.errorString())); };
    // Without a buffer the fault is that of the write: committing forgets why. A disk that is nearly full takes a part
    // and gives no reason: the rest is tried for it.
    if (!file.open(QIODevice::WriteOnly | QIODevice::Unbuffered)) return fail();
    for (qsizetype done = 0; done < bytes.size();) {
      const qint64 n = file.write(bytes.constData() + done, bytes.size() - done);
      if (n <= 0) return fail();
      done += n;
    }
    if (!file.commit()) fail();
  });
  dialog->open();
}

}  // namespace deckpipe
