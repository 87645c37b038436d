// SPDX-License-Identifier: GPL-3.0-or-later
// Reads text logs of any format: block by block, on two threads if wanted, with progress and cancelling.
// Frames, channel order, reports and summary do not depend on threads or block size. Blank lines and comments
// are skipped; everything else that is no frame is reported with its line and reason, and reading goes on.
#pragma once

#include <memory>
#include <string_view>

#include "base/result.h"
#include "log/frame_store.h"
#include "log/log_bytes.h"
#include "log/reading.h"
#include "log/skipped.h"
#include "log/text_parser.h"

namespace deckpipe {

// One for each thread.
using MakeTextParser = std::unique_ptr<TextParser> (*)();

Result<ReadSummary, ReadError> readText(const LogBytes& bytes, MakeTextParser makeParser, FrameStore& store,
                                        SkippedList& skipped, const ReadOptions& options);

// Whether a text is a log of the parser's format, by the lines that begin in its first 64 kB: one that is
// understood says yes; unreadable ones and none that is understood say no. An empty text is an empty log.
Sniff sniffText(TextParser& parser, std::string_view head, bool isWhole);

}  // namespace deckpipe
