// SPDX-License-Identifier: GPL-3.0-or-later
#include "save_bar.h"

#include <QFileInfo>
#include <QProgressBar>
#include <QPushButton>
#include <algorithm>
#include <utility>

#include "panel/common/build.h"
#include "panel/common/labels.h"
#include "status_text.h"
#include "text/plural.h"

namespace deckpipe {
namespace {

QString outcomeText(const LogSaving& saving, LogSaving::Outcome outcome, const QString& reason) {
  const QString path = saving.path();
  if (outcome == LogSaving::Outcome::Cancelled) return SaveBar::tr("Cancelled: nothing was saved.");
  if (outcome == LogSaving::Outcome::IsGrowing)
    return SaveBar::tr("%1 cannot be saved: it is a recording that goes on").arg(path);
  if (outcome == LogSaving::Outcome::SidecarUnknown)
    return SaveBar::
        tr("%1 is left as it is: the marks and labels beside it were not read here, or were changed since. "
           "Save under another name to keep both")
            .arg(path);
  if (outcome == LogSaving::Outcome::Failed) return SaveBar::tr("%1 cannot be saved: %2").arg(path, reason);
  QString text = SaveBar::tr("Saved %1 to %2").arg(frameCountText(saving.written()), path);
  if (saving.added() > 0)
    text += SaveBar::tr("; %Ln frames were added to them: who held which address", nullptr,
                        forPlural(saving.added()));
  if (!reason.isEmpty()) {
    text += SaveBar::tr("; its marks, notes and labels cannot be saved: %1").arg(reason);
  } else if (!saving.sidecar().isEmpty()) {
    text += SaveBar::tr("; marks, notes and labels are beside it in %1")
                .arg(QFileInfo(saving.sidecar()).fileName());
  }
  return text;
}

}  // namespace

SaveBar::SaveBar(std::shared_ptr<KnownSidecars> sidecars, QWidget* parent)
    : QWidget(parent),
      m_sidecars(std::move(sidecars)),
      m_text(named(new ElidedLabel(this), "saveText", tr("Saving"))),
      m_progress(named(new QProgressBar(this), "saveProgress", tr("How much is saved"))),
      m_button(new QPushButton(this)) {
  named(this, "saveBar", tr("Saving"));
  m_progress->setFixedWidth(240);
  m_button->setObjectName(QStringLiteral("saveButton"));
  inRow(this, {14, 4, 8, 4}, 8, {{m_text, 1}, m_progress, m_button});
  connect(m_button, &QPushButton::clicked, this, &SaveBar::cancelOrClose);
  m_tick.setInterval(100);
  connect(&m_tick, &QTimer::timeout, this, &SaveBar::showProgress);
  hide();
}

SaveBar::~SaveBar() = default;

void SaveBar::save(std::shared_ptr<const LogDocument> document, const QString& path, SavedPart part) {
  const std::uint64_t count = document->frames.count();
  const bool isWhole = part.begin == 0 && !part.passes && part.end >= count;
  part.end = std::min(part.end, count);
  Wanted wanted{std::move(document), path, std::move(part), isWhole};
  if (!isSaving()) {
    m_text->setText({});
    return begin(std::move(wanted));
  }
  m_waiting.push_back(std::move(wanted));
}

void SaveBar::refuse(const QString& why) {
  m_text->setText(isSaving() ? m_text->text() + QStringLiteral(". ") + why : why);
  if (isSaving()) return;
  m_progress->hide();
  m_button->setText(tr("Close"));
  m_button->setAccessibleName(tr("Close this line"));
  show();
}

// The line keeps the outcome of the save before, which nobody may have read yet.
void SaveBar::begin(Wanted wanted) {
  auto& [document, path, part, isWhole] = wanted;
  m_whole = isWhole ? document : nullptr;
  m_saving = std::make_unique<LogSaving>(std::move(document), path, std::move(part), m_sidecars);
  connect(m_saving.get(), &LogSaving::ended, this, &SaveBar::ended);
  const auto frames = m_saving->frames();
  const QString text = frames ? tr("Saving %1 to %2").arg(frameCountText(*frames), path)
                              : tr("Saving what passes the filter to %1").arg(path);
  m_text->setText(
      m_text->text().isEmpty()
          ? text
          : tr("%1. Before: %2", "what is being saved; what came of another log").arg(text, m_text->text()));
  m_button->setText(tr("Cancel"));
  m_button->setAccessibleName(tr("Cancel saving"));
  m_progress->show();
  showProgress();
  m_tick.start();
  show();
}

void SaveBar::showProgress() {
  if (m_saving) m_progress->setValue(static_cast<int>(m_saving->fraction() * 100));
}

void SaveBar::ended(LogSaving::Outcome outcome, const QString& reason) {
  const QString path = m_saving->path();
  const std::uint64_t written = m_saving->written();
  const std::size_t notes = m_saving->notes();
  const QString text = outcomeText(*m_saving, outcome, reason);
  m_tick.stop();
  m_saving.release()->deleteLater();  // it is telling us this
  m_progress->hide();
  m_button->setText(tr("Close"));
  m_button->setAccessibleName(tr("Close this line"));
  m_text->setText(text);
  if (outcome == LogSaving::Outcome::Saved) {
    Q_EMIT saved(path);
    // Without its notes it is no substitute for the recording.
    if (m_whole != nullptr && reason.isEmpty()) Q_EMIT savedWhole(m_whole, written, notes);
  }
  m_whole.reset();
  if (m_waiting.empty()) return;
  Wanted next = std::move(m_waiting.front());
  m_waiting.pop_front();
  begin(std::move(next));
}

void SaveBar::cancelOrClose() {
  if (m_saving) {
    m_saving->cancel();
  } else {
    hide();
  }
}

}  // namespace deckpipe
