// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/note_codec.h"

#include <limits>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "log/note_layout.h"

namespace deckpipe {
namespace {

// What stands in the place of an angle that is not known.
constexpr std::int16_t kNoAngle = std::numeric_limits<std::int16_t>::min();

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
  void put(const note::NotedAngle& angle) {
    put(static_cast<std::uint16_t>(angle.tenths.value_or(kNoAngle)));
  }

 private:
  void putText(std::string_view text) {
    put(static_cast<std::uint8_t>(text.size()));
    m_out.insert(m_out.end(), text.begin(), text.end());
  }
  static_assert(NoteText::kMaxBytes <= 0xFF && Pin::kLength <= 0xFF, "a text's length is one byte");

  std::vector<std::uint8_t>& m_out;
};

class Reader : public layouts::FieldReader<Reader> {
 public:
  using FieldReader::take;

  explicit Reader(std::span<const std::uint8_t> bytes) : m_bytes(bytes) {}

  template <typename Member, typename T>
  void take(const layouts::Field<Member>& field, T& value) {
    if (!field.isLater || !m_bytes.empty()) take(value);
  }
  template <typename T>
  void takeNumber(T& number) {
    const auto bytes = front(sizeof(T));
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i) sum |= std::uint64_t{bytes[i]} << 8 * i;
    number = static_cast<T>(sum);
  }
  void take(Instant& time) {
    std::uint64_t ns = 0;
    take(ns);
    time.ns = static_cast<std::int64_t>(ns);
  }
  void take(Address& address) { take(address.value); }
  void take(NoteText& text) { text = takeText(); }
  void take(note::NotedAngle& angle) {
    std::uint16_t tenths = 0;
    take(tenths);
    if (const auto number = static_cast<std::int16_t>(tenths); number != kNoAngle) angle.tenths = number;
  }
  std::string takeText() {
    std::uint8_t length = 0;
    take(length);
    const auto bytes = front(length);
    return {bytes.begin(), bytes.end()};
  }

 private:
  std::span<const std::uint8_t> front(std::size_t size) {
    if (size > m_bytes.size()) m_isDamaged = true;
    if (m_isDamaged) return {};
    return std::exchange(m_bytes, m_bytes.subspan(size)).first(size);
  }

  std::span<const std::uint8_t> m_bytes;
};

constexpr std::size_t kLengthBytes = 2;

}  // namespace

void appendNote(std::vector<std::uint8_t>& out, const Note& note) {
  std::vector<std::uint8_t> bytes;
  NoteWriter writer(bytes);
  std::visit(
      [&]<typename T>(const T& value) {
        writer.put(layouts::kLayout<T>.number);
        writer.put(note.frame);
        writer.put(note.time);
        std::apply([&](const auto&... fields) { (writer.put(value.*fields.member), ...); },
                   layouts::kLayout<T>.fields);
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
  const auto value = layouts::takeValue(kind, reader);
  if (reader.isDamaged() || kind == 0) return Failure{NoteFault::Damaged};
  bytes = bytes.subspan(kLengthBytes + length);
  if (!value || reader.isUnknown())
    return std::variant<Note, UnknownNote>(UnknownNote{note.frame, note.time, kind});
  note.value = *value;
  return std::variant<Note, UnknownNote>(std::move(note));
}

}  // namespace deckpipe
