// SPDX-License-Identifier: GPL-3.0-or-later
#include "log_input.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cinttypes>
#include <cstdio>
#include <cstring>
#include <optional>
#include <thread>

#include "counts.h"
#include "log/delta_times.h"
#include "log/log_stream.h"
#include "log/sidecar.h"
#include "log/time_grain.h"
#include "output.h"

namespace deckpipe::ctl {
namespace {

void complain(const std::string& name, const std::string& text) {
  std::fprintf(stderr, "deckpipectl: %s: %s\n", name.c_str(), text.c_str());
}

std::string_view textOf(LastLine line) {
  switch (line) {
    case LastLine::Whole: return {};
    case LastLine::Open: return "the last line has no line end: it may be cut";
    case LastLine::LeftOut:
      return "the last line has no line end, and its frame has fewer bytes than before: it is cut and was "
             "left out";
  }
  return {};
}

std::string textOf(const ReadError& error) {
  std::string text;
  if (error.kind == ReadError::Kind::UnknownFormat) {
    text = error.format.empty() ? std::string(readErrorText(error.kind))
                                : "seems to be " + error.format + ", which cannot be read";
    return text + (error.format.empty() ? ": " : "; formats that can: ") + formatNames(LogUse::Read);
  }
  if (!error.format.empty()) text = error.format + ": ";
  text += readErrorText(error.kind);
  if (!error.detail.empty()) text += ": " + error.detail;
  return text;
}

}  // namespace

std::string logArgumentHelp() {
  return "Log to read (" + formatNames(LogUse::Read) + "); - is standard input (" +
         formatNames(LogUse::ReadFromPipe) + ").";
}

Arguments::Option deltasOption() {
  return {"deltas", "The times are differences, each to the frame before: add them up."};
}

ExitStatus LogInput::read(const std::function<bool()>& more) {
  if (path == "-") return readStream(STDIN_FILENO, more);
  struct stat facts {};
  if (::stat(path.c_str(), &facts) != 0 || S_ISREG(facts.st_mode) || S_ISDIR(facts.st_mode)) {
    m_hasBytes = facts.st_size > 0;
    return readFile(more);
  }
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return ended(Failure{ReadError{ReadError::Kind::CannotOpen, std::strerror(errno)}});
  const ExitStatus status = readStream(descriptor, more);
  ::close(descriptor);
  return status;
}

ExitStatus LogInput::readFile(const std::function<bool()>& more) {
  std::atomic<unsigned> published = 0;  // grows whenever there is something new, the end included
  std::atomic<bool> wanted = true;
  std::atomic<bool> hasEnded = false;
  std::optional<Result<ReadSummary, ReadError>> outcome;
  // The notes of a sidecar are there once all frames are.
  const bool isShownAsItComes = !hasSidecar(path);
  const auto publish = [&] {
    published.fetch_add(1);
    published.notify_one();
  };
  std::thread reader([&] {
    ReadOptions options;
    options.threads = 2;
    options.addsUpTimes = addsUpTimes;
    options.onProgress = [&](const ReadProgress&) {
      if (isShownAsItComes) publish();
      return wanted.load();
    };
    outcome.emplace(openLog(path, {frames, skipped, &notes}, options));
    hasEnded = true;
    publish();
  });
  for (unsigned seen = 0; !hasEnded;) {
    published.wait(seen);
    seen = published;
    if (wanted && !more()) wanted = false;
  }
  reader.join();
  if (wanted) more();
  return ended(*outcome);
}

ExitStatus LogInput::readStream(int descriptor, const std::function<bool()>& more) {
  ReadOptions options;
  options.addsUpTimes = addsUpTimes;
  LogStream stream({frames, skipped, &notes}, logFormats(), options);
  std::array<char, 64 * 1024> buffer;
  std::string failure;
  for (;;) {
    const ssize_t got = ::read(descriptor, buffer.data(), buffer.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) failure = std::strerror(errno);
    if (got <= 0) break;
    m_hasBytes = true;
    if (!stream.feed({buffer.data(), static_cast<std::size_t>(got)}) || !more()) break;
  }
  auto outcome = stream.finish();
  more();
  if (!failure.empty()) outcome = Failure{ReadError{ReadError::Kind::CannotRead, failure}};
  return ended(outcome);
}

bool LogInput::sayMissing(const ReadSummary& summary) const {
  const Damage& damage = summary.damage;
  const auto say = [this](const std::string& text) {
    std::fprintf(stderr, "%s: %s\n", name().c_str(), text.c_str());
  };
  if (damage.places > 0)
    say("damaged in " + counted(damage.places, "place", "places") + ", the first at byte " +
        std::to_string(damage.firstAt) + "; " + counted(damage.bytes, "byte", "bytes") +
        " could not be read");
  if (damage.isOpen) say("how many frames are missing at its end is not known");
  if (const auto text = textOf(summary.lastLine); !text.empty()) say(std::string(text));
  if (summary.cutBytes == 1) say("the last byte is not whole and was left out");
  if (summary.cutBytes > 1)
    say("the last " + std::to_string(summary.cutBytes) + " bytes are not whole and were left out");
  if (summary.newerParts > 0)
    say(counted(summary.newerParts, "part of a newer version of Deckpipe was left out",
                "parts of a newer version of Deckpipe were left out"));
  if (summary.goesOn)
    say("the recording still goes on");
  else if (summary.isOpenEnded)
    say("the recording has no end: its last second may be missing");
  if (const auto& fault = summary.sidecarFault) {
    std::string where = fault->path;
    if (fault->line > 0) where += ":" + std::to_string(fault->line);
    std::string text(sidecarFaultText(fault->kind));
    if (!fault->detail.empty()) text += ": " + fault->detail;
    complain(where, text + "; the log was read without its notes");
  }
  return summary.isWhole();
}

bool LogInput::sayMissed() const {
  using Why = note::LeftOut::Why;
  std::uint64_t lost = 0, leftOut = 0, lines = 0, places = 0, notWhole = 0, damaged = 0;
  for (const Note& note : notes.all()) {
    (std::holds_alternative<note::Dropped>(note.value) ? lost : leftOut) += framesMissed(note.value);
    const auto* noted = std::get_if<note::LeftOut>(&note.value);
    if (noted != nullptr && noted->why == Why::Unreadable) lines += noted->count;
    if (noted != nullptr && noted->why == Why::RecorderLost) places += noted->count;
    if (noted != nullptr && noted->why == Why::NotWhole) notWhole += noted->count;
    if (noted != nullptr && noted->why == Why::Damaged) damaged += noted->count;
  }
  if (lost > 0)
    std::fprintf(stderr, "%s: %s lost while it was recorded\n", name().c_str(),
                 framesThat(lost, "was", "were").c_str());
  leftOut -= damaged;
  if (damaged > 0)
    complain(name(), framesThat(damaged, "is", "are") + " missing where the recording is damaged");
  if (leftOut > 0)
    std::fprintf(stderr, "%s: %s came that it cannot hold: CAN FD, or not classic CAN\n", name().c_str(),
                 framesText(leftOut).c_str());
  if (places > 0)
    complain(name(), "the recorder lost frames at " + counted(places, "place", "places") + ", as it says");
  if (lines > 0)
    complain(name(), counted(lines, "line", "lines") +
                         " of the file that it was saved from could not be read and are not in it");
  if (notWhole > 0)
    complain(name(), "the file that it was saved from was not whole at " +
                         counted(notWhole, "place", "places") + ": what stood there is not in it");
  return leftOut + lines + notWhole + damaged > 0;
}

bool LogInput::hasDeltas() const { return !addsUpTimes && hasDeltaTimes(frames); }

void LogInput::sayFiltered() const {
  for (const std::string& filter : notes.filters())
    complain(name(), "it was saved through the filter '" + printable(filter) +
                         "': what did not pass it is missing, so silence, late messages and missing answers "
                         "are not told");
}

ExitStatus LogInput::ended(const Result<ReadSummary, ReadError>& outcome) {
  const SkippedPlaces content = skipped.content();
  saySkipped(content);
  if (hasDeltas())
    complain(name(), "its times look like differences, each to the frame before; --deltas adds them up");
  // Fractions that were not read are said already.
  if (content.count(Skipped::Fraction) == 0 && timeGrainOf(frames) == TimeGrain::Seconds)
    complain(name(),
             "its times are good to the second only; nothing that takes less is told of gaps and time-outs");
  sayFiltered();
  if (outcome) lastLine = outcome.value().lastLine;
  if (!outcome) {
    complain(name(), textOf(outcome.error()));
    return frames.count() > 0 ? kNotWhole : kCannotRead;
  }
  const bool isWhole = sayMissing(outcome.value());
  const bool hasMissed = sayMissed() || content.unreadable() > 0 || content.skipped() > 0;
  if (frames.count() == 0 && !outcome.value().cancelled) {
    // Why it holds none was said of what it holds.
    if (!hasMissed) complain(name(), m_hasBytes ? "it holds no frame" : "it is empty");
    return kNothingRead;
  }
  return isWhole && !hasMissed && content.count(Skipped::Fraction) == 0 ? kDone : kNotWhole;
}

void LogInput::saySkipped(const SkippedPlaces& content) const {
  EnumArray<Skipped, std::uint64_t> said;
  for (const SkippedPlace& place : content.places()) {
    if (!isUnreadable(place.reason)) continue;
    const std::string_view reason = skippedText(place.reason);
    std::fprintf(stderr, "%s:%" PRIu64 ": %.*s\n", name().c_str(), place.place,
                 static_cast<int>(reason.size()), reason.data());
    ++said[place.reason];
  }
  for (const Skipped reason : kAllOf<Skipped>) {
    const std::uint64_t rest = content.count(reason) - said[reason];
    if (rest == 0) continue;
    const std::string_view text = skippedText(reason);
    const std::string count =
        isUnreadable(reason) ? counted(rest, "more line", "more lines") : std::to_string(rest) + " not kept";
    std::fprintf(stderr, "%s: %s: %.*s\n", name().c_str(), count.c_str(), static_cast<int>(text.size()),
                 text.data());
  }
}

}  // namespace deckpipe::ctl
