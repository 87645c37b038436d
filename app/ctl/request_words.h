// SPDX-License-Identifier: GPL-3.0-or-later
// The words of deckpipectl for what is asked, how that ended, what became of our own address, and why frames are
// not in a log. They stand on command lines and in JSON: a word never changes once shipped.
#pragma once

#include <QString>
#include <string_view>

#include "control/status.h"
#include "log/note.h"

namespace deckpipe::ctl {

constexpr std::string_view requestWord(Request request) { return kRequestFacts[request].key; }

inline QString requestWordText(Request request) {
  const std::string_view word = requestWord(request);
  return QString::fromLatin1(word.data(), static_cast<qsizetype>(word.size()));
}

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
  }
  return {};
}

constexpr std::string_view refusalWord(Refusal refusal) {
  switch (refusal) {
    case Refusal::None: break;
    case Refusal::Locked: return "locked";
    case Refusal::NoLink: return "no_link";
    case Refusal::NoAddress: return "no_address";
    case Refusal::NoDevice: return "no_device";
    case Refusal::NotTaken: return "not_taken";
    case Refusal::Busy: return "busy";
    case Refusal::TooMuch: return "too_much";
    case Refusal::NotLive: return "not_live";
    case Refusal::LogFull: return "log_full";
    case Refusal::NotHeard: return "not_heard";
    case Refusal::Contested: return "contested";
    case Refusal::ListenOnly: return "listen_only";
    case Refusal::Disputed: return "disputed";
  }
  return "none";
}

// For people: a sentence's end.
constexpr const char* refusalSentence(Refusal refusal) {
  switch (refusal) {
    case Refusal::None: break;
    case Refusal::Locked: return "sending is locked";
    case Refusal::NoLink: return "the link is not up";
    case Refusal::NoAddress: return "there is no address of our own";
    case Refusal::NoDevice: return "there is no such device, or it has no address now";
    case Refusal::NotTaken: return "a device of this type does not take it";
    case Refusal::Busy: return "the same is under way already";
    case Refusal::TooMuch: return "more characters wait than may";
    case Refusal::NotLive: return "the view is not at the live edge";
    case Refusal::LogFull: return "there is no room to record what would be sent";
    case Refusal::NotHeard: return "the device was not heard for 1 s";
    case Refusal::Contested: return "two nodes claim the address of the device";
    case Refusal::ListenOnly: return "the adapter is in listen-only mode";
    case Refusal::Disputed: return "another node sends from our own address";
  }
  return "it was refused";
}

}  // namespace deckpipe::ctl
