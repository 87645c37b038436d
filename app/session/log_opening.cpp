// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/log_opening.h"

#include <QFile>

#include "session/mark_keeper.h"

namespace deckpipe {

LogOpening::LogOpening(std::shared_ptr<LogDocument> document, const QString& path, bool addsUpTimes)
    : m_thread([this, addsUpTimes, document = std::move(document), path](const std::stop_token& stop) {
        ReadOptions options;
        options.addsUpTimes = addsUpTimes;
        options.threads = 2;
        options.onProgress = [&](const ReadProgress& progress) {
          if (progress.bytesTotal != 0) {
            m_fraction.store(
                static_cast<double>(progress.bytesDone) / static_cast<double>(progress.bytesTotal),
                std::memory_order_relaxed);
          }
          return !stop.stop_requested();
        };
        m_sidecarTime = deckpipe::sidecarTime(path);
        const std::string file = QFile::encodeName(path).toStdString();
        m_outcome.emplace(openLog(file, {document->frames, document->skipped, &document->notes}, options));
        m_ended.store(true, std::memory_order_release);
      }) {}

LogOpening::~LogOpening() = default;

}  // namespace deckpipe
