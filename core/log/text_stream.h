// SPDX-License-Identifier: GPL-3.0-or-later
// A text log of any format from a pipe: bytes as they come, whole lines at once. What comes out is what
// readText() makes of the same text, however it is cut.
#pragma once

#include <memory>
#include <string>

#include "log/frame_store.h"
#include "log/log_format.h"
#include "log/skipped.h"
#include "log/text_appender.h"
#include "log/text_parser.h"

namespace deckpipe {

class TextStream final : public StreamReader {
 public:
  TextStream(std::unique_ptr<TextParser> parser, FrameStore& store, SkippedList& skipped,
             const ReadOptions& options)
      : m_parser(std::move(parser)), m_appender(store, skipped, options.addsUpTimes) {}

  bool feed(std::string_view bytes) override;
  Result<ReadSummary, ReadError> finish() override;

 private:
  void take(std::size_t size);
  void skip();

  std::unique_ptr<TextParser> m_parser;
  TextAppender m_appender;
  TextBlock m_block;
  ChannelMap m_channels;
  std::string m_pending;      // from the start of a line on
  bool m_isSkipping = false;  // m_pending is what is left of a line that was too long
  bool m_isFull = false;
};

}  // namespace deckpipe
