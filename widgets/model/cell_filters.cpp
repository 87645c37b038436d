// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/cell_filters.h"

#include <QCoreApplication>

#include "bus/canopen.h"
#include "bus/j1939.h"
#include "model/field_text.h"
#include "model/message_text.h"
#include "model/trace_cells.h"
#include "model/trace_model.h"
#include "protocol/catalogue.h"

namespace deckpipe {
namespace {

struct CellFilters {
  Q_DECLARE_TR_FUNCTIONS(CellFilters)
};

// In parentheses where something beside it would be read otherwise.
QString asPart(const QString& expression) {
  const bool isPlain =
      !expression.contains(u'|') && !expression.contains(QLatin1String("or"), Qt::CaseInsensitive);
  return isPlain ? expression : u'(' + expression + u')';
}

}  // namespace

std::vector<CellFilter> cellFilters(const LogDocument& log, std::uint64_t index, int column) {
  std::vector<CellFilter> filters;
  if (index >= log.frames.count()) return filters;
  const Frame& frame = log.frames[index];
  const auto add = [&filters](const QString& what, const QString& expression) {
    filters.push_back({what, expression});
  };
  if (frame.isError()) {
    add(CellFilters::tr("Error frames"), QStringLiteral("err"));
  } else {
    const QString id = identifierText(frame);
    add(CellFilters::tr("ID %1").arg(id), QStringLiteral("id=") + id);
  }
  if (frame.isExtended() && !frame.isError()) {
    const J1939Id id = J1939Id::of(frame.identifier());
    const QString pgn = hexText(id.pgn, 4), source = hexText(id.source.value, 2);
    add(CellFilters::tr("PGN %1").arg(pgn), QStringLiteral("pgn=") + pgn);
    add(CellFilters::tr("Source %1").arg(source), QStringLiteral("sa=") + source);
    if (id.hasDestination() && id.destination != kGlobalAddress) {
      const QString to = hexText(id.destination.value, 2);
      add(CellFilters::tr("Destination %1").arg(to), QStringLiteral("da=") + to);
    }
  } else if (!frame.isError()) {
    const CobId cob = CobId::of(frame.identifier());
    const QString node = hexText(cob.node.value, 2);
    if (cob.hasNode()) add(CellFilters::tr("Node %1").arg(node), QStringLiteral("node=") + node);
  }
  const Classified what = classifyAt(log, index);
  if (what.message != MessageId::Count) {
    add(CellFilters::tr("Message: %1").arg(frameTitle(frame, {.message = what.message})),
        QStringLiteral("name=") + toQString(messageOf(what.message).key));
    if (what.malformed) add(CellFilters::tr("Malformed"), QStringLiteral("malformed"));
  } else if (what.family == Family::Ambiguous) {
    add(CellFilters::tr("Ambiguous"), QStringLiteral("ambiguous"));
  }
  const auto addValue = [&](const QString& value, const QString& expression) {
    add(CellFilters::tr("This value: %1").arg(value), expression);
  };
  switch (column) {
    case TraceModel::ChannelName: {
      const QString name = toQString(log.frames.channelName(frame.channel));
      addValue(name, QStringLiteral("ch=\"%1\"").arg(name));
      break;
    }
    case TraceModel::Direction: {
      const bool isSent = (frame.flags & Frame::kSent) != 0;
      addValue(directionText(frame), isSent ? QStringLiteral("dir=tx") : QStringLiteral("dir=rx"));
      break;
    }
    case TraceModel::Length:
      addValue(QString::number(frame.length), QStringLiteral("len=%1").arg(frame.length));
      break;
    case TraceModel::Data:
      if (frame.isRemote()) {
        addValue(CellFilters::tr("remote"), QStringLiteral("remote"));
      } else if (frame.length > 0) {
        addValue(bytesText(frame), QStringLiteral("data=\"%1\"").arg(bytesText(frame)));
      }
      break;
    default: break;
  }
  return filters;
}

QString narrowed(const QString& expression, const QString& by) {
  const QString before = expression.trimmed();
  if (before.isEmpty() || before == by) return by;
  return asPart(before) + QStringLiteral(" and ") + asPart(by);
}

QString reduced(const QString& expression, const QString& without) {
  const QString before = expression.trimmed();
  const bool isTest = without.count(u'=') == 1;
  const QString rest =
      isTest ? QString(without).replace(u'=', QLatin1String("!=")) : QStringLiteral("not ") + asPart(without);
  if (before.isEmpty() || before == rest) return rest;
  return asPart(before) + QStringLiteral(" and ") + rest;
}

}  // namespace deckpipe
