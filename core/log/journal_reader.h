// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a journal (journal_bytes.h), as a format of the table in log_format.h: its frames with the log times
// that they had, its channels and its notes. One that is still being written is read as far as it is whole
// now. What is damaged is left out and counted; all blocks that are whole are read. A channel whose name is lost is
// called "name-lost-0", by its place.
#pragma once

#include "log/journal_export.h"
#include "log/log_format.h"

namespace deckpipe {

Sniff sniffJournal(std::string_view head, bool isWhole);
Result<ReadSummary, ReadError> readJournal(const LogBytes& bytes, const LogTarget& target,
                                           const ReadOptions& options);

// The same of one that comes through a pipe, block by block.
std::unique_ptr<StreamReader> streamJournal(const LogTarget& target, const ReadOptions& options);

inline constexpr LogFormat kJournalFormat{.name = "Deckpipe recording",
                                          .patterns = "*.deckpipe",
                                          .sniff = sniffJournal,
                                          .read = readJournal,
                                          .stream = streamJournal,
                                          .makeWriter = makeJournalExport,
                                          .isOwn = true};

}  // namespace deckpipe
