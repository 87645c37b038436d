// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/candump_line.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <limits>
#include <optional>

namespace deckpipe {
namespace {

constexpr std::size_t kMaxInterfaceName = 63;

constexpr bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v'; }
constexpr bool isDigit(char c) { return c >= '0' && c <= '9'; }

// 16 where it is no hexadecimal digit.
constexpr unsigned hexValue(char c) {
  if (isDigit(c)) return static_cast<unsigned>(c - '0');
  if (c >= 'A' && c <= 'F') return static_cast<unsigned>(c - 'A' + 10);
  if (c >= 'a' && c <= 'f') return static_cast<unsigned>(c - 'a' + 10);
  return 16;
}

// What is left of a line, taken from the front.
class Rest {
 public:
  explicit Rest(std::string_view text) : m_text(text) {}

  void skipSpaces() {
    while (!m_text.empty() && isSpace(m_text.front())) m_text.remove_prefix(1);
  }
  std::string_view peek() {
    skipSpaces();
    return m_text.substr(
        0, static_cast<std::size_t>(std::find_if(m_text.begin(), m_text.end(), isSpace) - m_text.begin()));
  }
  std::string_view word() {
    const std::string_view w = peek();
    m_text.remove_prefix(w.size());
    return w;
  }
  std::string_view upTo(char c) {
    const std::string_view w = m_text.substr(0, m_text.find(c));
    m_text.remove_prefix(std::min(w.size() + 1, m_text.size()));
    return w;
  }
  bool starts(char c) const { return !m_text.empty() && m_text.front() == c; }
  bool empty() const { return m_text.empty(); }
  std::string_view all() const { return m_text; }

 private:
  std::string_view m_text;
};

std::optional<std::uint32_t> hexNumber(std::string_view digits) {
  if (digits.empty() || digits.size() > 8) return {};
  std::uint32_t number = 0;
  for (const char c : digits) {
    const unsigned v = hexValue(c);
    if (v > 15) return {};
    number = number << 4 | v;
  }
  return number;
}

// --- Time

// Digits, saturating far above any second that fits.
std::optional<std::int64_t> decimal(std::string_view digits) {
  if (digits.empty() || !std::all_of(digits.begin(), digits.end(), isDigit)) return {};
  std::int64_t number = 0;
  for (const char c : digits) number = std::min<std::int64_t>(number * 10 + (c - '0'), 1'000'000'000'000'000);
  return number;
}

// '.' and digits, or nothing. More than nine are what 32-bit boards print whose time has 64 bits: nobody can
// tell what they mean, so they are lost.
std::optional<std::int64_t> fraction(std::string_view text, bool& isLost) {
  if (text.empty()) return 0;
  text.remove_prefix(1);
  auto number = decimal(text);
  if (!number) return {};
  isLost = text.size() > 9;
  if (isLost) return 0;
  for (std::size_t i = text.size(); i < 9; ++i) *number *= 10;
  return number;
}

// "2023-11-14 22:13:20" in seconds since 1970.
std::optional<std::int64_t> dateSeconds(std::string_view text) {
  constexpr std::string_view form = "0000-00-00 00:00:00";
  if (text.size() != form.size()) return {};
  for (std::size_t i = 0; i < form.size(); ++i) {
    if (form[i] == '0' ? !isDigit(text[i]) : text[i] != form[i]) return {};
  }
  const auto number = [text](std::size_t at, std::size_t length) {
    return static_cast<int>(*decimal(text.substr(at, length)));
  };
  const std::chrono::year_month_day day{std::chrono::year(number(0, 4)),
                                        std::chrono::month(static_cast<unsigned>(number(5, 2))),
                                        std::chrono::day(static_cast<unsigned>(number(8, 2)))};
  if (!day.ok() || number(11, 2) > 23 || number(14, 2) > 59 || number(17, 2) > 60) return {};
  return std::chrono::sys_days(day).time_since_epoch().count() * std::int64_t{86'400} + number(11, 2) * 3600 +
         number(14, 2) * 60 + number(17, 2);
}

// The inside of "(…)" into the line; a reason where that is impossible.
std::optional<Skipped> readStamp(std::string_view text, TextLine& line) {
  const bool negative = !text.empty() && text.front() == '-';
  if (negative) text.remove_prefix(1);
  const std::size_t dot = std::min(text.find('.'), text.size());
  const std::string_view whole = text.substr(0, dot);
  const auto nanoseconds = fraction(text.substr(dot), line.isFractionLost);
  auto seconds = decimal(whole);
  if (!seconds && !negative) seconds = dateSeconds(whole);
  if (!seconds || !nanoseconds) return Skipped::Time;
  std::int64_t time = 0;
  if (__builtin_mul_overflow(*seconds, std::int64_t{1'000'000'000}, &time) ||
      __builtin_add_overflow(time, *nanoseconds, &time)) {
    return Skipped::TimeRange;
  }
  line.frame.stamp = negative ? -time : time;
  return {};
}

// --- Identifier and data

bool setIdentifier(Frame& frame, std::uint32_t id, bool wide) {
  if (!wide) {
    frame.id = id;
    return id <= 0x7FF;
  }
  const bool error = (id & kErrorBit) != 0;
  frame.id = error ? id : id | kExtendedBit;
  return id <= (kErrorBit | kIdMask);
}

TextLine skipped(Skipped reason) {
  TextLine line;
  line.kind = TextLine::Kind::Skipped;
  line.reason = reason;
  return line;
}

// Number of bytes of "0011.2233", or nothing; bytes beyond what `into` holds are only counted.
std::optional<std::size_t> readCompactBytes(std::string_view text, Payload* into) {
  std::size_t n = 0;
  for (std::size_t i = 0; i < text.size(); ++n) {
    if (text[i] == '.' && n > 0) ++i;
    if (i + 1 >= text.size() || hexValue(text[i]) > 15 || hexValue(text[i + 1]) > 15) return {};
    if (into && n < into->size()) {
      (*into)[n] = static_cast<std::uint8_t>(hexValue(text[i]) << 4 | hexValue(text[i + 1]));
    }
    i += 2;
  }
  return n;
}

// "_E" behind eight bytes, or behind the length of a remote frame: the DLC as it was on the wire.
void dropRawDlc(std::string_view& text) {
  if (text.size() >= 2 && text[text.size() - 2] == '_' && hexValue(text.back()) > 8 &&
      hexValue(text.back()) < 16) {
    text.remove_suffix(2);
  }
}

// 18EFFF80#011D940371000041 and what may stand behind it.
TextLine readLogForm(TextLine line, Rest rest) {
  Rest word(rest.word());
  const std::string_view digits = word.upTo('#');
  std::string_view data = word.all();
  if (data.find(':') != std::string_view::npos && hexNumber(digits)) return skipped(Skipped::CanXl);
  const auto id = hexNumber(digits);
  Frame& frame = line.frame;
  if (!id || (digits.size() != 3 && digits.size() != 8) || !setIdentifier(frame, *id, digits.size() == 8)) {
    return skipped(Skipped::Identifier);
  }
  if (!data.empty() && data.front() == '#') {
    if (data.size() < 2 || hexValue(data[1]) > 15) return skipped(Skipped::Data);
    data.remove_prefix(2);
    if (!data.empty() && data.front() == '.') data.remove_prefix(1);
    return skipped(readCompactBytes(data, nullptr) ? Skipped::CanFd : Skipped::Data);
  }
  const std::size_t sizeBefore = data.size();
  dropRawDlc(data);
  const bool rawDlc = data.size() != sizeBefore;
  if (!data.empty() && (data.front() == 'R' || data.front() == 'r')) {
    frame.id |= kRemoteBit;
    if (data.size() > 2) return skipped(Skipped::Data);
    const unsigned length = data.size() == 2 ? hexValue(data[1]) : 0;
    if (length > 8) return skipped(Skipped::Data);
    frame.length = static_cast<std::uint8_t>(length);
  } else {
    const auto length = readCompactBytes(data, &frame.data);
    if (!length) return skipped(Skipped::Data);
    if (*length > 8) return skipped(Skipped::DataTooLong);
    frame.length = static_cast<std::uint8_t>(*length);
  }
  if (rawDlc && frame.length != 8) return skipped(Skipped::Data);
  const std::string_view direction = rest.word();
  rest.skipSpaces();
  if (!rest.empty() || !(direction.empty() || direction == "R" || direction == "T")) {
    return skipped(Skipped::Layout);
  }
  if (direction == "T") frame.flags |= Frame::kSent;
  return line;
}

// One word of the screen form's data: 1D, or 00011101, or both kinds joined by '`' and then reversed.
bool readScreenBytes(std::string_view word, Frame& frame, std::size_t& n) {
  const std::size_t first = n;
  for (Rest rest(word); !rest.empty();) {
    const std::string_view part = rest.upTo('`');
    unsigned byte = 0;
    if (part.size() == 2) {
      const auto number = hexNumber(part);
      if (!number) return false;
      byte = *number;
    } else if (part.size() == 8 && part.find_first_not_of("01") == std::string_view::npos) {
      for (const char c : part) byte = byte << 1 | static_cast<unsigned>(c - '0');
    } else {
      return false;
    }
    if (n < frame.data.size()) frame.data[n] = static_cast<std::uint8_t>(byte);
    ++n;
  }
  if (n <= frame.data.size()) {
    std::reverse(frame.data.begin() + static_cast<std::ptrdiff_t>(first),
                 frame.data.begin() + static_cast<std::ptrdiff_t>(n));
  }
  return true;
}

// 18EFFF80   [8]  01 1D 94 03 71 00 00 41 and what may stand behind it; also <0x18efff80>.
TextLine readScreenForm(TextLine line, Rest rest) {
  std::string_view digits = rest.word();
  if (digits.size() > 4 && digits.substr(0, 3) == "<0x" && digits.back() == '>') {
    digits = digits.substr(3, digits.size() - 4);
  }
  const std::string_view length = rest.word();
  const bool plain = length.size() >= 3 && length.front() == '[' && length.back() == ']';
  const bool raw = length.size() == 3 && length.front() == '{' && length.back() == '}';
  if (!plain && !raw) return skipped(Skipped::Layout);
  const auto id = hexNumber(digits);
  Frame& frame = line.frame;
  if (!id || !setIdentifier(frame, *id, digits.size() > 3)) return skipped(Skipped::Identifier);
  const std::string_view number = length.substr(1, length.size() - 2);
  if (!decimal(number) && !(raw && hexValue(number.front()) < 16)) return skipped(Skipped::Layout);
  if (number.size() == 2) return skipped(Skipped::CanFd);
  if (number.size() == 4) return skipped(Skipped::CanXl);
  if (number.size() != 1 || (plain && number.front() > '8')) return skipped(Skipped::LengthMismatch);
  frame.length = static_cast<std::uint8_t>(std::min(hexValue(number.front()), 8u));

  std::size_t n = 0;
  for (std::string_view word = rest.word(); !word.empty(); word = rest.word()) {
    if (word.front() == '\'' || word.front() == '`') break;  // the same data as text
    if (word == "ERRORFRAME") {
      frame.id = (frame.id & ~kExtendedBit) | kErrorBit;
      break;
    }
    if (word == "remote" && rest.peek() == "request") {
      frame.id |= kRemoteBit;
      break;
    }
    if (!readScreenBytes(word, frame, n)) return skipped(Skipped::Data);
  }
  if (n > 8) return skipped(Skipped::DataTooLong);
  if (n != frame.length && !(frame.isRemote() && n == 0)) return skipped(Skipped::LengthMismatch);
  if (frame.isRemote()) frame.data = {};  // canutils 4 prints what lay in its buffer
  return line;
}

// --- Lines that are no frames

// What candump -e writes under an error frame: its classes, indented by a tab.
bool isErrorDetail(std::string_view line) {
  static constexpr auto classes = std::to_array<std::string_view>(
      {"tx-timeout", "lost-arbitration", "controller-problem", "protocol-violation", "transceiver-status",
       "no-acknowledgement-on-tx", "bus-off", "bus-error", "restarted-after-bus-off", "error-counter-tx-rx"});
  if (line.empty() || line.front() != '\t') return false;
  const std::string_view word = Rest(line).peek();
  return std::any_of(classes.begin(), classes.end(),
                     [word](auto c) { return word.substr(0, c.size()) == c; });
}

bool isControl(char c) { return (static_cast<unsigned char>(c) < 0x20 && !isSpace(c)) || c == 0x7F; }

std::string withoutColours(std::string_view line) {
  std::string plain;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '\x1B' && i + 1 < line.size() && line[i + 1] == '[') {
      std::size_t end = i + 2;
      while (end < line.size() && (isDigit(line[end]) || line[end] == ';')) ++end;
      if (end < line.size() && line[end] == 'm') {
        i = end;
        continue;
      }
    }
    plain += line[i];
  }
  return plain;
}

TextLine readPlainLine(std::string_view text) {
  TextLine line;
  Rest rest(text);
  rest.skipSpaces();
  if (rest.empty() || rest.starts('#') || isErrorDetail(text)) return line;
  if (text.substr(0, 10) == "DROPCOUNT:") return skipped(Skipped::RecorderDropped);
  if (rest.starts('(')) {
    rest.upTo('(');
    if (const auto reason = readStamp(rest.upTo(')'), line)) return skipped(*reason);
    rest.skipSpaces();
  }
  line.kind = TextLine::Kind::Frame;
  if (rest.peek().substr(0, 3) == "<0x") return readScreenForm(line, rest);

  line.interface = rest.word();
  Rest beyond = rest;
  const bool header = line.interface == "interface" && beyond.word() == "=";
  if (header) {
    line.interface = beyond.peek().substr(0, beyond.peek().find(','));
    line.kind = TextLine::Kind::Header;
  }
  const bool printable =
      std::all_of(line.interface.begin(), line.interface.end(), [](char c) { return c > ' ' && c <= '~'; });
  if (line.interface.empty() || line.interface.size() > kMaxInterfaceName || !printable) {
    return skipped(rest.peek().empty() ? Skipped::Layout : Skipped::Interface);
  }
  if (header) return line;

  if (const std::string_view direction = rest.peek(); direction == "TX" || direction == "RX") {
    if (direction == "TX") line.frame.flags |= Frame::kSent;
    rest.word();
    for (const char flag : {'B', 'E'}) {
      if (rest.peek() == "-" || rest.peek() == std::string_view(&flag, 1)) rest.word();
    }
  }
  return rest.peek().find('#') != std::string_view::npos ? readLogForm(line, rest)
                                                         : readScreenForm(line, rest);
}

}  // namespace

TextLine readCandumpLine(std::string_view text, std::string& scratch) {
  while (!text.empty() && isSpace(text.back())) text.remove_suffix(1);
  if (text.find('\x1B') != std::string_view::npos) {
    scratch = withoutColours(text);
    text = scratch;
  }
  TextLine line = readPlainLine(text);
  if (line.kind == TextLine::Kind::Skipped && isUnreadable(line.reason) &&
      std::any_of(text.begin(), text.end(), isControl)) {
    line.reason = Skipped::Binary;
  }
  return line;
}

}  // namespace deckpipe
