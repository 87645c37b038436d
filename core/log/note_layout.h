// SPDX-License-Identifier: GPL-3.0-or-later
// The fields of every kind of note, in the order in which they are written: what note_codec.cpp writes as
// bytes and note_text.cpp as text. Numbers and names stand in files: they are never changed and never used
// again.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <tuple>
#include <utility>

#include "log/note.h"

namespace deckpipe::layouts {

template <typename Member>
struct Field {
  std::string_view name;
  Member member;
  bool isLater;  // the first version did not have it: it may be missing
};
template <typename Member>
constexpr Field<Member> field(std::string_view name, Member member) {
  return {name, member, false};
}
template <typename Member>
constexpr Field<Member> later(std::string_view name, Member member) {
  return {name, member, true};
}

template <typename... Fields>
struct Layout {
  std::uint8_t number;
  std::tuple<Fields...> fields;
};
template <typename... Fields>
constexpr Layout<Fields...> layout(std::uint8_t number, Fields... fields) {
  return {number, {fields...}};
}

template <typename T>
struct HasNoLayout;
template <typename T>
constexpr HasNoLayout<T> kLayout{};

template <>
inline constexpr auto kLayout<note::LinkUp> = layout(1, field("channel", &note::LinkUp::channel),
                                                     later("adapter", &note::LinkUp::adapter),
                                                     later("bit_rate", &note::LinkUp::bitRate));
template <>
inline constexpr auto kLayout<note::LinkDown> = layout(2, field("channel", &note::LinkDown::channel),
                                                       field("fault", &note::LinkDown::fault),
                                                       field("words", &note::LinkDown::words));
template <>
inline constexpr auto kLayout<note::Dropped> = layout(3, field("channel", &note::Dropped::channel),
                                                      field("count", &note::Dropped::count));
template <>
inline constexpr auto kLayout<note::Locked> = layout(4, field("channel", &note::Locked::channel));
template <>
inline constexpr auto kLayout<note::Unlocked> = layout(5, field("channel", &note::Unlocked::channel));
template <>
inline constexpr auto kLayout<note::Mark> = layout(6, field("text", &note::Mark::text));
template <>
inline constexpr auto kLayout<note::DriveSaid> = layout(7, field("channel", &note::DriveSaid::channel),
                                                        field("address", &note::DriveSaid::address),
                                                        field("is_drive", &note::DriveSaid::isDrive));
template <>
inline constexpr auto kLayout<note::OwnAddress> = layout(8, field("channel", &note::OwnAddress::channel),
                                                         field("address", &note::OwnAddress::address),
                                                         field("how", &note::OwnAddress::how));
template <>
inline constexpr auto kLayout<note::Asked> = layout(9, field("channel", &note::Asked::channel),
                                                    field("address", &note::Asked::address),
                                                    field("pin", &note::Asked::pin),
                                                    field("ask", &note::Asked::request));
template <>
inline constexpr auto kLayout<note::RequestEnded> = layout(10, field("channel", &note::RequestEnded::channel),
                                                           field("address", &note::RequestEnded::address),
                                                           field("pin", &note::RequestEnded::pin),
                                                           field("ask", &note::RequestEnded::request),
                                                           field("end", &note::RequestEnded::end));
template <>
inline constexpr auto kLayout<note::Pipe> = layout(11, field("channel", &note::Pipe::channel),
                                                   field("address", &note::Pipe::address),
                                                   field("pin", &note::Pipe::pin),
                                                   field("event", &note::Pipe::event),
                                                   field("file", &note::Pipe::file));
template <>
inline constexpr auto kLayout<note::RequestWaits> = layout(12, field("channel", &note::RequestWaits::channel),
                                                           field("address", &note::RequestWaits::address),
                                                           field("pin", &note::RequestWaits::pin),
                                                           field("ask", &note::RequestWaits::request));
template <>
inline constexpr auto kLayout<note::StillWaits> = layout(13, field("channel", &note::StillWaits::channel),
                                                         field("count", &note::StillWaits::count));
template <>
inline constexpr auto kLayout<note::LeftOut> = layout(14, field("channel", &note::LeftOut::channel),
                                                      field("why", &note::LeftOut::why),
                                                      field("count", &note::LeftOut::count));
template <>
inline constexpr auto kLayout<note::Label> = layout(15, field("pin", &note::Label::pin),
                                                    field("text", &note::Label::text));
template <>
inline constexpr auto kLayout<note::Added> = layout(16, field("count", &note::Added::count));

namespace checks {

// Whether a struct has so many fields: as many as its braces take. A layout must name each of them.
struct AnyField {
  template <typename T>
  operator T() const;
};
template <typename T, std::size_t... I>
constexpr bool takesFields(std::index_sequence<I...>) {
  return requires { T{((void)I, AnyField{})...}; };
}
template <typename T>
constexpr std::size_t kFields = std::tuple_size_v<decltype(kLayout<T>.fields)>;
template <typename T>
constexpr bool kNamesEveryField = takesFields<T>(std::make_index_sequence<kFields<T>>{}) &&
                                  !takesFields<T>(std::make_index_sequence<kFields<T> + 1>{});

template <typename... Kinds>
constexpr bool areSound(const std::variant<Kinds...>*) {
  std::array numbers{kLayout<Kinds>.number...};
  std::ranges::sort(numbers);
  const bool areUnique = std::ranges::adjacent_find(numbers) == numbers.end() && numbers[0] != 0;
  return areUnique && (kNamesEveryField<Kinds> && ...);
}
static_assert(areSound(static_cast<const NoteValue*>(nullptr)),
              "two kinds have one number, or a layout leaves a field out");

}  // namespace checks

template <typename T, typename Reader, typename... Fields>
T takeFields(Reader& reader, const std::tuple<Fields...>& fields) {
  T value;
  std::apply([&](const auto&... one) { (reader.take(one, value.*one.member), ...); }, fields);
  return value;
}

// The value of the kind with this number, each field taken by reader.take(field, value); nothing if no kind
// has it.
template <typename Reader, typename... Kinds>
std::optional<NoteValue> takeValue(std::uint8_t number, Reader& reader, const std::variant<Kinds...>*) {
  std::optional<NoteValue> value;
  (void)((kLayout<Kinds>.number == number &&
          (value = takeFields<Kinds>(reader, kLayout<Kinds>.fields), true)) ||
         ...);
  return value;
}
template <typename Reader>
std::optional<NoteValue> takeValue(std::uint8_t number, Reader& reader) {
  return takeValue(number, reader, static_cast<const NoteValue*>(nullptr));
}

}  // namespace deckpipe::layouts
