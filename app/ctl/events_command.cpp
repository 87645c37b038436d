// SPDX-License-Identifier: GPL-3.0-or-later
// deckpipectl events: what changed in a log, and when.
#include <algorithm>
#include <cstdio>

#include "command.h"
#include "event_lines.h"
#include "log_input.h"
#include "node_lines.h"
#include "output.h"
#include "state/advance.h"
#include "state/event_walk.h"

namespace deckpipe::ctl {
namespace {

// Walks the store as it grows, and tells events and notes in the order of their times.
class EventTeller {
 public:
  EventTeller(const LogInput& input, bool asJson)
      : m_frames(input.frames), m_notes(input.notes), m_lines(input.frames, asJson) {}

  // Everything that has come since the last call. False where standard output takes no more.
  bool tellNew() {
    const std::uint64_t count = m_frames.count();
    return count == 0 || tellUntil(cursorAfter(m_frames, count), count);
  }
  // Tells what falls due behind the last frame, and the notes there. To be called once the log is read.
  bool tellRest() {
    const std::uint64_t count = m_frames.count();
    return count == 0 || tellUntil(endOf(m_frames, m_notes), count + 1);
  }

  const State& state() const { return m_walk.state(); }

 private:
  // Events up to `end`, and notes before frame `noteEnd`.
  bool tellUntil(Cursor end, std::uint64_t noteEnd) {
    m_found.clear();
    m_walk.advance(m_frames, m_notes, end, m_found);
    std::vector<Note> notes = m_notes.between(m_told, noteEnd);
    std::erase_if(notes, [](const Note& note) { return !isEvent(note.value); });
    m_told = noteEnd;
    auto note = notes.begin();
    for (const Event& event : m_found) {
      for (; note != notes.end() && std::pair(note->time, note->frame) < std::pair(event.time, event.frame);
           ++note)
        m_lines.append(m_output.text(), *note);
      m_lines.append(m_output.text(), event);
    }
    for (; note != notes.end(); ++note) m_lines.append(m_output.text(), *note);
    return m_output.flush();
  }

  const FrameStore& m_frames;
  const NoteStore& m_notes;
  EventLines m_lines;
  EventWalk m_walk;
  std::vector<Event> m_found;
  std::uint64_t m_told = 0;  // notes before this frame
  Output m_output;
};

}  // namespace

ExitStatus eventsCommand(const QStringList& given) {
  Arguments arguments(
      given, R"(Says what changed in a log and when, one line each: time (seconds since the begin; - in a log
without times), channel, device (PIN, address or node), weight and what happened.
With --json: event, t (seconds as 'deckpipectl decode' has them; null in a log without times),
channel, pin, address or node, weight (info, warning, fault) and what stands in brackets below;
since (t) and folded (changes right before that were left out, as they came too fast for a reader)
where they say something. What is beyond )" +
                 std::to_string(kMaxDevices) + " devices or " + std::to_string(kMaxChannels) +
                 R"( channels is not
followed: that is said on standard error.

)" + eventKeysHelp());
  arguments.addArgument("FILE", logArgumentHelp());
  arguments.add({{"json", "One JSON object a line."}, deltasOption()});
  if (const auto status = arguments.parse()) return *status;

  LogInput input(arguments);
  EventTeller teller(input, arguments.has("json"));
  bool written = true;
  const ExitStatus status = input.read([&] { return written = teller.tellNew(); });
  written = written && teller.tellRest();
  const std::vector<std::string> untracked = untrackedLines(teller.state());
  for (const std::string& line : untracked)
    std::fprintf(stderr, "%s: %s\n", input.name().c_str(), line.c_str());
  return written && (status != kDone || untracked.empty()) ? status : kNotWhole;
}

}  // namespace deckpipe::ctl
