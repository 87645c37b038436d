// SPDX-License-Identifier: GPL-3.0-or-later
// Arbitrary text as a sidecar: as it is, and as lines between a right first and last one, so that every line
// is reached. No crash; what was read fits its own log, and each note, written again, is read as the same.
#include <zlib.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "log/note_text.h"
#include "log/sidecar.h"

namespace {

using namespace deckpipe;

void demand(bool condition) {
  if (!condition) std::abort();
}

void read(std::string_view text) {
  const auto sidecar = parseSidecar(text);
  if (!sidecar) return;
  for (const Sidecar::PlacedNote& note : sidecar.value().notes) {
    std::string again;
    appendNoteText(again, note.value);
    const auto value = noteOfText(again);
    demand(bool(value) && value.value() == note.value);
  }
  FrameStore frames{{.memoryBytes = 64 << 20, .spillFolder = "/nonexistent"}};
  NoteStore notes;
  const auto fault = applySidecar(sidecar.value(), frames, notes);
  const auto isKept = [](const Sidecar::PlacedNote& note) {
    return !std::holds_alternative<note::RanUntil>(note.value);
  };
  demand(std::ptrdiff_t(notes.count()) == (fault ? 0 : std::ranges::count_if(sidecar.value().notes, isKept)));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string input(reinterpret_cast<const char*>(data), size);
  read(input);
  std::string text = "Deckpipe notes 1\n" + input + "\n";
  std::uint64_t lines = 1;
  for (const char c : text) lines += c == '\n' ? 1 : 0;
  const auto crc = crc32(0, reinterpret_cast<const Bytef*>(text.data()), static_cast<uInt>(text.size()));
  char end[64];
  std::snprintf(end, sizeof end, "end %llu %08lX\n", static_cast<unsigned long long>(lines), crc);
  read(text + end);
  return 0;
}
