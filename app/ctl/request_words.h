// SPDX-License-Identifier: GPL-3.0-or-later
// The words of deckpipectl for what is asked, how that ended, what became of our own address, and why frames are
// not in a log. They stand on command lines and in JSON: a word never changes once shipped.
#pragma once

#include <string_view>

#include "control/status.h"
#include "log/note.h"

namespace deckpipe::ctl {

constexpr std::string_view requestWord(Request request) { return kRequestFacts[request].key; }

constexpr std::string_view endWord(Request request, RequestEnd end) {
  switch (end) {
    case RequestEnd::None: break;
    case RequestEnd::Answered: return request == Request::Reset ? "restarted" : "answered";
    case RequestEnd::WrongAnswer: return "wrong_answer";
    case RequestEnd::NoAnswer: return "no_answer";
    case RequestEnd::Cancelled: return "cancelled";
    case RequestEnd::LinkLost: return "link_lost";
    case RequestEnd::Gone: return "gone";
    case RequestEnd::AnsweredLate: return "answered_late";
    case RequestEnd::AddressLost: return "address_lost";
    case RequestEnd::NotOnBus: return "not_on_bus";
    case RequestEnd::WentOutLate: return "went_out_late";
    case RequestEnd::GoneWithInterface: return "gone_with_interface";
    case RequestEnd::CannotTell: return "cannot_tell";
  }
  return "open";
}

constexpr std::string_view ownAddressWord(note::OwnAddress::How how) {
  using How = note::OwnAddress::How;
  switch (how) {
    case How::Claimed: return "claimed";
    case How::Lost: return "lost";
    case How::CannotClaim: return "cannot claim";
    case How::SameName: return "same name";
    case How::Locked: return "locked";
    case How::LinkLost: return "link lost";
    case How::InUse: return "in use";
    case How::Disputed: return "disputed";
  }
  return {};
}

constexpr std::string_view leftOutWord(note::LeftOut::Why why) {
  using Why = note::LeftOut::Why;
  switch (why) {
    case Why::CanFd: return "can_fd";
    case Why::NotClassic: return "not_classic";
    case Why::CanXl: return "can_xl";
    case Why::Unreadable: return "unreadable";
    case Why::RecorderLost: return "recorder_lost";
    case Why::NotWhole: return "not_whole";
    case Why::Damaged: return "damaged";
  }
  return {};
}

struct RefusalWords {
  std::string_view word;
  const char* sentence;  // for people: a sentence's end
};
inline constexpr EnumTable<Refusal, RefusalWords> kRefusalWords{{
    {Refusal::None, {"none", "it was refused"}},
    {Refusal::Locked, {"locked", "sending is locked"}},
    {Refusal::NoLink, {"no_link", "the link is not up"}},
    {Refusal::NoAddress, {"no_address", "there is no address of our own"}},
    {Refusal::NoDevice, {"no_device", "there is no such device, or it has no address now"}},
    {Refusal::NotTaken, {"not_taken", "a device of this type does not take it"}},
    {Refusal::Busy, {"busy", "the same is under way already"}},
    {Refusal::TooMuch, {"too_much", "more characters wait than may"}},
    {Refusal::NotLive, {"not_live", "the view is not at the live edge"}},
    {Refusal::LogFull, {"log_full", "there is no room to record what would be sent"}},
    {Refusal::NotHeard, {"not_heard", "the device was not heard for 1 s"}},
    {Refusal::Contested, {"contested", "two nodes claim the address of the device"}},
    {Refusal::ListenOnly, {"listen_only", "the adapter is in listen-only mode"}},
    {Refusal::Disputed, {"disputed", "another node sends from our own address"}},
    {Refusal::FormerPin, {"former_pin", "the device has not said its PIN since the link was down"}},
    {Refusal::OtherMonitors, {"other_monitors", "the monitors that are heard are not exactly those named"}},
    {Refusal::SourceTaken, {"source_taken", "another node uses or holds the joystick's address"}},
    {Refusal::WouldOutrank,
     {"would_outrank",
      "a joystick with a higher address is heard: a person at the truck would be outranked"}},
    {Refusal::EchoUnproven,
     {"echo_unproven",
      "the adapter gives back no echo, so nobody could tell whether our frames reach the bus"}},
    {Refusal::StillWaits, {"still_waits", "a frame of before is not on the bus yet and may still go out"}},
    {Refusal::BusTrouble, {"bus_trouble", "the adapter is bus-off or error-passive"}},
    {Refusal::ArmedElsewhere,
     {"armed_elsewhere", "another Deckpipe on this computer moves monitors at this moment"}},
    {Refusal::NotArmed, {"not_armed", "the joystick is not armed"}},
    {Refusal::NotReleased, {"not_released", "the joystick must be let go first"}},
    {Refusal::Disabled, {"disabled", "a monitor's enable is off"}},
}};

// Why motion ended, by MotionCause.
inline constexpr EnumTable<MotionCause, RefusalWords> kMotionCauseWords{{
    {MotionCause::None, {"none", "it has not ended"}},
    {MotionCause::Released, {"released", "it was let go"}},
    {MotionCause::Disarmed, {"disarmed", "it was disarmed"}},
    {MotionCause::HandNotSeen,
     {"hand_not_seen", "no word for 100 ms that it is held: this computer is too busy"}},
    {MotionCause::Gap, {"gap", "nothing was sent for more than 100 ms: this computer is too busy"}},
    {MotionCause::HeldTooLong, {"held_too_long", "it was held for 60 s"}},
    {MotionCause::NotHeldTooLong, {"not_held_too_long", "it was armed and not held for 120 s"}},
    {MotionCause::Locked, {"locked", "sending was locked"}},
    {MotionCause::LinkLost, {"link_lost", "the link was lost"}},
    {MotionCause::SourceTaken, {"source_taken", "another node claims or uses the joystick's address"}},
    {MotionCause::ControllerAppeared,
     {"controller_appeared", "a controller appeared, changed its address or lost it"}},
    {MotionCause::MonitorGone,
     {"monitor_gone", "a monitor is not heard any more, or its address is contested"}},
    {MotionCause::EnableOff, {"enable_off", "a monitor's enable is off"}},
    {MotionCause::MonitorChanged,
     {"monitor_changed", "a monitor's enable, operational error or stowed bit changed"}},
    {MotionCause::StowAsked, {"stow_asked", "another asks for stow or deploy"}},
    {MotionCause::NotOnBus, {"not_on_bus", "our frames do not reach the bus"}},
    {MotionCause::WriteFailed, {"write_failed", "the adapter did not take a frame"}},
    {MotionCause::BusTrouble, {"bus_trouble", "the adapter is bus-off, error-passive or fails to send"}},
    {MotionCause::ClockJumped, {"clock_jumped", "the computer was asleep"}},
    {MotionCause::WouldOutrank,
     {"would_outrank",
      "a joystick with a higher address is heard: a person at the truck would be outranked"}},
    {MotionCause::WrongWay, {"wrong_way", "a monitor moves against the command"}},
    {MotionCause::NoMotion, {"no_motion", "a monitor does not follow the command"}},
    {MotionCause::AtStop, {"at_stop", "a monitor stands at a hard stop"}},
    {MotionCause::AtSoftLimit, {"at_soft_limit", "a monitor stands at a soft limit"}},
    {MotionCause::Outranked, {"outranked", "a joystick of higher priority commands the same axis"}},
    {MotionCause::NoPermissive, {"no_permissive", "a monitor has no permissive for this direction"}},
}};

}  // namespace deckpipe::ctl
