// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/trace/trace_filter_edit.h"

#include <QAbstractItemView>
#include <QCompleter>
#include <QKeyEvent>
#include <QStandardItemModel>
#include <algorithm>

#include "model/filter_keys.h"
#include "panel/common/build.h"

namespace deckpipe {
namespace {

constexpr int kStillMs = 350;
constexpr int kWordRole = Qt::UserRole;

}  // namespace

TraceFilterEdit::TraceFilterEdit(QWidget* parent)
    : QLineEdit(parent), m_words(new QStandardItemModel(this)), m_completer(new QCompleter(m_words, this)) {
  named(this, "traceFilter", tr("Filter of the trace"));
  setPlaceholderText(tr("Filter, for instance  soft limits and sa=80"));
  setWhatsThis(filterHelp());
  setClearButtonEnabled(true);
  m_completer->setWidget(this);
  m_completer->setCompletionMode(QCompleter::UnfilteredPopupCompletion);
  m_completer->setMaxVisibleItems(10);
  m_completer->popup()->setObjectName(QStringLiteral("traceFilterWords"));
  connect(m_completer, qOverload<const QModelIndex&>(&QCompleter::activated), this,
          [this](const QModelIndex& index) { insertWord(index.data(kWordRole).toString()); });
  m_still.setSingleShot(true);
  m_still.setInterval(kStillMs);
  connect(&m_still, &QTimer::timeout, this, &TraceFilterEdit::take);
  connect(this, &QLineEdit::textEdited, this, [this] {
    m_still.start();
    offer();
  });
  // The clear button is no editing.
  connect(this, &QLineEdit::textChanged, this, [this](const QString& now) {
    if (now.isEmpty()) take();
  });
}

void TraceFilterEdit::setExpression(const QString& expression) {
  setText(expression);
  take();
}

void TraceFilterEdit::take() {
  m_still.stop();
  const auto filter = TraceFilter::parse(text());
  if (filter) {
    m_error.reset();
    Q_EMIT filterTyped(filter.value());
  } else {
    m_error = filter.error();
    Q_EMIT mistyped();
  }
}

void TraceFilterEdit::offer() {
  const FilterCompletions completions = filterCompletions(text(), cursorPosition(), m_channels);
  const bool isBegun =
      completions.from < cursorPosition() ||
      (completions.from > 0 && QStringLiteral("=~\"").contains(text()[completions.from - 1]));
  m_from = completions.from;
  m_words->clear();
  if (!isBegun || completions.entries.empty()) {
    m_completer->popup()->hide();
    return;
  }
  for (const auto& entry : completions.entries) {
    auto* item =
        new QStandardItem(entry.help.isEmpty() ? entry.word : tr("%1   –  %2").arg(entry.word, entry.help));
    item->setData(entry.word, kWordRole);
    m_words->appendRow(item);
  }
  QRect below = cursorRect();
  below.setWidth(std::min(width(), 480));
  m_completer->complete(below);
  // Enter is for what stands in the line. It takes a word of the list only once an arrow key has chosen it.
  m_completer->popup()->setCurrentIndex({});
}

void TraceFilterEdit::insertWord(const QString& word) {
  const QString now = text();
  const int from = std::min<int>(m_from, static_cast<int>(now.size()));
  setText(now.left(from) + word + now.mid(std::max(from, cursorPosition())));
  setCursorPosition(from + static_cast<int>(word.size()));
  m_still.start();
}

void TraceFilterEdit::keyPressEvent(QKeyEvent* event) {
  const bool isOffering = m_completer->popup()->isVisible();
  switch (event->key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (isOffering && m_completer->popup()->currentIndex().isValid()) {
        event->ignore();  // the list takes it
        return;
      }
      m_completer->popup()->hide();
      take();
      // What is wrong is selected, so that it can be written over.
      if (m_error) setSelection(m_error->at, m_error->length);
      return;
    case Qt::Key_Escape:
      if (isOffering) {
        m_completer->popup()->hide();
      } else {
        Q_EMIT left();
      }
      return;
    default: break;
  }
  QLineEdit::keyPressEvent(event);
}

}  // namespace deckpipe
