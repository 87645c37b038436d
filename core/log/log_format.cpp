// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/log_format.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "log/candump.h"
#include "log/foreign_formats.h"
#include "log/journal_reader.h"
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

Result<ReadSummary, ReadError> readPlain(const LogBytes& bytes, const LogTarget& target,
                                         const ReadOptions& options, std::span<const LogFormat> formats) {
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
  auto result = format->read(bytes, target, options);
  if (result) return result;
  ReadError error = result.error();
  error.format = format->name;
  return Failure{std::move(error)};
}

}  // namespace

std::span<const LogFormat> logFormats() { return kFormats; }

Result<ReadSummary, ReadError> openLog(const std::string& path, const LogTarget& target,
                                       const ReadOptions& options, std::span<const LogFormat> formats) {
  BytesOfFile file;
  if (std::string why = file.open(path); !why.empty())
    return Failure{ReadError{ReadError::Kind::CannotOpen, std::move(why)}};
  return readLog(file, target, options, formats);
}

Result<ReadSummary, ReadError> readLog(const LogBytes& bytes, const LogTarget& target,
                                       const ReadOptions& options, std::span<const LogFormat> formats) {
  std::vector<char> buffer;
  std::string_view head;
  if (std::string why = bytes.get(0, std::min<std::uint64_t>(bytes.size(), kMaxTextMark), buffer, head);
      !why.empty())
    return Failure{ReadError{ReadError::Kind::CannotRead, std::move(why)}};
  const TextMark mark = textMarkOf(head);
  if (mark == TextMark::None) return readPlain(bytes, target, options, formats);
  return readPlain(UnmarkedBytes(bytes, mark), target, options, formats);
}

const LogFormat& formatToWrite(std::string_view fileName, std::span<const LogFormat> formats) {
  const LogFormat* first = nullptr;
  for (const LogFormat& format : formats) {
    if (format.write == nullptr) continue;
    if (hasPatternOf(format, fileName)) return format;
    if (first == nullptr) first = &format;
  }
  return *first;
}

std::string formatNames(LogUse use, std::span<const LogFormat> formats) {
  std::string names;
  for (const LogFormat& format : formats) {
    if (use == LogUse::ReadFromPipe && format.stream == nullptr) continue;
    if (use == LogUse::Write && format.write == nullptr) continue;
    if (!names.empty()) names += ", ";
    names += format.name;
  }
  return names;
}

}  // namespace deckpipe
