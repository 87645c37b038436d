// SPDX-License-Identifier: GPL-3.0-or-later
#include "save_bar.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QProgressBar>
#include <QPushButton>
#include <algorithm>

#include "panel/elided_label.h"
#include "status_text.h"

namespace deckpipe {

SaveBar::SaveBar(QWidget* parent)
    : QWidget(parent),
      m_text(new ElidedLabel(this)),
      m_progress(new QProgressBar(this)),
      m_button(new QPushButton(this)) {
  setObjectName(QStringLiteral("saveBar"));
  setAccessibleName(tr("Saving"));
  m_text->setObjectName(QStringLiteral("saveText"));
  m_text->setAccessibleName(tr("Saving"));
  m_progress->setObjectName(QStringLiteral("saveProgress"));
  m_progress->setAccessibleName(tr("How much is saved"));
  m_progress->setFixedWidth(240);
  m_button->setObjectName(QStringLiteral("saveButton"));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(14, 4, 8, 4);
  row->setSpacing(8);
  row->addWidget(m_text, 1);
  row->addWidget(m_progress);
  row->addWidget(m_button);
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

// The line keeps the outcome of the save before, which nobody may have read yet.
void SaveBar::begin(Wanted wanted) {
  auto& [document, path, part, isWhole] = wanted;
  const std::vector<Note> notes = document->notes.all();
  const auto countOf = [&notes](auto kind) {
    return static_cast<int>(std::ranges::count_if(
        notes, [](const Note& note) { return std::holds_alternative<decltype(kind)>(note.value); }));
  };
  m_marks = countOf(note::Mark{});
  // A copy without marks or drives is no substitute for the recording, which has them.
  m_whole = isWhole && m_marks == 0 && countOf(note::DriveSaid{}) == 0 ? document : nullptr;
  m_saving = std::make_unique<LogSaving>(std::move(document), path, std::move(part));
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
  const QString frames = frameCountText(written);
  const QString format = m_saving->formatName();
  m_tick.stop();
  m_saving.release()->deleteLater();  // it is telling us this
  m_progress->hide();
  m_button->setText(tr("Close"));
  m_button->setAccessibleName(tr("Close this line"));
  switch (outcome) {
    case LogSaving::Outcome::Saved:
      m_text->setText(
          m_marks == 0
              ? tr("Saved %1 to %2").arg(frames, path)
              : tr("Saved %1 to %2; %Ln marks are not in it, for %3 has no place for them", nullptr, m_marks)
                    .arg(frames, path, format));
      Q_EMIT saved(path);
      if (m_whole != nullptr) Q_EMIT savedWhole(m_whole, written);
      break;
    case LogSaving::Outcome::Cancelled: m_text->setText(tr("Cancelled: nothing was saved.")); break;
    case LogSaving::Outcome::Failed: m_text->setText(tr("%1 cannot be saved: %2").arg(path, reason)); break;
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
