// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/pipe_end.h"

#include <zlib.h>
#include <algorithm>
#include <charconv>
#include <cstdio>
#include <optional>
#include <utility>

#include "protocol/catalogue.h"
#include "simulator/address_claim.h"

namespace deckpipe::simulator {

void PipeEnd::misbehave(const PipeFaults& how) {
  if (how == m_faults) return;
  m_faults = how;
  m_in = m_acks = m_out = 0;
  m_vanished = false;
}

void PipeEnd::clear() {
  m_shell.clear();
  m_peer = kNullAddress;
  m_ackBy = kNever;
  m_taken = m_sent = 0;
  m_outgoing.clear();
}

bool PipeEnd::isTakenByAnother(Instant now, Address from) const {
  const bool busy = m_ackBy != kNever || m_shell.isBusy();
  return from != m_peer && m_peer != kNullAddress && busy && now - m_heardAt < kPeerSilence;
}

void PipeEnd::received(Instant now, Address from, std::span<const std::uint8_t> characters) {
  timeCame(now);
  if (characters.empty()) {
    if (from != m_peer) return;
    m_heardAt = now;
    if (m_ackBy == kNever) return;
    m_ackBy = kNever;
    m_shell.delivered();
    send(now);
    return;
  }
  if (isTakenByAnother(now, from) || m_faults.packetsUnheard.hits(++m_in)) return;
  if (from != m_peer) {
    m_shell.clear();
    m_ackBy = kNever;
    m_peer = from;
  }
  m_heardAt = now;
  ++m_taken;
  acknowledge(now);
  m_shell.received(now, characters);
  send(now);
}

void PipeEnd::acknowledge(Instant now) {
  if (m_faults.acksLost.hits(++m_acks)) return;
  const Outgoing ack{now + kThinking + m_faults.ackLate, m_peer, MessageId::PipeAck,
                     encoded(MessageId::PipeAck)};
  m_outgoing.insert(m_outgoing.end(), m_faults.ackTwice ? 2 : 1, ack);
}

void PipeEnd::timeCame(Instant now) {
  if (now >= m_ackBy) {
    m_ackBy = kNever;
    m_shell.giveUp(m_onItsWay);
  }
  m_shell.timeCame(now);
  send(now);
}

void PipeEnd::send(Instant now) {
  if (m_ackBy != kNever) return;
  const std::string text = m_shell.take(kPacket);
  if (text.empty()) return;
  m_onItsWay = text.size();
  m_ackBy = now + kAckTimeout;
  ++m_sent;
  if (m_faults.packetsLost.hits(++m_out)) return;
  Encoded data;
  data.length = static_cast<std::uint8_t>(1 + text.size());
  data.data[0] = typeOf(MessageId::PipeData);
  std::ranges::copy(text, data.data.begin() + 1);
  m_outgoing.push_back({now + kThinking, m_peer, MessageId::PipeData, data});
}

void PipeEnd::takeOutgoing(std::vector<Outgoing>& out) {
  out.insert(out.end(), m_outgoing.begin(), m_outgoing.end());
  m_outgoing.clear();
}

bool PipeEnd::vanishes() {
  if (m_vanished || m_faults.vanishAfter == 0 || m_in + m_out < m_faults.vanishAfter) return false;
  m_vanished = true;
  return true;
}

std::string PipeEnd::status() const {
  return "PIPE IN " + std::to_string(m_taken) + " OUT " + std::to_string(m_sent) + "\r\n";
}

namespace {

constexpr std::uint8_t kInterrupt = 0x03;  // Ctrl+C

// SEND's bytes: lines of 62 printable characters that shift by one a line, so that a lost packet shows.
char patternAt(std::uint32_t i) {
  const std::uint32_t column = i % 64;
  if (column >= 62) return column == 62 ? '\r' : '\n';
  return static_cast<char>('!' + (i / 64 + column) % 94);
}

std::string upper(std::string_view text) {
  std::string result(text);
  std::ranges::transform(result, result.begin(),
                         [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
  return result;
}

std::uint32_t crcAfter(std::uint32_t before, std::uint8_t byte) {
  return static_cast<std::uint32_t>(::crc32(before, &byte, 1));
}

std::optional<std::uint32_t> numberIn(std::string_view text) {
  std::uint32_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || number > PipeShell::kLargest) return {};
  return number;
}

}  // namespace

void PipeShell::clear() {
  m_line.clear();
  m_lineTooLong = m_afterReturn = m_echoes = false;
  m_out.clear();
  m_waiting = 0;
  m_lost = 0;
  m_fileLeft = 0;
  m_fileBy = kNever;
}

void PipeShell::received(Instant now, std::span<const std::uint8_t> characters) {
  if (m_lost > 0 && m_out.empty()) {
    const std::uint64_t lost = std::exchange(m_lost, 0);
    say("LOST " + std::to_string(lost) + " characters of the answers before\r\n");
  }
  if (m_fileLeft > 0) m_fileBy = now + kFileSilence;
  for (const std::uint8_t c : characters) {
    const bool afterReturn = std::exchange(m_afterReturn, false);
    if (afterReturn && c == '\n') continue;
    if (m_fileLeft > 0) {
      fileByte(c);
    } else {
      typed(now, c);
    }
  }
}

void PipeShell::typed(Instant now, std::uint8_t c) {
  if (c == kInterrupt) {
    std::erase_if(m_out, [](const Piece& piece) { return piece.left > 0; });
    m_waiting = 0;
    for (const Piece& piece : m_out) m_waiting += piece.text.size();
    m_line.clear();
    return;
  }
  if (c == '\r' || c == '\n') {
    m_afterReturn = c == '\r';
    if (m_echoes) say("\r\n");
    lineEnded(now);
    return;
  }
  const char character = static_cast<char>(c);
  if (m_echoes) say({&character, 1});
  if (m_line.size() < kLongestLine) {
    m_line += character;
  } else {
    m_lineTooLong = true;
  }
}

void PipeShell::lineEnded(Instant now) {
  const std::string line = std::exchange(m_line, {});
  if (std::exchange(m_lineTooLong, false)) {
    say("ERROR line too long\r\n");
    return;
  }
  const std::size_t begin = line.find_first_not_of(' ');
  if (begin == std::string::npos) return;
  const std::size_t end = std::min(line.find(' ', begin), line.size());
  const std::size_t rest = std::min(line.find_first_not_of(' ', end), line.size());
  obey(now, upper(line.substr(begin, end - begin)), std::string_view(line).substr(rest));
}

void PipeShell::obey(Instant now, std::string_view command, std::string_view argument) {
  const std::string word = upper(argument);
  if (command == "?" || command == "HELP") {
    say(kHelp);
  } else if (command == "A?") {
    say(m_facts.banner());
  } else if (command == "VER") {
    say(m_facts.versions());
  } else if (command == "STAT") {
    say(m_facts.status());
  } else if (command == "ECHO" && (word == "ON" || word == "OFF")) {
    m_echoes = word == "ON";
    say("OK\r\n");
  } else if (command == "ECHO") {
    say(std::string(argument) + "\r\n");
  } else if (command == "SEND" || command == "FILE") {
    const auto number = numberIn(argument);
    if (!number) {
      say("ERROR a number up to " + std::to_string(kLargest) + "\r\n");
    } else if (command == "FILE") {
      startFile(now, *number);
    } else {
      m_out.push_back({{}, *number, *number, 0});
      if (*number == 0) say(summary("SENT", 0, 0));
    }
  } else {
    say("ERROR unknown command, ? lists them\r\n");
  }
}

void PipeShell::startFile(Instant now, std::uint32_t bytes) {
  say("READY " + std::to_string(bytes) + "\r\n");
  m_fileLeft = m_fileSize = bytes;
  m_fileCrc = 0;
  m_fileBy = bytes > 0 ? now + kFileSilence : kNever;
  if (bytes == 0) say(summary("OK", 0, 0));
}

void PipeShell::fileByte(std::uint8_t byte) {
  m_fileCrc = crcAfter(m_fileCrc, byte);
  if (--m_fileLeft > 0) return;
  m_fileBy = kNever;
  say(summary("OK", m_fileSize, m_fileCrc));
}

std::string PipeShell::summary(std::string_view what, std::uint32_t bytes, std::uint32_t crc) {
  char hex[9];
  std::snprintf(hex, sizeof hex, "%08X", crc);
  return std::string(what) + ' ' + std::to_string(bytes) + " CRC32 " + hex + "\r\n";
}

void PipeShell::timeCame(Instant now) {
  if (now < m_fileBy) return;
  m_fileBy = kNever;
  const std::uint32_t left = std::exchange(m_fileLeft, 0);
  say("ERROR " + std::to_string(m_fileSize - left) + " of " + std::to_string(m_fileSize) + " bytes came\r\n");
}

void PipeShell::say(std::string_view text) {
  if (m_waiting + text.size() > kMaxWaiting) {
    m_lost += text.size();
    return;
  }
  if (m_out.empty() || m_out.back().left > 0) m_out.emplace_back();
  m_out.back().text += text;
  m_waiting += text.size();
}

std::string PipeShell::take(std::size_t most) {
  std::string result;
  while (!m_out.empty() && result.size() < most) {
    Piece& piece = m_out.front();
    while (piece.left > 0 && result.size() < most) {
      const char c = patternAt(piece.total - piece.left);
      piece.crc = crcAfter(piece.crc, static_cast<std::uint8_t>(c));
      result += c;
      if (--piece.left == 0) {
        piece.text = summary("SENT", piece.total, piece.crc);
        m_waiting += piece.text.size();
      }
    }
    const std::size_t count = std::min(most - result.size(), piece.text.size());
    result.append(piece.text, 0, count);
    piece.text.erase(0, count);
    m_waiting -= count;
    if (piece.left == 0 && piece.text.empty()) m_out.pop_front();
  }
  return result;
}

void PipeShell::delivered() {
  if (m_out.empty()) m_afterReturn = false;
}

void PipeShell::giveUp(std::size_t taken) {
  m_lost += taken;
  for (const Piece& piece : m_out) m_lost += piece.left + piece.text.size();
  m_out.clear();
  m_waiting = 0;
}

}  // namespace deckpipe::simulator
