// SPDX-License-Identifier: GPL-3.0-or-later
// Notes of every kind, each field unlike its default. A kind without a sample does not compile.
#pragma once

#include <vector>

#include "log/note.h"

namespace deckpipe::test {

inline constexpr Channel kNotedChannel{2};
inline constexpr Address kNotedAddress{0x81};
inline const Pin kNotedPin = *Pin::parse("1032AE100801035");

template <typename Kind>
struct HasNoSample;
template <typename Kind>
inline const HasNoSample<Kind> kSample{};

template <>
inline const note::Mark kSample<note::Mark>{"water on"};
template <>
inline const note::LinkUp kSample<note::LinkUp>{kNotedChannel, "socketcan can0", 250'000};
template <>
inline const note::LinkDown kSample<note::LinkDown>{kNotedChannel, LinkFault::Gone, "Network is down"};
template <>
inline const note::Dropped kSample<note::Dropped>{kNotedChannel, 0x1'0000'0002};
template <>
inline const note::Locked kSample<note::Locked>{kNotedChannel};
template <>
inline const note::Unlocked kSample<note::Unlocked>{kNotedChannel};
template <>
inline const note::DriveSaid kSample<note::DriveSaid>{kNotedChannel, kNotedAddress, false};
template <>
inline const note::OwnAddress kSample<note::OwnAddress>{kNotedChannel, kNotedAddress,
                                                        note::OwnAddress::How::Lost};
template <>
inline const note::Asked kSample<note::Asked>{kNotedChannel, kNotedAddress, kNotedPin, Request::Reset};
template <>
inline const note::RequestEnded kSample<note::RequestEnded>{kNotedChannel, kNotedAddress, kNotedPin,
                                                            Request::Vista, RequestEnd::AnsweredLate};
template <>
inline const note::RequestWaits kSample<note::RequestWaits>{kNotedChannel, kNotedAddress, kNotedPin,
                                                            Request::ZeroAxes};
template <>
inline const note::StillWaits kSample<note::StillWaits>{kNotedChannel, 5};
template <>
inline const note::Pipe kSample<note::Pipe>{kNotedChannel, kNotedAddress, kNotedPin, PipeEvent::FileDone,
                                            "axis.txt"};

template <>
inline const note::LeftOut kSample<note::LeftOut>{kNotedChannel, note::LeftOut::Why::NotClassic, 7};
template <>
inline const note::Label kSample<note::Label>{kNotedPin, "front bumper"};
template <>
inline const note::Added kSample<note::Added>{9};
template <>
inline const note::Filtered kSample<note::Filtered>{"pgn=EF00 and sa=80"};
template <>
inline const note::AnglesBefore kSample<note::AnglesBefore>{kNotedChannel,  kNotedAddress,    kNotedPin,
                                                            Request::Reset, {.tenths = -473}, {.tenths = {}}};
template <>
inline const note::RanUntil kSample<note::RanUntil>{};

template <>
inline const note::MotionArmed kSample<note::MotionArmed>{kNotedChannel, kNotedAddress, kNotedPin,
                                                          300,           true,          "xcb"};
template <>
inline const note::MotionEnded kSample<note::MotionEnded>{
    kNotedChannel, kNotedAddress, MotionCause::MonitorGone, true, 50, 20'001, 33'000};
template <>
inline const note::MotionLate kSample<note::MotionLate>{kNotedChannel, kNotedAddress};

template <typename... Kinds>
std::vector<NoteValue> samplesOf(const std::variant<Kinds...>*) {
  return {kSample<Kinds>...};
}
// One of each kind, in the order of NoteValue.
inline std::vector<NoteValue> noteSamples() { return samplesOf(static_cast<const NoteValue*>(nullptr)); }

}  // namespace deckpipe::test
