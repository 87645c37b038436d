// SPDX-License-Identifier: GPL-3.0-or-later
// A log from a pipe, of whatever format: the first bytes decide which, as with openLog().
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "base/result.h"
#include "log/log_format.h"
#include "log/text_marks.h"

namespace deckpipe {

class LogStream {
 public:
  // Of the options a pipe knows addsUpTimes alone.
  explicit LogStream(const LogTarget& target, std::span<const LogFormat> formats = logFormats(),
                     ReadOptions options = {})
      : m_target(target), m_formats(formats), m_options(std::move(options)) {}

  // False once it is clear that nothing more will be taken; finish() then says why. What is whole by then is
  // in the store when feed() returns.
  bool feed(std::string_view bytes);
  // The end of the log: what is left is read now. Once.
  Result<ReadSummary, ReadError> finish();

 private:
  bool feedPlain(std::string_view bytes);
  void decide(bool isWhole);

  const LogTarget m_target;
  std::span<const LogFormat> m_formats;
  ReadOptions m_options;
  Unmarker m_unmarker;
  Sniff m_sniff = Sniff::Open;
  std::string m_head;         // while it is open
  std::size_t m_sniffAt = 1;  // bytes of head
  const LogFormat* m_format = nullptr;
  std::unique_ptr<StreamReader> m_reader;
};

}  // namespace deckpipe
