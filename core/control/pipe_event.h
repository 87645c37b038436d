// SPDX-License-Identifier: GPL-3.0-or-later
// What happened to a data pipe, for notes of the log. Numbers stand in files: never renumber one, never use
// one again.
#pragma once

#include <cstdint>

namespace deckpipe {

enum class PipeEvent : std::uint8_t {
  FileBegan = 0,
  FileDone = 1,
  FileCancelled = 2,
  FileAborted = 3,
  Stalled = 4,  // no ack
  AckLate = 5,  // it came after all
  Resent = 6,   // by the person, or as the person said for the rest
  Skipped = 7,  // …
  Dropped = 8,  // what was typed and not sent
  DeviceRestarted = 9,
};

constexpr bool isKnown(PipeEvent event) {
  switch (event) {
    case PipeEvent::FileBegan:
    case PipeEvent::FileDone:
    case PipeEvent::FileCancelled:
    case PipeEvent::FileAborted:
    case PipeEvent::Stalled:
    case PipeEvent::AckLate:
    case PipeEvent::Resent:
    case PipeEvent::Skipped:
    case PipeEvent::Dropped:
    case PipeEvent::DeviceRestarted: return true;
  }
  return false;
}

}  // namespace deckpipe
