// SPDX-License-Identifier: GPL-3.0-or-later
// deckpipectl recordings: what the console recorded on this machine.
#include "session/recordings.h"

#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <cstdio>

#include "arguments.h"
#include "command.h"
#include "counts.h"
#include "output.h"

namespace deckpipe::ctl {
namespace {

QString stateOf(const Recording& recording) {
  if (!recording.isReadable) return QStringLiteral("unreadable");
  if (recording.isGrowing) return QStringLiteral("growing");
  if (recording.isSaved) return QStringLiteral("saved");
  return recording.isSimulated ? QStringLiteral("simulated") : QStringLiteral("unsaved");
}

double secondsOf(Duration length) { return static_cast<double>(length.count()) / 1e9; }

QString lengthOf(const Recording& recording) {
  if (!recording.length) return QStringLiteral("length not known");
  return QStringLiteral("%1%2 s")
      .arg(recording.isGlanced ? QStringLiteral("about ") : QString())
      .arg(secondsOf(*recording.length), 0, 'f', 1);
}

QByteArray lineOf(const Recording& recording) {
  QString line =
      QStringLiteral("%1  %2  %3  %4  %5")
          .arg(recording.begin.toString(QStringLiteral("yyyy-MM-dd HH:mm:ss")), stateOf(recording))
          .arg(lengthOf(recording))
          .arg(QString::fromStdString(framesText(recording.frames)))
          .arg(recording.pins.isEmpty() ? QStringLiteral("-") : recording.pins.join(QLatin1Char(' ')));
  if (recording.isGlanced) line += QStringLiteral(" and perhaps more, as only its ends were read");
  if (!recording.isWhole && !recording.isGrowing) line += QStringLiteral("  not whole");
  if (!recording.adapters.isEmpty())
    line += QStringLiteral("\n  ") + recording.adapters.join(QStringLiteral("; "));
  return (line + QStringLiteral("\n  ") + recording.path).toUtf8() + '\n';
}

QByteArray jsonOf(const Recording& recording) {
  return QJsonDocument(QJsonObject{
                           {QStringLiteral("path"), recording.path},
                           {QStringLiteral("begin"), recording.begin.toUTC().toString(Qt::ISODateWithMs)},
                           {QStringLiteral("state"), stateOf(recording)},
                           {QStringLiteral("whole"), recording.isWhole},
                           {QStringLiteral("simulated"), recording.isSimulated},
                           {QStringLiteral("length_s"),
                            recording.length ? QJsonValue(secondsOf(*recording.length)) : QJsonValue()},
                           {QStringLiteral("frames"), static_cast<qint64>(recording.frames)},
                           {QStringLiteral("bytes"), static_cast<qint64>(recording.bytes)},
                           {QStringLiteral("only_ends_read"), recording.isGlanced},
                           {QStringLiteral("adapters"), QJsonArray::fromStringList(recording.adapters)},
                           {QStringLiteral("pins"), QJsonArray::fromStringList(recording.pins)},
                       })
             .toJson(QJsonDocument::Compact) +
         '\n';
}

}  // namespace

ExitStatus recordingsCommand(const QStringList& given) {
  Arguments arguments(
      given,
      "Lists what the console recorded on this machine, the newest first.\n"
      "Each is growing, unsaved, saved, simulated or unreadable; info and decode read them all.");
  arguments.add({{"json", "One JSON object a line."},
                 {"folder", "Look there, not in " + recordingsFolder().toStdString() + '.', "FOLDER"}});
  if (const auto status = arguments.parse()) return *status;

  Output output;
  const QString where = arguments.has("folder") ? arguments.text("folder") : recordingsFolder();
  const QFileInfo facts(where);
  // Nothing was recorded yet where the console keeps its recordings.
  const bool mayBeAbsent = !arguments.has("folder") && !facts.exists();
  if (!mayBeAbsent && !(facts.isDir() && facts.isReadable())) {
    std::fprintf(stderr, "deckpipectl: %s: %s\n", qPrintable(where),
                 !facts.exists() ? "no such folder"
                 : facts.isDir() ? "the folder cannot be read"
                                 : "it is no folder");
    return kCannotRead;
  }
  if (mayBeAbsent) std::fprintf(stderr, "deckpipectl: %s: nothing was recorded yet\n", qPrintable(where));
  for (const Recording& recording : recordingsIn(where)) {
    const QByteArray line = arguments.has("json") ? jsonOf(recording) : lineOf(recording);
    output.text().append(line.constData(), static_cast<std::size_t>(line.size()));
  }
  return output.flush() ? kDone : kNotWhole;
}

}  // namespace deckpipe::ctl
