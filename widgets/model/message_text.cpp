// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/message_text.h"

#include <QCoreApplication>
#include <QStringList>

#include "bus/canopen.h"
#include "bus/j1939.h"
#include "model/field_text.h"
#include "protocol/lists.h"
#include "text/catalogue_text.h"
#include "text/j1939_text.h"

namespace deckpipe {
namespace {

struct MessageText {
  Q_DECLARE_TR_FUNCTIONS(MessageText)
};

// linux/can/error.h: the identifier of an error frame is a set of these.
struct ErrorClass {
  std::uint32_t bit;
  const char* text;
};
constexpr ErrorClass kErrorClasses[] = {
    {0x001, QT_TRANSLATE_NOOP("ErrorFrames", "transmit timed out")},
    {0x002, QT_TRANSLATE_NOOP("ErrorFrames", "arbitration lost")},
    {0x004, QT_TRANSLATE_NOOP("ErrorFrames", "controller problem")},
    {0x008, QT_TRANSLATE_NOOP("ErrorFrames", "protocol violation")},
    {0x010, QT_TRANSLATE_NOOP("ErrorFrames", "transceiver")},
    {0x020, QT_TRANSLATE_NOOP("ErrorFrames", "no acknowledgement")},
    {0x040, QT_TRANSLATE_NOOP("ErrorFrames", "bus off")},
    {0x080, QT_TRANSLATE_NOOP("ErrorFrames", "bus error")},
    {0x100, QT_TRANSLATE_NOOP("ErrorFrames", "controller restarted")},
};

QString undecodedText(const Frame& frame, const Classified& what) {
  switch (what.family) {
    case Family::Ambiguous:
      return hasTypeOf(frame, MessageId::PipeData)
                 ? MessageText::tr(
                       "Ambiguous: a data pipe packet of an Akron device or another maker's "
                       "message. Nothing heard so far decides.")
                 : MessageText::tr(
                       "Ambiguous: one end is said to be a Copley drive, the other is an Akron "
                       "device, and both use this PGN.");
    case Family::Other: return MessageText::tr("Another maker's message on the same PGN; not decoded.");
    case Family::Akron:
      return MessageText::tr("From or to an Akron device, of a type that its manuals do not describe.");
    case Family::Copley:
      return MessageText::tr("From or to a Copley drive, with a command that its note does not describe.");
    case Family::Canopen:
      return MessageText::tr("From an Akron node, but not one of the messages that it maps here.");
    default: break;
  }
  if (standardGroup(frame, what) != nullptr)
    return MessageText::tr("Not decoded here. The name is the one that SAE J1939 gives to this PGN.");
  return MessageText::tr("Not a message that this console knows.");
}

}  // namespace

const j1939::StandardGroup* standardGroup(const Frame& frame, const Classified& what) {
  const bool isUnknown = what.message == MessageId::Count && what.family == Family::None;
  if (!isUnknown || frame.isError() || frame.isRemote() || !frame.isExtended()) return nullptr;
  return j1939::standardGroupOf(J1939Id::of(frame.identifier()).pgn);
}

QString frameTitle(const Frame& frame, const Classified& what) {
  if (frame.isError()) return MessageText::tr("Error frame");
  if (frame.isRemote()) return MessageText::tr("Remote request");
  if (what.message != MessageId::Count) {
    const QString title = messageName(what.message);
    if (what.malformed) return MessageText::tr("Malformed: %1").arg(title);
    return title;
  }
  switch (what.family) {
    case Family::Ambiguous: return MessageText::tr("Ambiguous");
    case Family::Other: return MessageText::tr("Another maker's");
    case Family::Akron: return MessageText::tr("Unknown Akron message");
    case Family::Copley: return MessageText::tr("Unknown drive command");
    case Family::Canopen: return MessageText::tr("Unknown PDO");
    default: break;
  }
  const j1939::StandardGroup* group = standardGroup(frame, what);
  return group != nullptr ? groupText(*group) : QString();
}

QString certaintyText(const Frame& frame, const Classified& what) {
  if (frame.isError()) return MessageText::tr("The adapter reported an error on the bus; it is no message.");
  if (frame.isRemote()) return MessageText::tr("Asks for the frame of this identifier; it carries no data.");
  if (what.malformed) return MessageText::tr("Malformed: %1.").arg(malformedText(what, frame.length));
  if (!what.isDecoded()) return undecodedText(frame, what);
  if (what.family != Family::Presumed) return {};
  if (frame.isExtended())
    return MessageText::tr(
        "Presumed: neither end has been heard to be an Akron device since the link came up, but type, length "
        "and direction fit.");
  return MessageText::
      tr("Presumed: node %1 has not been heard to be an Akron device since the link came up, but the message "
         "fits.")
          .arg(hexText(CobId::of(frame.identifier()).node.value, 2));
}

QString malformedText(const Classified& what, unsigned length) {
  QStringList wanted;
  for (unsigned n = 0; n <= 8; ++n) {
    if (allows(what.wanted, n)) wanted += QString::number(n);
  }
  const QString lengths = wanted.join(MessageText::tr(" or ", "between lengths"));
  const QString text = wanted == QStringList{QStringLiteral("1")}
                           ? MessageText::tr("%1 byte wanted, %2 came")
                           : MessageText::tr("%1 bytes wanted, %2 came");
  return text.arg(lengths).arg(length);
}

QString errorText(const Frame& frame) {
  QStringList classes;
  for (const ErrorClass& c : kErrorClasses) {
    if ((frame.identifier() & c.bit) != 0) classes += QCoreApplication::translate("ErrorFrames", c.text);
  }
  return classes.join(QStringLiteral(", "));
}

}  // namespace deckpipe
