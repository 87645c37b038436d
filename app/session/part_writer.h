// SPDX-License-Identifier: GPL-3.0-or-later
// Writes a part of a log, with the notes that belong to it, through the writer of a format (log_writer.h). A
// part that does not begin at the log's first frame begins with the frames that tell who is who then
// (in_force.h), and with a note that they were added. So are those that a filter holds back later in the part:
// without them it would show a device under the address or the PIN of another one. The filter is noted too, and every
// one through which the log itself was saved before. Its channels are numbered in
// the order in which it names them.
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <stop_token>
#include <string>
#include <vector>

#include "log/log_writer.h"
#include "state/log_view.h"

namespace deckpipe {

// What a person calls devices; they are noted where each is announced.
using LabelsByPin = std::map<Pin, std::string>;

class PartWriter {
 public:
  struct Span {
    std::uint64_t begin = 0;
    std::uint64_t end = 0;       // not beyond the frames there are
    bool isToEnd = false;        // what is noted behind its last frame belongs to it
    bool isFiltered = false;     // not every frame of it is written
    NoteText filter{};           // as the person wrote it, if it is
    Instant ranUntil = kNotYet;  // NoteStore::ranUntil(); told of a part to the end
    std::uint64_t missing = 0;   // ReadSummary::missing() of the log's own file
  };
  // What is written is appended to `out`.
  PartWriter(const LogDocument& log, const Span& span, const LabelsByPin& labels, LogWriter& writer,
             std::string& out);

  // The next frame of the part; false if it was stopped meanwhile.
  bool frame(std::uint64_t i, const std::stop_token& stop);
  // The next frame of the part does not pass its filter.
  void heldBack(std::uint64_t i);
  void end();

  std::uint64_t written() const { return m_written; }  // frames of the part
  std::uint64_t added() const { return m_added; }      // frames that were added

 private:
  void noteFilters(Instant time);
  void noteInForce();
  bool addInForce(std::uint64_t i, const std::stop_token& stop);
  void passNotes(std::uint64_t before);
  void addedUntil(std::uint64_t i);
  void noteLeftOut();
  void write(const Frame& frame, Instant time);
  void write(NoteValue value, Instant time);
  std::uint8_t channel(std::uint8_t of);

  const LogDocument& m_log;
  const Span m_span;
  const LabelsByPin& m_labels;
  LogWriter& m_writer;
  std::string& m_out;
  const std::vector<Note> m_notes;
  std::size_t m_nextNote = 0;
  std::map<std::uint8_t, std::uint8_t> m_channels;
  std::set<Pin> m_labelled;
  std::uint64_t m_wereAdded = 0;  // frames of the log below this were added when it was saved
  std::uint64_t m_saidAdded = 0;  // and that is noted of those below this
  LogTimes m_times;
  std::uint64_t m_written = 0;
  std::uint64_t m_added = 0;
};

}  // namespace deckpipe
