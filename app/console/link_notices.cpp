// SPDX-License-Identifier: GPL-3.0-or-later
// What is to be said of a link: why it does not come up, why nothing is heard on it, that it went away.
#include <algorithm>

#include "model/device_rows.h"
#include "notice_of.h"
#include "status_text.h"
#include "words.h"

namespace deckpipe {
namespace {

// Shorter silences are no riddle: devices start, people plug in.
constexpr Duration kSilence = 3s;

// When the link of a live log came up last.
Instant upSince(const LogDocument& log) {
  Instant since = kNotYet;
  for (const Note& note : log.notes.of<note::LinkUp>()) since = note.time;
  return since;
}

Instant lastFrame(const State& state) {
  Instant last = kNotYet;
  for (std::uint8_t i = 0; i < kMaxChannels; ++i) last = std::max(last, state.channel({i}).lastFrame);
  return last;
}

Notice failedLink(const SourceStatus& source) {
  Notice notice{Severity::Fault};
  const QString name = source.interfaceName;
  const QString reason = sourceErrorText(source.error);
  if (std::holds_alternative<StoreFull>(source.error)) {
    notice.text = NoticeText::tr(
                      "Nothing more of %1 is recorded: there is no room for more frames, neither in "
                      "memory nor on disk.")
                      .arg(name);
    notice.action = Notice::Action::Reconnect;
    return notice;
  }
  const auto* error = std::get_if<LinkError>(&source.error);
  const QString detail = error != nullptr ? QString::fromStdString(error->detail) : QString();
  switch (error != nullptr ? error->fault : LinkFault::None) {
    case LinkFault::NoPlugin:
      notice.text = NoticeText::tr("The adapter plugin “%1” cannot be used: %2").arg(source.plugin, detail);
      break;
    case LinkFault::NoInterface:
      notice.text =
          NoticeText::tr("There is no interface %1. Is the adapter plugged in and its driver loaded?")
              .arg(name);
      if (source.plugin == QLatin1String("socketcan"))
        notice.command = QStringLiteral("ip -details link show type can");
      break;
    case LinkFault::InterfaceDown:
      notice.text = NoticeText::tr(
                        "%1 is there but not set up. Set its bit rate and bring it up, listen-only for "
                        "the first look:")
                        .arg(name);
      notice.command = setUpCommand(name, source.bitRate, true);
      break;
    case LinkFault::WrongBitRate:
      notice.text = NoticeText::tr("%1 is set to another bit rate: %2. To change it:").arg(name, reason);
      notice.command =
          QStringLiteral("sudo ip link set %1 down; ").arg(name) + setUpCommand(name, kJ1939BitRate, true);
      break;
    case LinkFault::BitRateRefused:
      notice.text = detail.isEmpty() ? NoticeText::tr("%1 does not take this bit rate.").arg(name)
                                     : NoticeText::tr("%1 does not take this bit rate: %2").arg(name, detail);
      break;
    case LinkFault::NoAnswer:
      notice.text =
          NoticeText::tr("%1 does not answer. Is the adapter plugged in, and used by no other program?")
              .arg(name);
      break;
    case LinkFault::None:
    case LinkFault::Gone:
    case LinkFault::Other: notice.text = NoticeText::tr("%1 cannot be opened: %2").arg(name, reason); break;
  }
  notice.action = Notice::Action::Reconnect;
  return notice;
}

// Traffic that is not what Deckpipe reads.
Notice trafficNotice(const Snapshot& snapshot, const BusRates& rates) {
  const auto rows = deviceRows(*snapshot.view.state);
  const bool hasOurs = std::any_of(rows.begin(), rows.end(), [](const DeviceRow& row) {
    return row.group != DeviceGroup::OtherNodes && row.group != DeviceGroup::CanopenNodes;
  });
  if (hasOurs || rates.extended + rates.standard == 0) return {};
  if (rates.extended == 0) {
    return {
        Severity::Warning,
        NoticeText::tr("Only 11-bit identifiers are heard: this looks like CANopen or another network, not "
                       "the monitors' own J1939 bus. The 6051 CAN Gateway speaks CANopen, by default at "
                       "125 kbit/s; its monitors appear once they are heard.")};
  }
  return {Severity::Warning,
          NoticeText::tr("There is traffic, but no Akron device in it so far: other makers share this bus. "
                         "Is the monitor's controller powered, and on this bus?")};
}

// A person wanted to send where nothing can be sent.
Notice listenOnlyNotice(const Snapshot& snapshot) {
  const SourceStatus& source = snapshot.source;
  if (!source.isListenOnly || snapshot.services->refusal != Refusal::ListenOnly) return {};
  Notice notice{
      Severity::Warning,
      NoticeText::tr("Sending stays locked: %1 is in listen-only mode and cannot send. To send, set "
                     "it up without:")
          .arg(source.interfaceName)};
  notice.command = QStringLiteral("sudo ip link set %1 down; ").arg(source.interfaceName) +
                   setUpCommand(source.interfaceName, source.bitRate, false);
  return notice;
}

Notice runningLink(const Snapshot& snapshot, const BusRates& rates) {
  const SourceStatus& source = snapshot.source;
  const LogView& view = snapshot.view;
  if (source.controller == ControllerState::BusOff) {
    Notice notice{Severity::Fault,
                  NoticeText::tr("The adapter left the bus after too many errors (bus-off): check bit rate, "
                                 "termination and cable, then start it again:")};
    notice.command = QStringLiteral("sudo ip link set %1 type can restart").arg(source.interfaceName);
    return notice;
  }
  if (Notice notice = listenOnlyNotice(snapshot); !notice.text.isEmpty()) return notice;
  const Instant heard = std::max(lastFrame(*view.state), upSince(*view.document));
  if (view.atEnd && heard != kNotYet && view.cursor.time - heard >= kSilence) {
    Notice notice{Severity::Warning,
                  NoticeText::tr(
                      "Connected, but nothing heard for %Ln seconds. Check in this order: is the truck's CAN "
                      "powered; is the bit rate right (J1939 250 kbit/s, gateway 125); 60 ohms between CAN-H "
                      "and CAN-L; CAN-H and CAN-L not swapped.",
                      nullptr, static_cast<int>((view.cursor.time - heard) / 1s))};
    if (!source.simulated) notice.action = Notice::Action::ChangeBitRate;
    return notice;
  }
  if (view.atEnd) return trafficNotice(snapshot, rates);
  return {};
}

}  // namespace

QString setUpCommand(const QString& interfaceName, int bitRate, bool isListenOnly) {
  QString command = QStringLiteral("sudo ip link set %1 up type can bitrate %2")
                        .arg(interfaceName)
                        .arg(bitRate == 0 ? kJ1939BitRate : bitRate);
  command += isListenOnly ? QStringLiteral(" listen-only on") : QStringLiteral(" listen-only off");
  return command;
}

Notice linkNotice(const Snapshot& snapshot, const BusRates& rates) {
  const SourceStatus& source = snapshot.source;
  switch (source.progress) {
    case Progress::Opening:
      return {Severity::Busy,
              NoticeText::tr("Connecting to %1 …")
                  .arg(source.simulated ? NoticeText::tr("the simulated truck") : source.name)};
    case Progress::Failed: return failedLink(source);
    case Progress::Lost: {
      const QString reason = sourceErrorText(source.error);
      Notice notice{
          Severity::Fault,
          reason.isEmpty()
              ? NoticeText::tr("The link to %1 is lost. What was received is kept.").arg(source.interfaceName)
              : NoticeText::tr("The link to %1 is lost: %2. What was received is kept.")
                    .arg(source.interfaceName, reason)};
      notice.action = Notice::Action::Reconnect;
      return notice;
    }
    case Progress::Running: return runningLink(snapshot, rates);
    case Progress::Idle:
    case Progress::Done: break;
  }
  return {};
}

}  // namespace deckpipe
