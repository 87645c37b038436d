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
}};

}  // namespace deckpipe::ctl
