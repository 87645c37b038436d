// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/event_text.h"

#include <QCoreApplication>
#include <algorithm>
#include <climits>

#include "base/overload.h"
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

using How = note::OwnAddress::How;

QString ownAddressText(const note::OwnAddress& n) {
  switch (n.how) {
    case How::Claimed: return EventText::tr("The console holds address %1").arg(hexText(n.address.value));
    case How::Lost: return EventText::tr("The console lost its address to a lower NAME");
    case How::CannotClaim: return EventText::tr("The console cannot claim any address");
    case How::SameName: return EventText::tr("Another node has the console's NAME");
    case How::InUse: return EventText::tr("The console left its address: another node sends from it");
    case How::Disputed:
      return EventText::tr("Another node sends from address %1, which the console holds and claims again")
          .arg(hexText(n.address.value));
    case How::Locked:
    case How::LinkLost: return EventText::tr("The console gave up its address");
  }
  return {};
}

EventWeight weightOf(How how) {
  switch (how) {
    case How::Claimed:
    case How::Locked: return EventWeight::Plain;
    case How::Lost:
    case How::CannotClaim:
    case How::SameName:
    case How::InUse:
    case How::Disputed:
    case How::LinkLost: return EventWeight::Attend;
  }
  return EventWeight::Attend;
}

int forPlural(std::uint64_t count) { return static_cast<int>(std::min<std::uint64_t>(count, INT_MAX)); }

// Of whom: the PIN, or where it has none the address.
QString deviceText(const Pin& pin, Address address) {
  return pin.isNull() ? EventText::tr("address %1").arg(hexText(address.value)) : toQString(pin.text());
}

QString pipeText(const note::Pipe& n) {
  QString which = deviceText(n.pin, n.address);
  if (!n.file.isEmpty()) which += QLatin1Char(' ') + toQString(n.file.str());
  return EventText::tr("Data pipe %1: %2").arg(which, pipeEventText(n.event));
}

}  // namespace

QString noteText(const LogDocument& log, const Note& note) {
  const auto busOf = [&log](const auto& n) { return toQString(log.frames.channelName(n.channel.value)); };
  return std::visit(
      Overload{[](const note::Mark& n) {
                 return n.text.isEmpty() ? EventText::tr("Mark") : toQString(n.text.str());
               },
               [&](const note::LinkUp& n) {
                 const QString text = EventText::tr("%1 up").arg(busOf(n));
                 return n.adapter.isEmpty() ? text
                                            : QStringLiteral("%1: %2").arg(text, toQString(n.adapter.str()));
               },
               [&](const note::LinkDown& n) {
                 const QString text = EventText::tr("%1 down").arg(busOf(n));
                 const QString why = n.words.isEmpty() ? linkFaultText(n.fault) : toQString(n.words.str());
                 return why.isEmpty() ? text : QStringLiteral("%1: %2").arg(text, why);
               },
               [&](const note::Dropped& n) {
                 return EventText::tr("%1: %Ln frames lost", nullptr, forPlural(n.count)).arg(busOf(n));
               },
               [](const note::Locked&) { return EventText::tr("Transmit locked"); },
               [](const note::Unlocked&) { return EventText::tr("Transmit unlocked"); },
               [&](const note::DriveSaid& n) {
                 return (n.isDrive ? EventText::tr("%1: address %2 is a drive")
                                   : EventText::tr("%1: address %2 is no drive"))
                     .arg(busOf(n), hexText(n.address.value));
               },
               [](const note::OwnAddress& n) { return ownAddressText(n); },
               [](const note::Asked& n) {
                 return EventText::tr("%1 asked of %2").arg(askText(n.ask), deviceText(n.pin, n.address));
               },
               [](const note::AskEnded& n) {
                 return EventText::tr("%1 of %2: %3")
                     .arg(askText(n.ask), deviceText(n.pin, n.address), requestEndText(n.ask, n.end));
               },
               [](const note::AskWaits& n) {
                 return EventText::tr("%1 of %2: not on the bus yet; it may still go out")
                     .arg(askText(n.ask), deviceText(n.pin, n.address));
               },
               [&](const note::StillWaits& n) {
                 return EventText::tr("%1: %Ln frames are not on the bus yet and may still go out", nullptr,
                                      forPlural(n.count))
                     .arg(busOf(n));
               },
               [](const note::Pipe& n) { return pipeText(n); },
               [&](const note::LeftOut& n) {
                 return (n.why == note::LeftOut::Why::CanFd
                             ? EventText::tr("%1: %Ln CAN FD frames came and are not held", nullptr,
                                             forPlural(n.count))
                             : EventText::tr("%1: %Ln frames came that are not classic CAN and are not held",
                                             nullptr, forPlural(n.count)))
                     .arg(busOf(n));
               },
               [](const note::Label& n) {
                 return EventText::tr("%1 is called “%2”", "PIN, label")
                     .arg(toQString(n.pin.text()), toQString(n.text.str()));
               },
               [](const note::Added& n) {
                 return EventText::tr(
                     "%Ln frames were added here when this part was saved: who held which "
                     "address",
                     nullptr, forPlural(n.count));
               }},
      note.value);
}

EventWeight weightOf(const Note& note) {
  using Weight = EventWeight;
  return std::visit(Overload{[](const note::Mark&) { return Weight::Mark; },
                             [](const note::LinkUp&) { return Weight::Plain; },
                             [](const note::LinkDown&) { return Weight::Fault; },
                             [](const note::Dropped&) { return Weight::Attend; },
                             [](const note::Locked&) { return Weight::Plain; },
                             [](const note::Unlocked&) { return Weight::Plain; },
                             [](const note::DriveSaid&) { return Weight::Plain; },
                             [](const note::OwnAddress& n) { return weightOf(n.how); },
                             [](const note::Asked&) { return Weight::Plain; },
                             [](const note::AskEnded& n) {
                               return n.end == RequestEnd::Answered ? Weight::Plain : Weight::Attend;
                             },
                             [](const note::AskWaits&) { return Weight::Fault; },
                             [](const note::StillWaits&) { return Weight::Fault; },
                             [](const note::Pipe&) { return Weight::Plain; },
                             [](const note::LeftOut&) { return Weight::Attend; },
                             [](const note::Label&) { return Weight::Plain; },
                             [](const note::Added&) { return Weight::Plain; }},
                    note.value);
}

}  // namespace deckpipe
