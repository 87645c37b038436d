// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/pipe/pipe_input.h"

#include <QFontDatabase>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPushButton>
#include <algorithm>
#include <limits>

#include "panel/common/build.h"

namespace deckpipe {
namespace {

// Ctrl+A to Ctrl+Z and Ctrl+[: control characters in a terminal, shortcuts elsewhere.
bool isControlCharacter(const QKeyEvent& event) {
  return event.modifiers() == Qt::ControlModifier &&
         ((event.key() >= Qt::Key_A && event.key() <= Qt::Key_Z) || event.key() == Qt::Key_BracketLeft);
}

// What was typed or pasted, where CR LF, CR and LF all end a line. Without an end of its own each line keeps
// the one it came with: lines that run into one another are another command.
QString withEnds(QString text, const QString& end) {
  if (end.isEmpty()) return text;
  text.replace(QLatin1String("\r\n"), QLatin1String("\n")).replace(QLatin1Char('\r'), QLatin1Char('\n'));
  return text.replace(QLatin1Char('\n'), end);
}

bool isEnded(const QString& text) {
  return text.endsWith(QLatin1Char('\n')) || text.endsWith(QLatin1Char('\r'));
}

// The last line needs no end.
int countLines(const QString& text) {
  const auto ends = withEnds(text, QStringLiteral("\n")).count(QLatin1Char('\n'));
  return static_cast<int>(ends) + (isEnded(text) ? 0 : 1);
}

// The first character that does not fit into a byte, as a person can find it: itself, or its number where
// there is nothing to see. Empty if all fit.
QString wideCharacter(const QString& text) {
  const auto wide = std::ranges::find_if(text, [](QChar c) { return c.unicode() > 0xFF; });
  if (wide == text.end()) return {};
  const QString from = text.mid(wide - text.begin(), 2);
  const char32_t character = from.toUcs4().at(0);
  if (QChar::isPrint(character) && !QChar::isSpace(character)) return QString::fromUcs4(&character, 1);
  return QStringLiteral("U+%1").arg(static_cast<uint>(character), 4, 16, QLatin1Char('0')).toUpper();
}

}  // namespace

PipeInput::PipeInput(QWidget* parent)
    : QWidget(parent),
      m_mode(named(new CalmCombo(this), "pipeMode", tr("How typing is sent"))),
      m_input(named(new QLineEdit(this), "pipeInput", tr("Characters to send"))),
      m_lineEnd(named(new CalmCombo(this), "pipeLineEnd", tr("Line end"))),
      m_send(makeButton(this, "pipeSend", tr("Send"))) {
  m_mode->addItems({tr("Lines"), tr("Every key")});
  m_mode->setToolTip(
      tr("Lines: what is typed goes with Enter. Every key: each goes at once; Ctrl+[ sends ESC."));
  m_input->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  m_input->setMaxLength(std::numeric_limits<int>::max());  // what is too much is refused whole, with words
  m_input->installEventFilter(this);
  m_lineEnd->addItems({tr("CR LF"), tr("CR"), tr("LF"), tr("No line end")});
  setFocusProxy(m_input);
  inRow(this, {m_mode, {m_input, 1}, m_lineEnd, m_send});
  connect(m_input, &QLineEdit::returnPressed, this, &PipeInput::sendLine);
  connect(m_input, &QLineEdit::textEdited, this, &PipeInput::sendRest);
  connect(m_input, &QLineEdit::textChanged, this, &PipeInput::showCount);
  connect(m_send, &QPushButton::clicked, this, &PipeInput::sendLine);
  connect(m_mode, &QComboBox::activated, this, [this] {
    clear();
    m_send->setEnabled(m_input->isEnabled() && !isRaw());
    m_input->setFocus();
  });
}

bool PipeInput::isRaw() const { return m_mode->currentIndex() == 1; }

void PipeInput::clear() { m_input->clear(); }

void PipeInput::setOffered(bool mayType, const QString& name, bool hasRestarted) {
  m_input->setEnabled(mayType);
  m_send->setEnabled(mayType && !isRaw());
  m_lineEnd->setEnabled(mayType);
  const QString whom = name.isEmpty() ? tr("the device") : name;
  const QString what = isRaw() ? tr("Keys go to %1 at once").arg(whom) : tr("A line for %1").arg(whom);
  m_input->setPlaceholderText(hasRestarted ? tr("%1, which has restarted").arg(what) : what);
}

std::string PipeInput::lineEnd() const {
  constexpr const char* kEnds[] = {"\r\n", "\r", "\n", ""};
  return kEnds[m_lineEnd->currentIndex()];
}

QString PipeInput::lineEndName() const {
  return lineEnd().empty() ? tr("nothing") : m_lineEnd->currentText();
}

bool PipeInput::take(const QString& text, std::string& bytes) {
  if (const QString wide = wideCharacter(text); !wide.isEmpty()) {
    Q_EMIT refused(tr("Not sent: the pipe takes characters of one byte only, and “%1” has more.").arg(wide));
    return false;
  }
  const QByteArray latin = text.toLatin1();
  bytes.assign(latin.constData(), static_cast<std::size_t>(latin.size()));
  return true;
}

void PipeInput::showCount() {
  const int lines = countLines(m_input->text());
  m_send->setText(lines > 1 ? tr("Send %Ln lines", nullptr, lines) : tr("Send"));
  m_send->setAccessibleName(m_send->text());
}

void PipeInput::sendLine() {
  if (isRaw() || !m_send->isEnabled()) return;
  const QString line = m_input->text();
  const QString end = QString::fromLatin1(lineEnd().c_str());
  std::string bytes;
  if (!take(withEnds(isEnded(line) ? line : line + end, end), bytes) || bytes.empty()) return;
  if (!line.isEmpty() && (m_history.isEmpty() || m_history.last() != line)) m_history.append(line);
  m_recalled = m_history.size();
  clear();
  Q_EMIT typed(bytes);
}

void PipeInput::sendRest() {
  if (!isRaw()) return;
  const QString text = m_input->text();
  clear();
  std::string bytes;
  if (take(withEnds(text, QString::fromLatin1(lineEnd().c_str())), bytes) && !bytes.empty())
    Q_EMIT typed(bytes);
}

// The bytes of a key as a terminal sends them; false for keys that are none.
bool PipeInput::sendKey(const QKeyEvent& event) {
  std::string bytes;
  if (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter) {
    bytes = lineEnd();
  } else if (event.key() == Qt::Key_Backspace) {
    bytes = "\b";
  } else if (isControlCharacter(event)) {
    bytes = static_cast<char>(event.key() - Qt::Key_A + 1);
  } else if ((event.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) == 0 &&
             event.key() != Qt::Key_Escape) {
    if (!take(event.text(), bytes)) return true;
  }
  if (bytes.empty()) return false;
  Q_EMIT typed(bytes);
  return true;
}

bool PipeInput::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && isRaw()) {
    // Control characters are the device's here, not the menu's.
    if (isControlCharacter(static_cast<const QKeyEvent&>(*event))) event->accept();
    return true;
  }
  if (event->type() != QEvent::KeyPress) return QWidget::eventFilter(watched, event);
  const auto& key = static_cast<const QKeyEvent&>(*event);
  if (isRaw()) return sendKey(key);
  if (key.matches(QKeySequence::Find)) {
    Q_EMIT findRequested();
    return true;
  }
  if (key.key() != Qt::Key_Up && key.key() != Qt::Key_Down) return QWidget::eventFilter(watched, event);
  recall(key.key() == Qt::Key_Up ? -1 : 1);
  return true;
}

void PipeInput::recall(int by) {
  if (m_history.isEmpty()) return;
  m_recalled = std::clamp<qsizetype>(m_recalled + by, 0, m_history.size());
  m_input->setText(m_recalled < m_history.size() ? m_history[m_recalled] : QString());
}

}  // namespace deckpipe
