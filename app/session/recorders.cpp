// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/recorders.h"

#include <algorithm>
#include <utility>

namespace deckpipe {

void Recorders::begin(const std::shared_ptr<LogDocument>& document, JournalWriter::MakeFile makeFile,
                      bool isSimulated) {
  m_open = std::make_unique<Recorder>(document, std::move(makeFile), isSimulated);
}

std::optional<JournalStatus> Recorders::status() const {
  if (m_open == nullptr) return {};
  return m_open->status();
}

std::optional<JournalStatus> Recorders::leave(bool isStillWritten) {
  const std::optional<JournalStatus> last = status();
  if (m_open == nullptr) return last;
  if (!isStillWritten) m_open->end();
  m_earlier.push_back(std::move(m_open));
  return last;
}

void Recorders::endOf(const std::shared_ptr<LogDocument>& document) {
  for (const auto& recorder : m_earlier) {
    if (recorder->isOf(document)) recorder->end();
  }
}

bool Recorders::holdUnwritten() const {
  const auto isUnwritten = [](const auto& recorder) { return recorder && recorder->status().fault; };
  return isUnwritten(m_open) || std::ranges::any_of(m_earlier, isUnwritten);
}

bool Recorders::setSaved(const std::shared_ptr<const LogDocument>& document, std::uint64_t frames,
                         std::size_t notes) {
  const auto take = [&](const auto& recorder) {
    if (!recorder || !recorder->isOf(document)) return false;
    recorder->setSaved(frames, notes);
    return true;
  };
  return take(m_open) || std::ranges::any_of(m_earlier, take);
}

}  // namespace deckpipe
