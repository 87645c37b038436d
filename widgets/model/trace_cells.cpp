// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/trace_cells.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <string>

#include "bus/canopen.h"
#include "bus/j1939.h"
#include "model/field_text.h"
#include "model/log_walk.h"
#include "model/message_text.h"
#include "protocol/decode.h"
#include "report/json.h"
#include "report/trace_text.h"
#include "text/catalogue_text.h"
#include "text/device_text.h"
#include "text/j1939_text.h"

namespace deckpipe {
namespace {

struct TraceCells {
  Q_DECLARE_TR_FUNCTIONS(TraceCells)
};

constexpr QChar kDash(0x2013);
constexpr QChar kArrow(0x2192);

QString secondsText(std::int64_t ns) {
  std::string text;
  appendJsonSeconds(text, ns);
  return toQString(text);
}

}  // namespace

QString stampText(const Frame& frame) { return frame.hasStamp() ? secondsText(frame.stamp) : QString(kDash); }

QString sinceText(Duration since) { return secondsText(since.count()); }

QString deltaText(std::optional<Duration> delta) {
  if (!delta) return {};
  QString text = secondsText(delta->count());
  // Of a long pause microseconds are not worth a cut-off number.
  if (*delta >= 1000s) text.chop(3);
  return text;
}

QString identifierText(const Frame& frame) {
  std::string text;
  appendIdentifier(text, frame);
  return toQString(text);
}

QString pgnText(const Frame& frame) {
  if (!frame.isExtended() || frame.isError()) return {};
  return hexText(J1939Id::of(frame.identifier()).pgn, 4);
}

QString endsText(const Frame& frame) {
  if (frame.isError()) return {};
  if (frame.isExtended()) {
    const J1939Id id = J1939Id::of(frame.identifier());
    const QString source = hexText(id.source.value, 2);
    return id.hasDestination() ? source + kArrow + hexText(id.destination.value, 2) : source;
  }
  const CobId cob = CobId::of(frame.identifier());
  return cob.hasNode() ? TraceCells::tr("node %1").arg(hexText(cob.node.value, 2)) : QString();
}

QString bytesText(const Frame& frame) {
  if (frame.isRemote()) return TraceCells::tr("remote, length %1").arg(frame.length);
  QString text;
  for (const std::uint8_t byte : frame.bytes()) {
    if (!text.isEmpty()) text += QLatin1Char(' ');
    text += hexText(byte, 2);
  }
  return text;
}

QString directionText(const Frame& frame) {
  return (frame.flags & Frame::kSent) != 0 ? TraceCells::tr("Tx") : TraceCells::tr("Rx");
}

QString detailText(const TraceRow& row) {
  QStringList lines;
  if (!row.title.isEmpty()) lines += row.title;
  if (const QString certainty = certaintyText(row.frame, row.what); !certainty.isEmpty()) lines += certainty;
  if (row.frame.isExtended() && !row.frame.isError()) {
    const J1939Id id = J1939Id::of(row.frame.identifier());
    for (const Address end : {id.source, id.destination}) {
      if (const QString use = usualUse(end); !use.isEmpty())
        lines += TraceCells::tr("%1: %2, which is no proof", "address, use").arg(addressText(end), use);
    }
  }
  if (row.frame.isError() && !row.summary.isEmpty()) lines += row.summary;
  if (row.what.isDecoded()) {
    const Message& message = messageOf(row.what.message);
    for (const Field& field : message.fields) {
      if (!isPresent(field, row.frame)) continue;
      lines += TraceCells::tr("%1: %2").arg(fieldName(field), valueText(field, valueOf(field, row.frame)));
    }
  }
  if (const QString source = sourceText(row.what.message); !source.isEmpty()) lines += source;
  return lines.join(QLatin1Char('\n'));
}

namespace {

// So short a way is walked on; a longer one is left to the index.
constexpr std::uint64_t kNear = 64;

}  // namespace

std::vector<TraceRow> readTraceRows(const LogDocument& log, std::span<const std::uint64_t> frames,
                                    std::optional<std::uint64_t> before, std::span<const TraceRow> known) {
  std::vector<TraceRow> rows;
  rows.reserve(frames.size());
  LogTimes times(log.frames);
  std::optional<Instant> timeBefore;
  const bool hasTimes = log.frames.hasTimes();
  if (before) timeBefore = times.at(*before);
  const std::uint64_t built = log.roles.built();
  std::optional<LogWalk> walk;
  for (const std::uint64_t i : frames) {
    const auto old = std::lower_bound(known.begin(), known.end(), i,
                                      [](const TraceRow& row, std::uint64_t at) { return row.index < at; });
    const bool isKnown = old != known.end() && old->index == i;
    TraceRow row;
    row.index = i;
    row.frame = log.frames[i];
    const Instant time = times.at(i);
    if (timeBefore && hasTimes) row.delta = time - *timeBefore;
    timeBefore = time;
    if (isKnown && old->isSettled) {
      row.what = old->what;
      row.isSettled = true;
    } else {
      if (!walk || walk->next() > i || i - walk->next() > kNear) walk.emplace(log, i);
      while (walk->next() < i) {
        const std::uint64_t between = walk->next();
        walk->take(log.frames[between], times.at(between));
      }
      row.what = walk->take(row.frame, time);
      row.isSettled = i < built;
    }
    if (isKnown && old->what == row.what) {
      row.title = old->title;
      row.summary = old->summary;
    } else {
      row.title = frameTitle(row.frame, row.what);
      row.summary = summaryText(row.frame, row.what);
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

Classified classifyAt(const LogDocument& log, std::uint64_t index) {
  LogWalk walk(log, index);
  return walk.take(log.frames[index], log.frames.timeAt(index));
}

}  // namespace deckpipe
