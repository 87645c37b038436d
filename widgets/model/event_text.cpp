// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/event_text.h"

#include <QCoreApplication>
#include <algorithm>
#include <climits>

#include "model/field_text.h"
#include "text/age_text.h"
#include "text/device_text.h"
#include "text/service_text.h"

namespace deckpipe {
namespace {

struct EventText {
  Q_DECLARE_TR_FUNCTIONS(EventText)
};

QString makerOf(Name name) { return makerText(name.manufacturerCode()); }

// Who says so: "Address 80", "Node 24".
QString senderText(const Event& event) {
  return event.node.value != 0 ? EventText::tr("Node %1").arg(hexText(event.node.value))
                               : EventText::tr("Address %1").arg(hexText(event.address.value));
}

}  // namespace

QString eventText(const Event& event) {
  const QString address = hexText(event.address.value);
  switch (event.kind) {
    case EventKind::Announced:
      return EventText::tr("%1 appeared at address %2").arg(pinText(event.pin), address);
    case EventKind::AddressChanged:
      return EventText::tr("%1 moved from address %2 to %3")
          .arg(pinText(event.pin), hexText(event.previous.value), address);
    case EventKind::Claimed: return EventText::tr("Address %1 claimed: %2").arg(address, makerOf(event.name));
    case EventKind::CannotClaim:
      return event.address == kNullAddress
                 ? EventText::tr("A device cannot claim any address: %1").arg(makerOf(event.name))
                 : EventText::tr("The device at address %1 cannot claim any address").arg(address);
    case EventKind::NodeStarted: return EventText::tr("%1 started").arg(senderText(event));
    case EventKind::ErrorBegan:
      return EventText::tr("%1 reports an operational error").arg(senderText(event));
    case EventKind::ErrorEnded: return EventText::tr("%1: operational error over").arg(senderText(event));
    case EventKind::SilenceEnded:
      return EventText::tr("%1 is heard again after %2").arg(senderText(event), briefAge(event.lasted));
    case EventKind::ErrorFrames: return EventText::tr("Error frames on the bus");
    case EventKind::ClockJump: return EventText::tr("The clock jumps here");
  }
  return {};
}

EventWeight weightOf(const Event& event) {
  switch (event.kind) {
    case EventKind::CannotClaim:
    case EventKind::ErrorBegan: return EventWeight::Fault;
    case EventKind::AddressChanged:
    case EventKind::SilenceEnded:
    case EventKind::ErrorFrames:
    case EventKind::ClockJump: return EventWeight::Attend;
    case EventKind::Announced:
    case EventKind::Claimed:
    case EventKind::NodeStarted:
    case EventKind::ErrorEnded: break;
  }
  return EventWeight::Plain;
}

namespace {

QString ownAddressText(const Note& note, const QString& address) {
  if (note.address != kNullAddress) return EventText::tr("The console holds address %1").arg(address);
  if (note.text == "lost") return EventText::tr("The console lost its address to a lower NAME");
  if (note.text == "cannot claim") return EventText::tr("The console cannot claim any address");
  if (note.text == "in use") return EventText::tr("The console left its address: another node sends from it");
  if (note.text == "same name") return EventText::tr("Another node has the console's NAME");
  return EventText::tr("The console gave up its address");
}

// Of whom: the PIN, or where it has none the address.
QString askedOf(const Note& note, const QString& address) {
  return note.text.empty() ? EventText::tr("address %1").arg(address) : toQString(note.text);
}

}  // namespace

QString noteText(const LogDocument& log, const Note& note) {
  const QString channel = toQString(log.frames.channelName(note.channel.value));
  const QString said = toQString(note.text);
  const auto withReason = [&said](const QString& text) {
    return said.isEmpty() ? text : QStringLiteral("%1: %2").arg(text, said);
  };
  const QString address = hexText(note.address.value);
  switch (note.kind) {
    case NoteKind::LinkUp: return EventText::tr("%1 up").arg(channel);
    case NoteKind::LinkDown: return withReason(EventText::tr("%1 down").arg(channel));
    case NoteKind::Dropped:
      return EventText::tr("%1: %Ln frames lost", nullptr,
                           static_cast<int>(std::min<std::uint64_t>(note.number, INT_MAX)))
          .arg(channel);
    case NoteKind::Locked: return EventText::tr("Transmit locked");
    case NoteKind::Unlocked: return EventText::tr("Transmit unlocked");
    case NoteKind::Mark: return said.isEmpty() ? EventText::tr("Mark") : said;
    case NoteKind::DriveSaid: return EventText::tr("%1: address %2 is a drive").arg(channel, address);
    case NoteKind::DriveUnsaid: return EventText::tr("%1: address %2 is no drive").arg(channel, address);
    case NoteKind::OwnAddress: return ownAddressText(note, address);
    case NoteKind::Asked:
      return EventText::tr("%1 asked of %2")
          .arg(askText(static_cast<Ask>(note.number)), askedOf(note, address));
    case NoteKind::AskEnded:
      return EventText::tr("%1 of %2: %3")
          .arg(askText(static_cast<Ask>(note.number & 0xFF)), askedOf(note, address),
               requestEndText(static_cast<RequestEnd>(note.number >> 8)));
    case NoteKind::AskWaits:
      return EventText::tr("%1 of %2: not on the bus yet; it may still go out")
          .arg(askText(static_cast<Ask>(note.number)), askedOf(note, address));
    case NoteKind::StillWaits:
      return EventText::tr("%1: %Ln frames are not on the bus yet and may still go out", nullptr,
                           static_cast<int>(std::min<std::uint64_t>(note.number, INT_MAX)))
          .arg(channel);
    case NoteKind::Pipe:
      return EventText::tr("Data pipe %1: %2")
          .arg(askedOf(note, address), pipeEventText(static_cast<PipeEvent>(note.number)));
  }
  return said;
}

EventWeight weightOf(const Note& note) {
  switch (note.kind) {
    case NoteKind::LinkDown:
    case NoteKind::AskWaits:
    case NoteKind::StillWaits: return EventWeight::Fault;
    case NoteKind::Dropped: return EventWeight::Attend;
    case NoteKind::Mark: return EventWeight::Mark;
    case NoteKind::AskEnded:
      return static_cast<RequestEnd>(note.number >> 8) == RequestEnd::Answered ? EventWeight::Plain
                                                                               : EventWeight::Attend;
    case NoteKind::OwnAddress:
      return note.text == "claimed" || note.text == "locked" ? EventWeight::Plain : EventWeight::Attend;
    default: return EventWeight::Plain;
  }
}

}  // namespace deckpipe
