// SPDX-License-Identifier: GPL-3.0-or-later
// The recordings in the person's data folder (recorder.h): what is in each, which of them a person should be
// asked about, and which may be deleted without asking. Of a large one only the beginning and the end are read;
// on a worker's thread all the same.
#pragma once

#include <QDateTime>
#include <QString>
#include <QStringList>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/time.h"

namespace deckpipe {

struct Recording {
  QString path;
  QDateTime begin;                   // local time; of the file's name where the file does not say
  std::optional<Duration> length{};  // from the first frame to the last; nothing if their times do not tell
  std::uint64_t frames = 0;
  std::uint64_t bytes = 0;
  QStringList pins;          // of the devices that were heard, in the order in which they were
  QStringList adapters;      // in words, of its links
  bool isReadable = false;   // otherwise only path, begin and bytes are known
  bool isSaved = false;      // in a file of the person's own
  bool isGrowing = false;    // some program is writing it
  bool isWhole = false;      // it was ended, and all of it could be read
  bool isSimulated = false;  // of a simulated truck
  // Only its beginning and its end were read: its length is by the clock of the last frame, and more devices
  // and adapters may be in it.
  bool isGlanced = false;

  // It is all that there is of what was received: never deleted without asking.
  bool isUnsaved() const { return !isSaved && !isSimulated && !isGrowing; }

  friend bool operator==(const Recording&, const Recording&) = default;
};

// Where `deckpipe` keeps them, whichever program asks.
QString recordingsFolder();
// Files of more bytes are glanced at.
inline constexpr std::uint64_t kReadWhole = std::uint64_t{8} << 20;
Recording readRecording(const QString& path, std::uint64_t readWhole = kReadWhole);
// The newest first.
std::vector<Recording> recordingsIn(const QString& folder);

struct RecordingLimits {
  std::uint64_t maxBytes = std::uint64_t{2} << 30;  // of all recordings
  int maxDays = 30;
};
// Those that are beyond a limit and may go: saved ones, and those of the simulated truck. The oldest go first.
QStringList recordingsToDelete(std::vector<Recording> recordings, const RecordingLimits& limits,
                               const QDateTime& now);

}  // namespace deckpipe
