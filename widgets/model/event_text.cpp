// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/event_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>

#include "base/overload.h"
#include "model/field_text.h"
#include "protocol/address_book.h"
#include "protocol/name.h"
#include "text/device_text.h"
#include "text/plural.h"
#include "text/service_text.h"
#include "text/time_text.h"

namespace deckpipe {
namespace {

struct EventText {
  Q_DECLARE_TR_FUNCTIONS(EventText)
};

QString makerOf(std::int64_t name) {
  return makerText(Name{static_cast<std::uint64_t>(name)}.manufacturerCode());
}

QString addressOf(std::int64_t address) { return hexText(static_cast<std::uint8_t>(address)); }

QString rateOf(const Event& event) {
  const unsigned rate = event.bitRate / 1000;
  return event.isRateAssumed ? EventText::tr("%1 kbit/s (assumed)").arg(rate)
                             : EventText::tr("%1 kbit/s").arg(rate);
}

QString lengthOf(std::int64_t ns) { return briefAge(Duration(ns)); }

AxisText axisOf(const Event& event) {
  return axisText(event.pin.isNull() ? std::nullopt : std::optional(event.pin.deviceType()), event.axis);
}

// "Rotation, right"
QString sideOf(const Event& event) {
  const AxisText axis = axisOf(event);
  return EventText::tr("%1, %2", "an axis and its side")
      .arg(axis.name, (event.isPlus ? axis.plus : axis.minus).toLower());
}

QString degreesOf(std::int64_t tenths) {
  return EventText::tr("%1°").arg(QLocale().toString(static_cast<double>(tenths) / 10, 'f', 1));
}

QString sharedText(const Event& event) {
  const QString text =
      EventText::tr("Two devices at one address: both send from %1").arg(hexText(event.address.value));
  return event.other.isNull() ? text : EventText::tr("%1; the other is %2").arg(text, pinText(event.other));
}

// `since`: Event::since in words.
QString whatHappened(const Event& event, const QString& since) {
  switch (event.kind) {
    case EventKind::Appeared:
      return event.address == kNullAddress
                 ? EventText::tr("Appeared")
                 : EventText::tr("Appeared at address %1").arg(hexText(event.address.value));
    case EventKind::Silent:
      return EventText::tr("Silent since %1: its periodic messages are missing").arg(since);
    case EventKind::Back: return EventText::tr("Heard again after %1").arg(lengthOf(event.now));
    case EventKind::NotBack:
      return EventText::tr("Not heard since the link came back at %1; it was there before").arg(since);
    case EventKind::Restarted: return EventText::tr("Restarted");
    case EventKind::NotOperational: return EventText::tr("Not operational (NMT)");
    case EventKind::Operational: return EventText::tr("Operational (NMT)");
    case EventKind::MovedAddress:
      return EventText::tr("Moved from address %1 to %2").arg(addressOf(event.was), addressOf(event.now));
    case EventKind::AddressLost:
      return event.now == 0 ? EventText::tr("Lost address %1").arg(hexText(event.address.value))
                            : EventText::tr("Lost address %1 to another NAME: %2")
                                  .arg(hexText(event.address.value), makerOf(event.now));
    case EventKind::CannotClaim:
      return event.address == kNullAddress
                 ? EventText::tr("Cannot claim any address: %1").arg(makerOf(event.was))
                 : EventText::tr("Cannot claim any address; it had %1").arg(hexText(event.address.value));
    case EventKind::Malformed: return EventText::tr("A periodic message comes in a wrong length only");
    case EventKind::MalformedOver:
      return EventText::tr("Its periodic messages have their right lengths again");
    case EventKind::TwoAtOneAddress: return sharedText(event);
    case EventKind::TwoAtOneAddressOver:
      return EventText::tr("One device sends from address %1 again").arg(hexText(event.address.value));
    case EventKind::Fault: return EventText::tr("Fault: %1").arg(faultName(static_cast<unsigned>(event.now)));
    case EventKind::FaultCleared:
      return EventText::tr("Fault cleared: %1").arg(faultName(static_cast<unsigned>(event.was)));
    case EventKind::DeviceFaulted: return EventText::tr("Says that it is faulted");
    case EventKind::DeviceFaultedOver: return EventText::tr("Says that it is faulted no more");
    case EventKind::OperationalError:
      return event.now == 0 ? EventText::tr("Operational error")
                            : EventText::tr("Operational error: %1")
                                  .arg(pcodeErrorText(static_cast<unsigned>(event.now)));
    case EventKind::OperationalErrorOver: return EventText::tr("Operational error over");
    case EventKind::ErrorCode:
      return event.was == 0
                 ? EventText::tr("Answered: %1").arg(pcodeErrorText(static_cast<unsigned>(event.now)))
                 : EventText::tr("Answered: %1; before it was %2")
                       .arg(pcodeErrorText(static_cast<unsigned>(event.now)))
                       .arg(event.was);
    case EventKind::ErrorCodeCleared: return EventText::tr("Error %1 cleared").arg(event.was);
    case EventKind::SensorError: return EventText::tr("Sensor error: %1").arg(axisOf(event).name);
    case EventKind::SensorErrorOver: return EventText::tr("Sensor error over: %1").arg(axisOf(event).name);
    case EventKind::Disabled: return EventText::tr("Disabled: it cannot move");
    case EventKind::Enabled: return EventText::tr("Enabled");
    case EventKind::PermissiveLost: return EventText::tr("Permissive lost");
    case EventKind::PermissiveBack: return EventText::tr("Permissive back");
    case EventKind::RemoteMode: return EventText::tr("Remote mode");
    case EventKind::RemoteModeOver: return EventText::tr("Remote mode over");
    case EventKind::Stowed: return EventText::tr("Stowed");
    case EventKind::NotStowed: return EventText::tr("No longer stowed");
    case EventKind::StopReached: return EventText::tr("Stop reached: %1").arg(sideOf(event));
    case EventKind::StopLeft: return EventText::tr("Stop left: %1").arg(sideOf(event));
    case EventKind::StopError: return EventText::tr("Stop reports an error: %1").arg(sideOf(event));
    case EventKind::SoftLimitChanged:
      return EventText::tr("Soft limit changed: %1, %2 → %3")
          .arg(sideOf(event), degreesOf(event.was), degreesOf(event.now));
    case EventKind::JoystickBegan: return EventText::tr("Began to send");
    case EventKind::JoystickEnded: return EventText::tr("Ended: nothing since %1").arg(since);
    case EventKind::JoystickGap:
      return EventText::tr("Gap of %1 between two messages").arg(lengthOf(event.now));
    case EventKind::JoystickTimedOut: return EventText::tr("Timed out: nothing for 200 ms");
    case EventKind::JoystickBack: return EventText::tr("Sends again after %1").arg(lengthOf(event.now));
    case EventKind::JoystickOutranked:
      return EventText::tr("Outranked by %1: %2")
          .arg(joystickName({static_cast<std::uint8_t>(event.now)}), axisOf(event).name);
    case EventKind::JoystickOutrankedOver:
      return EventText::tr("No longer outranked: %1").arg(axisOf(event).name);
    case EventKind::LoadHigh:
      return EventText::tr("Bus load high: %1 % of %2").arg(event.now).arg(rateOf(event));
    case EventKind::LoadNormal:
      return EventText::tr("Bus load normal again: %1 % of %2").arg(event.now).arg(rateOf(event));
    case EventKind::ErrorFrames: return EventText::tr("Error frames on the bus");
    case EventKind::ErrorFramesOver:
      return EventText::tr("No more error frames; there were %Ln", nullptr,
                           forPlural(static_cast<std::uint64_t>(event.now)));
    case EventKind::BusOff: return EventText::tr("The adapter is bus-off");
    case EventKind::ErrorPassive: return EventText::tr("The adapter is error-passive");
    case EventKind::ErrorActive: return EventText::tr("The adapter is error-active again");
    case EventKind::ClockJump: return EventText::tr("The clock jumps here");
    case EventKind::Count: break;
  }
  return {};
}

}  // namespace

QString eventText(const Event& event, Instant begin) {
  const QString since = event.since == kNotYet ? QString() : elapsedText(event.since - begin);
  QString text = whatHappened(event, since);
  const bool isSaid = event.kind == EventKind::Silent || event.kind == EventKind::NotBack ||
                      event.kind == EventKind::JoystickEnded;
  if (!since.isEmpty() && !isSaid) text = EventText::tr("%1, since %2").arg(text, since);
  return event.folded == 0 ? text
                           : EventText::tr("%1 (%Ln changes right before it are not listed)", nullptr,
                                           forPlural(event.folded))
                                 .arg(text);
}

DeviceKey keyOf(const Event& event) {
  if (!event.pin.isNull()) return DeviceKey::of(event.pin, event.channel);
  if (event.node.value != 0) return DeviceKey::at(event.channel, event.node);
  return event.address == kNullAddress ? DeviceKey{} : DeviceKey::at(event.channel, event.address);
}

QString deviceNameText(const DeviceKey& key, const DeviceLabels& labels) {
  switch (key.kind) {
    case DeviceKey::Kind::None: return {};
    case DeviceKey::Kind::Pin: {
      const QString label = labels.of(key);
      return label.isEmpty() ? pinText(key.pin) : label;
    }
    case DeviceKey::Kind::Address:
      return isJoystickAddress(key.address) ? joystickName(key.address)
                                            : EventText::tr("Address %1").arg(hexText(key.address.value));
    case DeviceKey::Kind::Node: return EventText::tr("Node %1").arg(hexText(key.node.value));
  }
  return {};
}

DeviceKey keyOf(const Note& note) {
  return std::visit(
      [](const auto& n) {
        if constexpr (std::is_same_v<decltype(n), const note::Label&>) {
          return DeviceKey::of(n.pin, {});
        } else if constexpr (requires { n.pin; }) {
          return n.pin.isNull() ? DeviceKey::at(n.channel, n.address) : DeviceKey::of(n.pin, n.channel);
        } else {
          return DeviceKey{};
        }
      },
      note.value);
}

QString eventGroupText(EventGroup group) {
  switch (group) {
    case EventGroup::Presence: return EventText::tr("Presence");
    case EventGroup::Address: return EventText::tr("Addresses");
    case EventGroup::Fault: return EventText::tr("Faults");
    case EventGroup::Mode: return EventText::tr("Modes");
    case EventGroup::Stop: return EventText::tr("Stops");
    case EventGroup::Joystick: return EventText::tr("Joysticks");
    case EventGroup::Bus: return EventText::tr("Bus");
    case EventGroup::Note: return EventText::tr("Notes");
    case EventGroup::Count: break;
  }
  return {};
}

QString eventWeightText(Severity weight) {
  if (weight == Severity::Fault) return EventText::tr("Fault");
  return weight == Severity::Warning ? EventText::tr("Warning") : EventText::tr("Information");
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

QString pipeText(const note::Pipe& n) {
  return n.file.isEmpty()
             ? EventText::tr("Data pipe: %1").arg(pipeEventText(n.event))
             : EventText::tr("Data pipe, %1: %2").arg(toQString(n.file.str()), pipeEventText(n.event));
}

// With the bus's name to be put in.
QString leftOutText(const note::LeftOut& n) {
  using Why = note::LeftOut::Why;
  switch (n.why) {
    case Why::CanFd:
      return EventText::tr("%1: %Ln CAN FD frames came and are not held", nullptr, forPlural(n.count));
    case Why::CanXl:
      return EventText::tr("%1: %Ln CAN XL frames came and are not held", nullptr, forPlural(n.count));
    case Why::NotClassic:
      return EventText::tr("%1: %Ln frames came that are not classic CAN and are not held", nullptr,
                           forPlural(n.count));
    case Why::Unreadable:
      return EventText::tr("%1: %Ln lines of the file that this log was saved from could not be read",
                           nullptr, forPlural(n.count));
    case Why::RecorderLost:
      return EventText::tr("%1: the recorder lost frames at %Ln places, as it says", nullptr,
                           forPlural(n.count));
    case Why::NotWhole:
      return EventText::tr("%1: the file that this log was saved from was not whole at %Ln places", nullptr,
                           forPlural(n.count));
    case Why::Damaged:
      return EventText::tr("%Ln frames are missing here: the recording is damaged", nullptr,
                           forPlural(n.count));
  }
  return {};
}

QString anglesText(const note::AnglesBefore& n) {
  QStringList angles;
  if (n.rotation.tenths) angles << EventText::tr("rotation %1").arg(degreesOf(*n.rotation.tenths));
  if (n.elevation.tenths) angles << EventText::tr("elevation %1").arg(degreesOf(*n.elevation.tenths));
  return EventText::tr("%1: before it the device stood at %2", "command, angles")
      .arg(requestText(n.request), angles.join(EventText::tr(", ", "between angles")));
}

QString motionEndText(const note::MotionEnded& n) {
  return (n.isDisarmed ? EventText::tr("The console's joystick was disarmed: %1")
                       : EventText::tr("The console's joystick went to neutral: %1"))
      .arg(motionCauseText(n.cause));
}

}  // namespace

QString noteText(const LogDocument& log, const Note& note) {
  const auto busOf = [&log](const auto& n) { return toQString(log.frames.channelName(n.channel.value)); };
  return std::visit(
      Overload{
          [](const note::Mark& n) {
            return n.text.isEmpty() ? EventText::tr("Mark") : toQString(n.text.str());
          },
          [&](const note::LinkUp& n) {
            const QString text = EventText::tr("%1 up").arg(busOf(n));
            return n.adapter.isEmpty() ? text
                                       : QStringLiteral("%1: %2").arg(text, toQString(n.adapter.str()));
          },
          [&](const note::LinkDown& n) {
            const QString text = EventText::tr("%1 down").arg(busOf(n));
            const QString why = linkFaultText(n.fault, toQString(n.words.str()));
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
          [](const note::Asked& n) { return EventText::tr("%1: asked").arg(requestText(n.request)); },
          [](const note::AnglesBefore& n) { return anglesText(n); },
          [](const note::RequestEnded& n) {
            return EventText::tr("%1: %2").arg(requestText(n.request), requestEndText(n.request, n.end));
          },
          [](const note::RequestWaits& n) {
            return EventText::tr("%1: not on the bus yet; it may still go out").arg(requestText(n.request));
          },
          [&](const note::StillWaits& n) {
            return EventText::tr("%1: %Ln frames are not on the bus yet and may still go out", nullptr,
                                 forPlural(n.count))
                .arg(busOf(n));
          },
          [](const note::Pipe& n) { return pipeText(n); },
          [&](const note::LeftOut& n) {
            const QString text = leftOutText(n);
            return n.why == note::LeftOut::Why::Damaged ? text : text.arg(busOf(n));
          },
          [](const note::Label& n) {
            return (n.text.isEmpty() ? EventText::tr("%1 has no label any more", "PIN")
                                     : EventText::tr("%1 is called “%2”", "PIN, label"))
                .arg(toQString(n.pin.text()), toQString(n.text.str()));
          },
          [](const note::Added&) { return QString(); },  // it is no event
          [](const note::RanUntil&) { return QString(); },
          [](const note::Filtered& n) {
            return EventText::tr("Saved through the filter “%1”: what did not pass it is missing")
                .arg(toQString(n.text.str()));
          },
          [](const note::MotionArmed& n) {
            return EventText::tr("The console's joystick at address %1 was armed and moves this monitor")
                .arg(hexText(n.address.value));
          },
          [](const note::MotionEnded& n) { return motionEndText(n); },
          [](const note::MotionLate&) {
            return EventText::tr("An old motion frame of the console has just gone out");
          }},
      note.value);
}

}  // namespace deckpipe
