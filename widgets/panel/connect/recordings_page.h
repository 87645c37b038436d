// SPDX-License-Identifier: GPL-3.0-or-later
// The recordings that this machine keeps, the newest first: which were never saved, what was heard in each,
// and what a person may do with one. The console reads the folder and does what is asked for.
#pragma once

#include <QString>
#include <vector>

#include "panel/common/build.h"

class QLabel;
class QListWidget;
class QPushButton;

namespace deckpipe {

struct RecordingRow {
  QString path;
  QString title;    // when, and how it stands
  QString details;  // how long, how many frames, who was heard
  bool isReadable = true;
  bool isGrowing = false;
  friend bool operator==(const RecordingRow&, const RecordingRow&) = default;
};

class RecordingsPage : public ExtraPage {
  Q_OBJECT

 public:
  explicit RecordingsPage(QWidget* parent = nullptr);

  // `folder`: where they are. The chosen row stays chosen.
  void setRows(const std::vector<RecordingRow>& rows, const QString& folder);
  // The folder is being read; rows may be of before.
  void setReading();
  // What came of a deed; empty: nothing to say.
  void setOutcome(const QString& text);

 Q_SIGNALS:
  void openRequested(const QString& path);
  void saveRequested(const QString& path);
  void deleteRequested(const QString& path);

 private:
  const RecordingRow* chosen() const;
  void showButtons();

  std::vector<RecordingRow> m_rows;
  QLabel* m_intro;
  QListWidget* m_list;
  QLabel* m_outcome;
  QPushButton* m_open;
  QPushButton* m_save;
  QPushButton* m_delete;
};

}  // namespace deckpipe
