// SPDX-License-Identifier: GPL-3.0-or-later
// The facts of the status strip as sentences: pure functions of a snapshot, so that every state can be
// tested without a window.
#pragma once

#include <QString>
#include <optional>

#include "model/bus_rates.h"
#include "panel/common/status_cell.h"
#include "session/snapshot.h"

namespace deckpipe {

struct StatusFact {
  Severity tone = Severity::Plain;
  QString text{};
  QString story{};  // the tooltip
  std::optional<Glyph> glyph{};
};

// The sentence for an error, with the system's own words where it has any; empty if there is no error.
QString sourceErrorText(const SourceError& error);
QString unkeptMarksText(const UnkeptMarks& marks);
// The title says where the frames come from: "can0 · 250 kbit/s", "Simulated truck", "truck.log".
QString sourceTitle(const SourceStatus& source);
StatusFact sourceFact(const SourceStatus& source);
StatusFact loadFact(const Snapshot& snapshot, const BusRates& rates);
StatusFact rateFact(const BusRates& rates);
StatusFact errorFact(const Snapshot& snapshot);
StatusFact lockFact(const Snapshot& snapshot);
// Our frames that the adapter has and the bus has not; without text if there are none.
StatusFact sentFact(const Snapshot& snapshot);
// The warning about so many frames, before their link is left.
QString waitingText(std::uint64_t frames);
StatusFact recordingFact(const Snapshot& snapshot);
// These say what became of a file that a recording gave up, and why a recording is not written at the moment.
QString givenUpText(const JournalFault& file);
QString recordingFaultText(const JournalStatus& recording);
StatusFact completenessFact(const Snapshot& snapshot);
// Frames that came and are not in a log, by what is known of them; without text if there are none.
struct MissingFrames {
  std::uint64_t count = 0;  // 0 where the recorder does not say how many it lost
  QString text{};
};
MissingFrames missingFrames(const LogDocument& log);

// The words alone, for how wide they may become.
QString loadWords(long percent);
QString rateWords(long frames);
QString errorWords(std::uint64_t errors);
QString recordingWords(bool isRunning, const QString& length, std::uint64_t frames);
QString unlockedWords(const ClaimStatus& claim);
// "1,234 frames": plurals take an int, logs may hold more.
QString frameCountText(std::uint64_t frames);

}  // namespace deckpipe
