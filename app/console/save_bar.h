// SPDX-License-Identifier: GPL-3.0-or-later
// Saves a log, or a part of it, and shows how that goes: a line above the timeline with the progress and a
// way to cancel, then what came of it. The window tells it what to save and where.
#pragma once

#include <QTimer>
#include <QWidget>
#include <deque>
#include <memory>

#include "session/log_saving.h"

class QLabel;
class QProgressBar;
class QPushButton;

namespace deckpipe {

class SaveBar : public QWidget {
  Q_OBJECT
 public:
  explicit SaveBar(std::shared_ptr<KnownSidecars> sidecars, QWidget* parent = nullptr);
  ~SaveBar() override;

  // At once, or behind what is being saved now.
  void save(std::shared_ptr<const LogDocument> document, const QString& path, SavedPart part = {});
  // Says why something is not saved, behind what is being saved now.
  void refuse(const QString& why);
  bool isSaving() const { return m_saving != nullptr; }

 Q_SIGNALS:
  void saved(const QString& path);
  // All of a log, as far as it had so many frames and notes then.
  void savedWhole(const std::shared_ptr<const deckpipe::LogDocument>& document, std::uint64_t frames,
                  std::size_t notes);

 private:
  struct Wanted {
    std::shared_ptr<const LogDocument> document;
    QString path;
    SavedPart part;
    bool isWhole = false;
  };
  void begin(Wanted wanted);
  void showProgress();
  void ended(LogSaving::Outcome outcome, const QString& reason);
  void cancelOrClose();

  std::shared_ptr<KnownSidecars> m_sidecars;
  std::unique_ptr<LogSaving> m_saving;
  std::deque<Wanted> m_waiting;
  std::shared_ptr<const LogDocument> m_whole;  // that is saved, if it is not a part of it
  QTimer m_tick;
  QLabel* m_text;
  QProgressBar* m_progress;
  QPushButton* m_button;
};

}  // namespace deckpipe
