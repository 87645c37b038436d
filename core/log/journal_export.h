// SPDX-License-Identifier: GPL-3.0-or-later
// Writes a log that is there, or a part of it, as a journal (journal_bytes.h): how a format of the table in
// log_format.h is saved. A recording that grows is written by JournalWriter.
#pragma once

#include <memory>

#include "log/log_writer.h"

namespace deckpipe {

std::unique_ptr<LogWriter> makeJournalExport();

}  // namespace deckpipe
