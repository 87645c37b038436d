// SPDX-License-Identifier: GPL-3.0-or-later
// The recordings page with what it does: reads the folder, copies and deletes on threads of their own, and
// says at the start what was not saved. Saved recordings beyond the limits of the settings are deleted when
// the folder is read for the first time.
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <vector>

#include "panel/common/notice_bar.h"
#include "session/recordings.h"

namespace deckpipe {

class RecordingsPage;

// Settings "recordings/maxMegabytes" and "recordings/maxDays".
RecordingLimits recordingLimits();
void keepRecordingLimits(const RecordingLimits& limits);
// The notice about recordings that nobody saved; it has no text if there is none.
Notice unsavedNotice(const std::vector<Recording>& recordings);

class RecordingsList : public QObject {
  Q_OBJECT
 public:
  RecordingsList(const QString& folder, QWidget* parent);
  ~RecordingsList() override;

  RecordingsPage* page() const { return m_page; }
  // A copy is being saved, or something is being deleted.
  bool isBusy() const { return m_work != nullptr && m_isDeed; }
  // Reads the folder anew.
  void read();
  void saveCopy(const QString& path, const QString& as);
  void remove(const QString& path);

 Q_SIGNALS:
  // The folder was read.
  void changed(const std::vector<deckpipe::Recording>& recordings);

 private:
  struct Work;
  void start(std::function<QString()> deed);
  void finish();

  QString m_folder;
  RecordingsPage* m_page;
  bool m_isTidy = false;
  bool m_isDeed = false;         // what runs now or waits is more than reading
  std::shared_ptr<Work> m_work;  // the thread's too, while one runs
  std::vector<std::function<QString()>> m_waiting;
  QTimer m_tick;
};

}  // namespace deckpipe
