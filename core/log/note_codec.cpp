// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/note_codec.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

namespace deckpipe {
namespace {

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

// The one list of numbers and fields. Numbers are never changed and never used again.
template <>
constexpr auto kLayout<note::LinkUp> = layout(1, &note::LinkUp::channel);
template <>
constexpr auto kLayout<note::LinkDown> = layout(2, &note::LinkDown::channel, &note::LinkDown::fault,
                                                &note::LinkDown::words);
template <>
constexpr auto kLayout<note::Dropped> = layout(3, &note::Dropped::channel, &note::Dropped::count);
template <>
constexpr auto kLayout<note::Locked> = layout(4, &note::Locked::channel);
template <>
constexpr auto kLayout<note::Unlocked> = layout(5, &note::Unlocked::channel);
template <>
constexpr auto kLayout<note::Mark> = layout(6, &note::Mark::text);
template <>
constexpr auto kLayout<note::DriveSaid> = layout(7, &note::DriveSaid::channel, &note::DriveSaid::address,
                                                 &note::DriveSaid::isDrive);
template <>
constexpr auto kLayout<note::OwnAddress> = layout(8, &note::OwnAddress::channel, &note::OwnAddress::address,
                                                  &note::OwnAddress::how);
template <>
constexpr auto kLayout<note::Asked> = layout(9, &note::Asked::channel, &note::Asked::address,
                                             &note::Asked::pin, &note::Asked::ask);
template <>
constexpr auto kLayout<note::AskEnded> = layout(10, &note::AskEnded::channel, &note::AskEnded::address,
                                                &note::AskEnded::pin, &note::AskEnded::ask,
                                                &note::AskEnded::end);
template <>
constexpr auto kLayout<note::Pipe> = layout(11, &note::Pipe::channel, &note::Pipe::address, &note::Pipe::pin,
                                            &note::Pipe::event, &note::Pipe::file);
template <>
constexpr auto kLayout<note::AskWaits> = layout(12, &note::AskWaits::channel, &note::AskWaits::address,
                                                &note::AskWaits::pin, &note::AskWaits::ask);
template <>
constexpr auto kLayout<note::StillWaits> = layout(13, &note::StillWaits::channel, &note::StillWaits::count);

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
constexpr bool areLayoutsSound(const std::variant<Kinds...>*) {
  std::array numbers{kLayout<Kinds>.number...};
  std::ranges::sort(numbers);
  const bool areUnique = std::ranges::adjacent_find(numbers) == numbers.end() && numbers[0] != 0;
  return areUnique && (kNamesEveryField<Kinds> && ...);
}
static_assert(areLayoutsSound(static_cast<const NoteValue*>(nullptr)),
              "two kinds have one number, or a layout leaves a field out");

class NoteWriter {
 public:
  explicit NoteWriter(std::vector<std::uint8_t>& out) : m_out(out) {}

  template <typename T>
  requires std::is_unsigned_v<T>
  void put(T number) {
    for (std::size_t i = 0; i < sizeof(T); ++i)
      m_out.push_back(static_cast<std::uint8_t>(std::uint64_t{number} >> 8 * i));
  }
  template <typename E>
  requires std::is_enum_v<E>
  void put(E value) { put(static_cast<std::uint8_t>(value)); }
  void put(Instant time) { put(static_cast<std::uint64_t>(time.ns)); }
  void put(Channel channel) { put(channel.value); }
  void put(Address address) { put(address.value); }
  void put(const Pin& pin) { putText(pin.text()); }
  void put(const NoteText& text) { putText(text.str()); }

 private:
  void putText(std::string_view text) {
    put(static_cast<std::uint8_t>(text.size()));
    m_out.insert(m_out.end(), text.begin(), text.end());
  }
  static_assert(NoteText::kMaxBytes <= 0xFF && Pin::kLength <= 0xFF, "a text's length is one byte");

  std::vector<std::uint8_t>& m_out;
};

// Once something was not there, or not to be understood, nothing more is read.
class Reader {
 public:
  explicit Reader(std::span<const std::uint8_t> bytes) : m_bytes(bytes) {}

  bool isDamaged() const { return m_isDamaged; }
  bool isUnknown() const { return m_isUnknown; }

  template <typename T>
  requires std::is_unsigned_v<T>
  void take(T& number) {
    const auto bytes = front(sizeof(T));
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i) sum |= std::uint64_t{bytes[i]} << 8 * i;
    number = static_cast<T>(sum);
  }
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
  void take(Instant& time) {
    std::uint64_t ns = 0;
    take(ns);
    time.ns = static_cast<std::int64_t>(ns);
  }
  void take(Channel& channel) { take(channel.value); }
  void take(Address& address) { take(address.value); }
  void take(Pin& pin) {
    const std::string text = takeText();
    const auto parsed = Pin::parse(text);
    if (!text.empty() && !parsed) m_isDamaged = true;
    pin = parsed.value_or(Pin());
  }
  void take(NoteText& text) { text = takeText(); }

 private:
  std::span<const std::uint8_t> front(std::size_t size) {
    if (size > m_bytes.size()) m_isDamaged = true;
    if (m_isDamaged) return {};
    return std::exchange(m_bytes, m_bytes.subspan(size)).first(size);
  }
  std::string takeText() {
    std::uint8_t length = 0;
    take(length);
    const auto bytes = front(length);
    return {bytes.begin(), bytes.end()};
  }

  std::span<const std::uint8_t> m_bytes;
  bool m_isDamaged = false;
  bool m_isUnknown = false;
};

template <typename T>
T takeFields(Reader& reader) {
  T value;
  std::apply([&](auto... fields) { (reader.take(value.*fields), ...); }, kLayout<T>.fields);
  return value;
}

// Nothing if no kind has this number.
template <typename... Kinds>
std::optional<NoteValue> takeValue(std::uint8_t number, Reader& reader, const std::variant<Kinds...>*) {
  std::optional<NoteValue> value;
  (void)((kLayout<Kinds>.number == number && (value = takeFields<Kinds>(reader), true)) || ...);
  return value;
}

constexpr std::size_t kLengthBytes = 2;

}  // namespace

void appendNote(std::vector<std::uint8_t>& out, const Note& note) {
  std::vector<std::uint8_t> bytes;
  NoteWriter writer(bytes);
  std::visit(
      [&]<typename T>(const T& value) {
        writer.put(kLayout<T>.number);
        writer.put(note.frame);
        writer.put(note.time);
        std::apply([&](auto... fields) { (writer.put(value.*fields), ...); }, kLayout<T>.fields);
      },
      note.value);
  NoteWriter(out).put(static_cast<std::uint16_t>(bytes.size()));
  out.insert(out.end(), bytes.begin(), bytes.end());
}

Result<std::variant<Note, UnknownNote>, NoteFault> takeNote(std::span<const std::uint8_t>& bytes) {
  if (bytes.size() < kLengthBytes) return Failure{NoteFault::Cut};
  const std::size_t length = bytes[0] | static_cast<std::size_t>(bytes[1]) << 8;
  if (bytes.size() - kLengthBytes < length) return Failure{NoteFault::Cut};
  Reader reader(bytes.subspan(kLengthBytes, length));
  std::uint8_t kind = 0;
  Note note;
  reader.take(kind);
  reader.take(note.frame);
  reader.take(note.time);
  const auto value = takeValue(kind, reader, static_cast<const NoteValue*>(nullptr));
  if (reader.isDamaged() || kind == 0) return Failure{NoteFault::Damaged};
  bytes = bytes.subspan(kLengthBytes + length);
  if (!value || reader.isUnknown())
    return std::variant<Note, UnknownNote>(UnknownNote{note.frame, note.time, kind});
  note.value = *value;
  return std::variant<Note, UnknownNote>(std::move(note));
}

}  // namespace deckpipe
