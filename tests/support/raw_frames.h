// SPDX-License-Identifier: GPL-3.0-or-later
// Frames for tests by number, with the identifier bits as Frame::id has them: remote and error frames too.
#pragma once

#include <algorithm>
#include <initializer_list>

#include "bus/frame.h"

namespace deckpipe::test {

inline Frame frameOf(std::uint32_t id, std::initializer_list<int> bytes) {
  Frame frame;
  frame.id = id;
  frame.length = static_cast<std::uint8_t>(bytes.size());
  std::transform(bytes.begin(), bytes.end(), frame.data.begin(),
                 [](int byte) { return static_cast<std::uint8_t>(byte); });
  return frame;
}
inline Frame extendedFrame(std::uint32_t id, std::initializer_list<int> bytes) {
  return frameOf(id | kExtendedBit, bytes);
}
inline Frame remoteFrame(std::uint32_t id, int length) {
  Frame frame = frameOf(id | kRemoteBit, {});
  frame.length = static_cast<std::uint8_t>(length);
  return frame;
}

}  // namespace deckpipe::test
