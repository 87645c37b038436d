// SPDX-License-Identifier: GPL-3.0-or-later
// The line where a filter of the trace is typed: completes keys and values while one types, and says once
// the text stands still, or Enter is pressed, which filter it is or where it is wrong. In the trace panel.
#pragma once

#include <QLineEdit>
#include <QTimer>
#include <optional>

#include "model/trace_filter.h"

class QCompleter;
class QStandardItemModel;

namespace deckpipe {

class TraceFilterEdit : public QLineEdit {
  Q_OBJECT

 public:
  explicit TraceFilterEdit(QWidget* parent = nullptr);

  // Of the log that is open, for completion.
  void setChannels(const QStringList& channels) { m_channels = channels; }
  // As if it had been typed and Enter pressed.
  void setExpression(const QString& expression);
  // Nothing: the text is a filter.
  const std::optional<FilterError>& error() const { return m_error; }
  QCompleter* completions() const { return m_completer; }

 Q_SIGNALS:
  void filterTyped(const deckpipe::TraceFilter& filter);
  // The filter that was typed last stays in force.
  void mistyped();
  // By Escape: back to the rows.
  void left();

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void offer();
  void insertWord(const QString& word);
  void take();

  QStringList m_channels;
  QStandardItemModel* m_words;
  QCompleter* m_completer;
  int m_from = 0;  // where the word begins that is completed
  QTimer m_still;
  std::optional<FilterError> m_error;
};

}  // namespace deckpipe
