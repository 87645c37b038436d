// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/text_appender.h"

#include <algorithm>

namespace deckpipe {
namespace {

constexpr std::uint64_t kLookBack = 20'000;

}  // namespace

bool TextAppender::isShorterThanBefore(std::span<const Frame> frames) const {
  const Frame& last = frames.back();
  std::optional<std::uint8_t> ofIdentifier;
  std::optional<bool> isShorter;
  std::uint64_t looked = 0;
  // False once the frame is found that tells.
  const auto look = [&](const Frame& frame) {
    if (++looked > kLookBack) return false;
    if (frame.id != last.id || frame.channel != last.channel) return true;
    if (!ofIdentifier) ofIdentifier = frame.length;
    if (last.length == 0 || frame.length == 0 || frame.data[0] != last.data[0]) return true;
    isShorter = last.length < frame.length;
    return false;
  };
  bool goesOn = true;
  for (std::size_t i = frames.size() - 1; i > 0 && goesOn; --i) goesOn = look(frames[i - 1]);
  for (std::size_t i = m_first.size(); i > 0 && goesOn; --i) goesOn = look(m_first[i - 1]);
  for (std::uint64_t i = m_store.count(); i > 0 && goesOn; --i) goesOn = look(m_store[i - 1]);
  return isShorter.value_or(last.length < ofIdentifier.value_or(0));
}

}  // namespace deckpipe
