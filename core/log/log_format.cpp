// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/log_format.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "log/candump.h"
#include "log/foreign_formats.h"
#include "log/journal_file.h"
#include "log/journal_reader.h"
#include "log/sidecar.h"
#include "log/text_marks.h"

namespace deckpipe {
namespace {

constexpr LogFormat kFormats[] = {kJournalFormat, kCandumpFormat};

bool hasPatternOf(const LogFormat& format, std::string_view fileName) {
  std::string_view rest = format.patterns;
  while (!rest.empty()) {
    std::string_view suffix = rest.substr(0, rest.find(' '));
    rest.remove_prefix(std::min(suffix.size() + 1, rest.size()));
    suffix.remove_prefix(1);  // the '*'
    if (fileName.ends_with(suffix)) return true;
  }
  return false;
}

// The format, or that there is none.
Result<const LogFormat*, ReadError> formatOf(const LogBytes& bytes, std::span<const LogFormat> formats) {
  std::vector<char> buffer;
  std::string_view head;
  const std::uint64_t size = std::min<std::uint64_t>(bytes.size(), kSniffBytes);
  if (std::string why = bytes.get(0, size, buffer, head); !why.empty())
    return Failure{ReadError{ReadError::Kind::CannotRead, std::move(why)}};
  const auto format = std::ranges::find_if(formats, [&](const LogFormat& candidate) {
    return candidate.sniff(head, size == bytes.size()) == Sniff::Yes;
  });
  if (format == formats.end())
    return Failure{ReadError{ReadError::Kind::UnknownFormat, {}, std::string(foreignFormat(head))}};
  return &*format;
}

// `path`: of the file that the bytes are, for its sidecar; empty for none.
Result<ReadSummary, ReadError> readPlain(const LogBytes& bytes, const std::string& path,
                                         const LogTarget& target, const ReadOptions& options,
                                         std::span<const LogFormat> formats) {
  const auto format = formatOf(bytes, formats);
  if (!format) return Failure{format.error()};
  auto result = format.value()->read(bytes, target, options);
  if (!result) {
    ReadError error = result.error();
    error.format = format.value()->name;
    return Failure{std::move(error)};
  }
  result.value().isOwn = format.value()->isOwn;
  const bool mayHaveSidecar = !path.empty() && !format.value()->isOwn && target.notes != nullptr;
  if (mayHaveSidecar && !result.value().cancelled) {
    result.value().mayHaveSidecar = true;
    readSidecar(path, target.frames, *target.notes, result.value());
  }
  return result;
}

Result<ReadSummary, ReadError> readMarked(const LogBytes& bytes, const std::string& path,
                                          const LogTarget& target, const ReadOptions& options,
                                          std::span<const LogFormat> formats) {
  std::vector<char> buffer;
  std::string_view head;
  if (std::string why = bytes.get(0, std::min<std::uint64_t>(bytes.size(), kMaxTextMark), buffer, head);
      !why.empty())
    return Failure{ReadError{ReadError::Kind::CannotRead, std::move(why)}};
  const TextMark mark = textMarkOf(head);
  if (mark == TextMark::None) return readPlain(bytes, path, target, options, formats);
  return readPlain(UnmarkedBytes(bytes, mark), path, target, options, formats);
}

}  // namespace

std::span<const LogFormat> logFormats() { return kFormats; }

Result<ReadSummary, ReadError> openLog(const std::string& path, const LogTarget& target,
                                       const ReadOptions& options, std::span<const LogFormat> formats) {
  BytesOfFile file;
  if (std::string why = file.open(path); !why.empty())
    return Failure{ReadError{ReadError::Kind::CannotOpen, std::move(why)}};
  const bool goesOn = isBeingWritten(path);
  auto outcome = readMarked(file, path, target, options, formats);
  if (outcome) outcome.value().goesOn = goesOn && outcome.value().isOpenEnded;
  return outcome;
}

Result<ReadSummary, ReadError> readLog(const LogBytes& bytes, const LogTarget& target,
                                       const ReadOptions& options, std::span<const LogFormat> formats) {
  return readMarked(bytes, {}, target, options, formats);
}

const LogFormat& formatToWrite(std::string_view fileName, std::span<const LogFormat> formats) {
  const LogFormat* first = nullptr;
  for (const LogFormat& format : formats) {
    if (format.makeWriter == nullptr) continue;
    if (hasPatternOf(format, fileName)) return format;
    if (first == nullptr && !format.isOwn) first = &format;
  }
  return *first;
}

std::string formatNames(LogUse use, std::span<const LogFormat> formats) {
  std::string names;
  for (const LogFormat& format : formats) {
    if (use == LogUse::ReadFromPipe && format.stream == nullptr) continue;
    if (use == LogUse::Write && format.makeWriter == nullptr) continue;
    if (!names.empty()) names += ", ";
    names += format.name;
  }
  return names;
}

}  // namespace deckpipe
