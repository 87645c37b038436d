// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/sidecar.h"

#include <zlib.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <system_error>
#include <utility>

#include "log/candump.h"
#include "log/log_bytes.h"
#include "log/note_text.h"

namespace deckpipe {
namespace {

using Kind = SidecarFault::Kind;

constexpr std::string_view kTitle = "Deckpipe notes ";
constexpr std::uint64_t kVersion = 1;
// No sidecar is longer: a million notes need less.
constexpr std::uint64_t kMaxBytes = std::uint64_t{128} << 20;

std::uint32_t crcOf(std::string_view text) {
  return static_cast<std::uint32_t>(
      crc32(0, reinterpret_cast<const Bytef*>(text.data()), static_cast<uInt>(text.size())));
}

std::string hexOf(std::uint32_t number) {
  char text[9];
  std::snprintf(text, sizeof text, "%08X", number);
  return text;
}

std::string lineOf(const Frame& frame, std::string_view channel) {
  std::string line;
  writeCandump(frame, channel, line);
  line.pop_back();
  return line;
}

bool takeWord(std::string_view& text, std::string_view word) {
  if (!text.starts_with(word)) return false;
  text.remove_prefix(word.size());
  return true;
}

template <typename T>
bool takeNumber(std::string_view& text, T& number) {
  const auto [p, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc()) return false;
  text.remove_prefix(static_cast<std::size_t>(p - text.data()));
  return true;
}

class SidecarParser {
 public:
  explicit SidecarParser(std::string_view text) : m_text(text), m_rest(text) {}

  Result<Sidecar, SidecarFault> run() {
    std::string_view line;
    std::uint64_t version = 0;
    if (!nextLine(line)) return fail(Kind::NoSidecar, 1);
    if (!takeWord(line, kTitle) || !takeNumber(line, version) || version == 0 || !line.empty())
      return fail(Kind::NoSidecar, 1);
    if (version > kVersion) return fail(Kind::NewerVersion, 1);
    for (std::size_t begin = done(); nextLine(line); begin = done()) {
      if (line.starts_with("end ")) return takeEnd(line, m_text.substr(0, begin));
      if (!takeLine(line)) return fail(Kind::BadLine, m_line);
    }
    return fail(Kind::Cut, m_line + 1);
  }

 private:
  static Failure<SidecarFault> fail(Kind kind, std::uint64_t line) { return {{kind, line, {}, {}}}; }
  std::size_t done() const { return m_text.size() - m_rest.size(); }

  // A line that has no end is none.
  bool nextLine(std::string_view& line) {
    const std::size_t end = m_rest.find('\n');
    if (end == std::string_view::npos) return false;
    line = m_rest.substr(0, end);
    m_rest.remove_prefix(end + 1);
    ++m_line;
    return true;
  }

  bool takeLine(std::string_view line) {
    if (takeWord(line, "frames ")) return m_line == 2 && takeNumber(line, m_sidecar.frames) && line.empty();
    if (takeWord(line, "first ")) return m_sidecar.first = line, m_line == 3;
    if (takeWord(line, "last ")) return m_sidecar.last = line, m_line == 4;
    if (takeWord(line, "channel ")) return m_sidecar.channels.emplace_back(line), true;
    return takeWord(line, "note ") && takeNote(line);
  }

  bool takeNote(std::string_view line) {
    Sidecar::PlacedNote note;
    std::int64_t after = 0;
    if (!takeNumber(line, note.frame) || !takeWord(line, " ") || !takeNumber(line, after) ||
        !takeWord(line, " "))
      return false;
    note.after = Duration{after};
    auto value = noteOfText(line);
    if (!value || note.frame > m_sidecar.frames) return false;
    if (!value.value()) {
      ++m_sidecar.newerParts;
      return true;
    }
    note.value = std::move(*value.value());
    const auto channel = channelOf(note.value);
    if (channel && channel->value >= m_sidecar.channels.size()) return false;
    m_sidecar.notes.push_back(std::move(note));
    return true;
  }

  Result<Sidecar, SidecarFault> takeEnd(std::string_view line, std::string_view before) {
    std::uint64_t lines = 0;
    takeWord(line, "end ");
    if (!takeNumber(line, lines) || !takeWord(line, " ")) return fail(Kind::BadLine, m_line);
    if (lines != m_line || line != hexOf(crcOf(before)) || !m_rest.empty())
      return fail(Kind::Changed, m_line);
    return std::move(m_sidecar);
  }

  const std::string_view m_text;
  std::string_view m_rest;
  std::uint64_t m_line = 0;
  Sidecar m_sidecar;
};

}  // namespace

// Times of notes before the first frame are told by that frame, once it has come.
void SidecarMaker::note(const Note& note) {
  m_sidecar.notes.push_back({m_sidecar.frames, note.time - m_time, note.value});
}

void SidecarMaker::frame(const Frame& frame, Instant time) {
  if (m_sidecar.frames == 0) {
    m_sidecar.first = lineOf(frame, m_sidecar.channels[frame.channel]);
    for (Sidecar::PlacedNote& note : m_sidecar.notes) note.after = Instant{note.after.count()} - time;
  }
  ++m_sidecar.frames;
  m_last = frame;
  m_time = time;
}

std::string SidecarMaker::text() const {
  if (m_sidecar.notes.empty()) return {};
  std::string text(kTitle);
  std::uint64_t lines = 0;
  const auto put = [&](std::string_view word, std::string_view rest) {
    text.append(word).append(rest) += '\n';
    ++lines;
  };
  put({}, std::to_string(kVersion));
  put("frames ", std::to_string(m_sidecar.frames));
  if (m_sidecar.frames > 0) {
    put("first ", m_sidecar.first);
    put("last ", lineOf(m_last, m_sidecar.channels[m_last.channel]));
  }
  for (const std::string& channel : m_sidecar.channels) put("channel ", channel);
  for (const Sidecar::PlacedNote& note : m_sidecar.notes) {
    std::string line = std::to_string(note.frame) + ' ' + std::to_string(note.after.count()) + ' ';
    appendNoteText(line, note.value);
    put("note ", line);
  }
  const std::string crc = hexOf(crcOf(text));
  put("end ", std::to_string(lines + 1) + ' ' + crc);
  return text;
}

std::string SidecarMaker::textOf(const FrameStore& frames, const NoteStore& notes) {
  SidecarMaker maker;
  Sidecar& sidecar = maker.m_sidecar;
  for (std::size_t i = 0; i < frames.channelCount(); ++i)
    maker.channel(frames.channelName(static_cast<std::uint8_t>(i)));
  sidecar.frames = frames.count();
  if (sidecar.frames > 0) {
    sidecar.first = lineOf(frames[0], sidecar.channels[frames[0].channel]);
    maker.m_last = frames[sidecar.frames - 1];
  }
  std::vector<Note> all = notes.all();
  if (const Instant ranUntil = notes.ranUntil(); ranUntil > frames.lastTime())
    all.push_back({.frame = sidecar.frames, .time = ranUntil, .value = note::RanUntil{}});
  for (const Note& note : all) {
    const std::uint64_t before = note.frame > 0 ? note.frame - 1 : 0;
    const Instant since = before < sidecar.frames ? frames.timeAt(before) : Instant{};
    sidecar.notes.push_back({note.frame, note.time - since, note.value});
  }
  return maker.text();
}

Result<Sidecar, SidecarFault> parseSidecar(std::string_view text) { return SidecarParser(text).run(); }

std::optional<SidecarFault> applySidecar(const Sidecar& sidecar, FrameStore& frames, NoteStore& notes) {
  const std::uint64_t count = frames.count();
  if (sidecar.frames != count)
    return SidecarFault{
        Kind::OtherCount, 2, {}, std::to_string(sidecar.frames) + ", " + std::to_string(count)};
  const auto isAt = [&](std::uint64_t i, const std::string& line) {
    return lineOf(frames[i], frames.channelName(frames[i].channel)) == line;
  };
  if (count > 0 && !isAt(0, sidecar.first)) return SidecarFault{Kind::OtherFrame, 3, {}, sidecar.first};
  if (count > 0 && !isAt(count - 1, sidecar.last)) return SidecarFault{Kind::OtherFrame, 4, {}, sidecar.last};
  std::vector<Channel> channels;
  for (const std::string& name : sidecar.channels) channels.push_back({frames.channel(name)});
  std::vector<const Sidecar::PlacedNote*> inOrder;
  for (const Sidecar::PlacedNote& placed : sidecar.notes) inOrder.push_back(&placed);
  std::ranges::stable_sort(inOrder, {},
                           [](const auto* placed) { return std::pair(placed->frame, placed->after); });
  for (const Sidecar::PlacedNote* const placed : inOrder) {
    Note note{.frame = placed->frame, .time = {}, .value = placed->value};
    if (const auto channel = channelOf(note.value)) setChannel(note.value, channels[channel->value]);
    // The log's stamps may be coarser than its times were: a note keeps its place between two frames.
    if (note.frame > 0) {
      const Instant before = frames.timeAt(note.frame - 1);
      note.time = std::max(before, before + placed->after);
    } else {
      note.time = (count > 0 ? frames.timeAt(0) : Instant{}) + placed->after;
    }
    if (note.frame < count) note.time = std::min(note.time, frames.timeAt(note.frame));
    notes.append(std::move(note));
  }
  return {};
}

bool hasSidecar(const std::string& logPath) {
  std::error_code none;
  return std::filesystem::exists(std::filesystem::symlink_status(sidecarPath(logPath), none));
}

void readSidecar(const std::string& logPath, FrameStore& frames, NoteStore& notes, ReadSummary& summary) {
  if (!hasSidecar(logPath)) return;
  const std::string path = sidecarPath(logPath);
  BytesOfFile file;
  std::vector<char> buffer;
  std::string_view text;
  std::string why = file.open(path);
  if (why.empty() && file.size() > kMaxBytes) why = std::generic_category().message(EFBIG);
  if (why.empty()) why = file.get(0, file.size(), buffer, text);
  if (!why.empty()) {
    summary.sidecarFault = {Kind::CannotRead, 0, path, std::move(why)};
    return;
  }
  const auto sidecar = parseSidecar(text);
  summary.sidecarFault =
      sidecar ? applySidecar(sidecar.value(), frames, notes) : std::optional(sidecar.error());
  if (summary.sidecarFault) {
    summary.sidecarFault->path = path;
  } else {
    summary.hasSidecar = true;
    summary.newerParts += sidecar.value().newerParts;
  }
}

}  // namespace deckpipe
