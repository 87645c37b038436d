// SPDX-License-Identifier: GPL-3.0-or-later
// The fields of every kind of note, in the order in which they are written: what note_codec.cpp writes as
// bytes and note_text.cpp as text. Numbers and names stand in files: they are never changed and never used
// again.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
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
  std::string_view key;  // the word for the kind in machine-readable output
  std::tuple<Fields...> fields;
};
template <typename... Fields>
constexpr Layout<Fields...> layout(std::uint8_t number, std::string_view key, Fields... fields) {
  return {number, key, {fields...}};
}

template <typename T>
struct HasNoLayout;
template <typename T>
constexpr HasNoLayout<T> kLayout{};

template <>
inline constexpr auto kLayout<note::LinkUp> = layout(1, "link_up", field("channel", &note::LinkUp::channel),
                                                     later("adapter", &note::LinkUp::adapter),
                                                     later("bit_rate", &note::LinkUp::bitRate));
template <>
inline constexpr auto kLayout<note::LinkDown> = layout(2, "link_down",
                                                       field("channel", &note::LinkDown::channel),
                                                       field("fault", &note::LinkDown::fault),
                                                       field("words", &note::LinkDown::words));
template <>
inline constexpr auto kLayout<note::Dropped> = layout(3, "dropped", field("channel", &note::Dropped::channel),
                                                      field("count", &note::Dropped::count));
template <>
inline constexpr auto kLayout<note::Locked> = layout(4, "locked", field("channel", &note::Locked::channel));
template <>
inline constexpr auto kLayout<note::Unlocked> = layout(5, "unlocked",
                                                       field("channel", &note::Unlocked::channel));
template <>
inline constexpr auto kLayout<note::Mark> = layout(6, "mark", field("text", &note::Mark::text));
template <>
inline constexpr auto kLayout<note::DriveSaid> = layout(7, "drive_said",
                                                        field("channel", &note::DriveSaid::channel),
                                                        field("address", &note::DriveSaid::address),
                                                        field("is_drive", &note::DriveSaid::isDrive));
template <>
inline constexpr auto kLayout<note::OwnAddress> = layout(8, "own_address",
                                                         field("channel", &note::OwnAddress::channel),
                                                         field("address", &note::OwnAddress::address),
                                                         field("how", &note::OwnAddress::how));
template <>
inline constexpr auto kLayout<note::Asked> = layout(9, "asked", field("channel", &note::Asked::channel),
                                                    field("address", &note::Asked::address),
                                                    field("pin", &note::Asked::pin),
                                                    field("ask", &note::Asked::request));
template <>
inline constexpr auto kLayout<note::RequestEnded> = layout(10, "ask_ended",
                                                           field("channel", &note::RequestEnded::channel),
                                                           field("address", &note::RequestEnded::address),
                                                           field("pin", &note::RequestEnded::pin),
                                                           field("ask", &note::RequestEnded::request),
                                                           field("end", &note::RequestEnded::end));
template <>
inline constexpr auto kLayout<note::Pipe> = layout(11, "pipe", field("channel", &note::Pipe::channel),
                                                   field("address", &note::Pipe::address),
                                                   field("pin", &note::Pipe::pin),
                                                   field("event", &note::Pipe::event),
                                                   field("file", &note::Pipe::file));
template <>
inline constexpr auto kLayout<note::RequestWaits> = layout(12, "ask_waits",
                                                           field("channel", &note::RequestWaits::channel),
                                                           field("address", &note::RequestWaits::address),
                                                           field("pin", &note::RequestWaits::pin),
                                                           field("ask", &note::RequestWaits::request));
template <>
inline constexpr auto kLayout<note::StillWaits> = layout(13, "still_waits",
                                                         field("channel", &note::StillWaits::channel),
                                                         field("count", &note::StillWaits::count));
template <>
inline constexpr auto kLayout<note::LeftOut> = layout(14, "left_out",
                                                      field("channel", &note::LeftOut::channel),
                                                      field("why", &note::LeftOut::why),
                                                      field("count", &note::LeftOut::count));
template <>
inline constexpr auto kLayout<note::Label> = layout(15, "label", field("pin", &note::Label::pin),
                                                    field("text", &note::Label::text));
template <>
inline constexpr auto kLayout<note::Added> = layout(16, "added", field("count", &note::Added::count));
template <>
inline constexpr auto kLayout<note::Filtered> = layout(17, "filtered", field("text", &note::Filtered::text));
template <>
inline constexpr auto kLayout<note::AnglesBefore> =
    layout(18, "angles_before", field("channel", &note::AnglesBefore::channel),
           field("address", &note::AnglesBefore::address), field("pin", &note::AnglesBefore::pin),
           field("ask", &note::AnglesBefore::request), field("rotation", &note::AnglesBefore::rotation),
           field("elevation", &note::AnglesBefore::elevation));
template <>
inline constexpr auto kLayout<note::RanUntil> = layout(19, "ran_until");

template <>
inline constexpr auto kLayout<note::MotionArmed> = layout(20, "motion_armed",
                                                          field("channel", &note::MotionArmed::channel),
                                                          field("address", &note::MotionArmed::address),
                                                          field("pin", &note::MotionArmed::pin),
                                                          field("limit", &note::MotionArmed::limit),
                                                          field("is_proven", &note::MotionArmed::isProven),
                                                          field("platform", &note::MotionArmed::platform));
template <>
inline constexpr auto kLayout<note::MotionEnded> = layout(
    21, "motion_ended", field("channel", &note::MotionEnded::channel),
    field("address", &note::MotionEnded::address), field("cause", &note::MotionEnded::cause),
    field("is_disarmed", &note::MotionEnded::isDisarmed), field("messages", &note::MotionEnded::messages),
    field("period_us", &note::MotionEnded::period), field("worst_gap_us", &note::MotionEnded::worstGap));
template <>
inline constexpr auto kLayout<note::MotionLate> = layout(22, "motion_late",
                                                         field("channel", &note::MotionLate::channel),
                                                         field("address", &note::MotionLate::address));

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

// What the readers of both forms have in common. `Own` takes numbers and texts. Once something was not there, or not to
// be understood, it takes nothing more.
template <typename Own>
class FieldReader {
 public:
  bool isDamaged() const { return m_isDamaged; }
  bool isUnknown() const { return m_isUnknown; }

  template <typename T>
  requires std::is_unsigned_v<T>
  void take(T& number) { own().takeNumber(number); }
  void take(bool& flag) {
    std::uint8_t number = 0;
    take(number);
    if (number > 1) m_isDamaged = true;
    flag = number != 0;
  }
  template <typename E>
  requires std::is_enum_v<E>
  void take(E& value) {
    std::uint8_t number = 0;
    take(number);
    value = static_cast<E>(number);
    if (!isKnown(value)) m_isUnknown = true;
  }
  void take(Channel& channel) { take(channel.value); }
  void take(Pin& pin) {
    const std::string text = own().takeText();
    const auto parsed = Pin::parse(text);
    if (!text.empty() && !parsed) m_isDamaged = true;
    pin = parsed.value_or(Pin());
  }

 protected:
  bool m_isDamaged = false;

 private:
  Own& own() { return static_cast<Own&>(*this); }
  bool m_isUnknown = false;
};

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
