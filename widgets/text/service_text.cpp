// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/service_text.h"

#include <QCoreApplication>

namespace deckpipe {
namespace {

struct ServiceText {
  Q_DECLARE_TR_FUNCTIONS(ServiceText)
};

}  // namespace

QString requestText(Request request) {
  switch (request) {
    case Request::Fault: return ServiceText::tr("Faults");
    case Request::Firmware: return ServiceText::tr("Firmware");
    case Request::Pcode: return ServiceText::tr("pCode");
    case Request::Config: return ServiceText::tr("Configuration");
    case Request::Vista: return ServiceText::tr("Vista status");
    case Request::ZeroAxes: return ServiceText::tr("Zero axes");
    case Request::Reset: return ServiceText::tr("Reset");
    case Request::SetupMode: return ServiceText::tr("Setup mode");
    case Request::Count: break;
  }
  return {};
}

QString requestEndText(Request request, RequestEnd end) {
  switch (end) {
    case RequestEnd::None: return {};
    case RequestEnd::Answered:
      return request == Request::Reset ? ServiceText::tr("restarted") : ServiceText::tr("answered");
    case RequestEnd::WrongAnswer: return ServiceText::tr("answered with a wrong length");
    case RequestEnd::NoAnswer: return ServiceText::tr("no answer");
    case RequestEnd::Cancelled: return ServiceText::tr("cancelled");
    case RequestEnd::LinkLost: return ServiceText::tr("link lost");
    case RequestEnd::Gone: return ServiceText::tr("device has no address");
    case RequestEnd::AnsweredLate: return ServiceText::tr("answered too late");
    case RequestEnd::AddressLost: return ServiceText::tr("the console lost its address");
    case RequestEnd::NotOnBus: return ServiceText::tr("not on the bus");
    case RequestEnd::WentOutLate: return ServiceText::tr("went out late");
    case RequestEnd::GoneWithInterface:
      return ServiceText::tr("gone with the interface before it was on the bus");
    case RequestEnd::CannotTell: return ServiceText::tr("whether it went out cannot be told");
  }
  return {};
}

QString linkFaultText(LinkFault fault) {
  switch (fault) {
    case LinkFault::None: return {};
    case LinkFault::NoPlugin: return ServiceText::tr("its plugin cannot be used");
    case LinkFault::NoInterface: return ServiceText::tr("there is no such CAN interface");
    case LinkFault::InterfaceDown: return ServiceText::tr("the interface is down");
    case LinkFault::WrongBitRate: return ServiceText::tr("the interface has another bit rate");
    case LinkFault::BitRateRefused: return ServiceText::tr("the adapter does not take the bit rate");
    case LinkFault::NoAnswer: return ServiceText::tr("the adapter does not answer");
    case LinkFault::Gone: return ServiceText::tr("the adapter is gone");
    case LinkFault::Other: return ServiceText::tr("the adapter reports a fault");
  }
  return {};
}

QString linkFaultText(LinkFault fault, const QString& words) {
  if (words.isEmpty()) return linkFaultText(fault);
  if (fault == LinkFault::None || fault == LinkFault::Other) return words;
  return QStringLiteral("%1 (%2)").arg(linkFaultText(fault), words);
}

QString refusalText(Refusal refusal) {
  switch (refusal) {
    case Refusal::None: return {};
    case Refusal::Locked: return ServiceText::tr("Sending is locked.");
    case Refusal::NoLink: return ServiceText::tr("The link is not up.");
    case Refusal::NoAddress: return ServiceText::tr("The console has no address on the bus.");
    case Refusal::NoDevice: return ServiceText::tr("The device is not there or has no address.");
    case Refusal::NotTaken: return ServiceText::tr("This type of device does not take it.");
    case Refusal::Busy: return ServiceText::tr("It is under way already.");
    case Refusal::TooMuch: return ServiceText::tr("That is more than may wait to be sent.");
    case Refusal::NotLive: return ServiceText::tr("The view stands in the past, where nothing can be begun.");
    case Refusal::LogFull: return ServiceText::tr("The log takes no more; what is not recorded is not sent.");
    case Refusal::NotHeard: return ServiceText::tr("The device was not heard for 1 s.");
    case Refusal::Contested: return ServiceText::tr("Two nodes claim the device's address at this moment.");
    case Refusal::Disputed:
      return ServiceText::tr("Another node sends from the console's address at this moment.");
    case Refusal::FormerPin:
      return ServiceText::tr("The device has not said its PIN since the link was down.");
    case Refusal::ListenOnly: return ServiceText::tr("The adapter is in listen-only mode: it cannot send.");
    case Refusal::OtherMonitors:
      return ServiceText::tr("The monitors that are heard are not exactly those that were named.");
    case Refusal::SourceTaken: return ServiceText::tr("Another node uses or holds the joystick's address.");
    case Refusal::WouldOutrank:
      return ServiceText::tr(
          "A joystick of lower priority is heard: a person at the truck would be outranked.");
    case Refusal::EchoUnproven: return ServiceText::tr("Nobody can tell whether our frames reach the bus.");
    case Refusal::StillWaits: return ServiceText::tr("A frame of before may still go out.");
    case Refusal::BusTrouble: return ServiceText::tr("The adapter is bus-off or error-passive.");
    case Refusal::ArmedElsewhere:
      return ServiceText::tr("Another Deckpipe on this computer moves monitors at this moment.");
    case Refusal::NotArmed: return ServiceText::tr("The joystick is not armed.");
    case Refusal::NotReleased: return ServiceText::tr("The joystick must be let go first.");
    case Refusal::Disabled: return ServiceText::tr("A monitor's enable is off.");
  }
  return {};
}

QString motionCauseText(MotionCause cause) {
  switch (cause) {
    case MotionCause::None: return {};
    case MotionCause::Released: return ServiceText::tr("let go");
    case MotionCause::Disarmed: return ServiceText::tr("by hand");
    case MotionCause::HandNotSeen: return ServiceText::tr("no fresh word that it is held");
    case MotionCause::Gap: return ServiceText::tr("nothing was sent for more than 100 ms");
    case MotionCause::HeldTooLong: return ServiceText::tr("held for 60 s");
    case MotionCause::NotHeldTooLong: return ServiceText::tr("not held for 120 s");
    case MotionCause::Locked: return ServiceText::tr("transmit locked");
    case MotionCause::LinkLost: return ServiceText::tr("link lost");
    case MotionCause::SourceTaken: return ServiceText::tr("another node claims or uses its address");
    case MotionCause::ControllerAppeared:
      return ServiceText::tr("a controller appeared, changed its address or lost it");
    case MotionCause::MonitorGone:
      return ServiceText::tr("a monitor is not heard any more, or its address is contested");
    case MotionCause::EnableOff: return ServiceText::tr("a monitor's enable is off");
    case MotionCause::MonitorChanged:
      return ServiceText::tr("a monitor's enable, operational error or stowed bit changed");
    case MotionCause::StowAsked: return ServiceText::tr("another asks for stow or deploy");
    case MotionCause::NotOnBus: return ServiceText::tr("our frames do not reach the bus");
    case MotionCause::WriteFailed: return ServiceText::tr("the adapter did not take a frame");
    case MotionCause::BusTrouble:
      return ServiceText::tr("the adapter is bus-off, error-passive or fails to send");
    case MotionCause::ClockJumped: return ServiceText::tr("the computer was asleep");
    case MotionCause::WouldOutrank: return ServiceText::tr("a joystick of lower priority is heard");
    case MotionCause::WrongWay: return ServiceText::tr("a monitor moves against the command");
    case MotionCause::NoMotion: return ServiceText::tr("a monitor does not follow the command");
    case MotionCause::AtStop: return ServiceText::tr("a monitor stands at a hard stop");
    case MotionCause::AtSoftLimit: return ServiceText::tr("a monitor stands at a soft limit");
    case MotionCause::Outranked:
      return ServiceText::tr("a joystick of higher priority commands the same axis");
    case MotionCause::NoPermissive: return ServiceText::tr("a monitor has no permissive for this direction");
  }
  return {};
}

QString claimText(const ClaimStatus& claim) {
  const QString address = QString::number(claim.address.value, 16).toUpper();
  switch (claim.progress) {
    case ClaimStatus::Progress::Off: return ServiceText::tr("no address");
    case ClaimStatus::Progress::Asking: return ServiceText::tr("asking who is there");
    case ClaimStatus::Progress::Claiming:
      return claim.isOnBus ? ServiceText::tr("claiming address %1").arg(address)
                           : ServiceText::tr("claim of address %1 not on the bus yet").arg(address);
    case ClaimStatus::Progress::Claimed:
      return claim.isDisputed ? ServiceText::tr("address %1, another node sends from it").arg(address)
                              : ServiceText::tr("address %1").arg(address);
    case ClaimStatus::Progress::CannotClaim: return ServiceText::tr("no address free");
    case ClaimStatus::Progress::SameName: return ServiceText::tr("another node has our NAME");
  }
  return {};
}

QString pipeEventText(PipeEvent event) {
  switch (event) {
    case PipeEvent::FileBegan: return ServiceText::tr("file begun");
    case PipeEvent::FileDone: return ServiceText::tr("file sent");
    case PipeEvent::FileCancelled: return ServiceText::tr("file cancelled");
    case PipeEvent::FileAborted: return ServiceText::tr("file given up");
    case PipeEvent::Stalled: return ServiceText::tr("no ack");
    case PipeEvent::AckLate: return ServiceText::tr("the ack came late");
    case PipeEvent::Resent: return ServiceText::tr("packet sent again");
    case PipeEvent::Skipped: return ServiceText::tr("packet skipped");
    case PipeEvent::Dropped: return ServiceText::tr("what waited was dropped");
    case PipeEvent::DeviceRestarted: return ServiceText::tr("the device restarted meanwhile");
  }
  return {};
}

QString restText(const PipeStatus& pipe) {
  const bool isFile = pipe.isSendingFile();
  switch (pipe.rest) {
    case PipeStatus::Rest::Ask: return {};
    case PipeStatus::Rest::Resend:
      return ServiceText::tr("Packets without an ack are sent again, so far %1")
          .arg(isFile ? pipe.fileResent : pipe.textResent);
    case PipeStatus::Rest::Skip:
      return ServiceText::tr("Packets without an ack are skipped, so far %1")
          .arg(isFile ? pipe.fileSkipped : pipe.textSkipped);
  }
  return {};
}

QString typedDoubtText(const PipeStatus& pipe) {
  if (pipe.textSkipped == 0 && pipe.textResent == 0) return {};
  return ServiceText::tr(
             "Of what was typed last, %1 packets were skipped and %2 sent again: what arrived is "
             "not known.")
      .arg(pipe.textSkipped)
      .arg(pipe.textResent);
}

QString stallText(const PipeStatus& pipe) {
  const auto inDoubt = [](const QString& why) {
    return ServiceText::tr("%1 Whether the packet arrived is not known.").arg(why);
  };
  switch (pipe.stall) {
    case PipeStatus::Stall::None: return {};
    case PipeStatus::Stall::NoAck: return inDoubt(ServiceText::tr("No ack from the device within 1 s."));
    case PipeStatus::Stall::Moved:
      return inDoubt(ServiceText::tr("No ack; the device is at another address now."));
    case PipeStatus::Stall::Gone:
      return inDoubt(ServiceText::tr("No ack; the device has no address any more."));
    case PipeStatus::Stall::NotOnBus:
      return ServiceText::tr("The packet is not on the bus yet; it may still go out.");
    case PipeStatus::Stall::NotTaken:
      return ServiceText::tr("The adapter did not take the packet: it was not sent.");
    case PipeStatus::Stall::NotSent:
      return ServiceText::tr("The next packet was not sent. %1").arg(refusalText(pipe.refusal));
  }
  return {};
}

}  // namespace deckpipe
