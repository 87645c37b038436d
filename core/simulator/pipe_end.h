// SPDX-License-Identifier: GPL-3.0-or-later
// A device's end of the ASCII data pipe (CAN Messaging manual, message type FE): packets of up to 7
// characters and their acknowledgements, with a PipeShell behind them. Device passes it what came and the
// time, and puts its packets on the bus. Both directions run at once.
//
// 1. One packet of ours is on its way at a time; the next goes out after its acknowledgement. Without one for
//    1 s everything that waits is given up, and the shell says so with the next input.
// 2. Every packet that is taken is acknowledged. There is no sequence number, so one that comes twice is
//    taken twice.
// 3. One peer at a time: while a line, a file or an answer is under way others are neither heard nor
//    acknowledged, until the peer was silent for 10 s.
#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/ids.h"
#include "base/time.h"
#include "protocol/encode.h"
#include "simulator/misbehaviour.h"

namespace deckpipe::simulator {

// The shell at the far end of the ASCII data pipe: characters in, characters out. PipeEnd owns one and does
// the packets. The manual gives no command and no answer; those of kHelp are the simulator's own.
//
// 1. A line ends with CR, LF or CR LF. An empty line is not answered, everything else is.
// 2. After FILE n the next n bytes are the file, whatever they are; the answers before it still go out
//    meanwhile. A LF after the CR of that line is not the file's, unless READY was acknowledged before it.
// 3. What waits to go out is bounded. What did not fit or was given up is counted, and said with the next
//    input.
class PipeShell {
 public:
  static constexpr std::size_t kLongestLine = 80;
  static constexpr std::size_t kMaxWaiting = 4096;  // characters of answers
  static constexpr std::uint32_t kLargest = 1u << 24;
  static constexpr Duration kFileSilence = 10s;  // then a file is given up
  static constexpr std::string_view kHelp =
      "?, HELP          this list\r\n"
      "A?               who this is\r\n"
      "VER              versions\r\n"
      "STAT             what it is doing\r\n"
      "ECHO ON|OFF      echo of characters\r\n"
      "ECHO TEXT        the text again\r\n"
      "SEND N           N bytes and their CRC-32\r\n"
      "FILE N           take N bytes, say their CRC-32\r\n"
      "Ctrl+C           end SEND\r\n";

  // What it says of its device. Lines end with CR LF.
  class Facts {
   public:
    virtual ~Facts() = default;
    virtual std::string banner() const = 0;
    virtual std::string versions() const = 0;
    virtual std::string status() const = 0;
  };

  explicit PipeShell(const Facts& facts) : m_facts(facts) {}

  void received(Instant now, std::span<const std::uint8_t> characters);
  void timeCame(Instant now);
  Instant nextTime() const { return m_fileBy; }
  void clear();

  // The next characters to go out, none where nothing waits.
  std::string take(std::size_t most);
  // What was taken has arrived, or will never: then the rest is given up too.
  void delivered();
  void giveUp(std::size_t taken);

  // In the middle of a line, a file or an answer.
  bool isBusy() const { return !m_line.empty() || m_fileLeft > 0 || !m_out.empty(); }

 private:
  struct Piece {
    std::string text;
    std::uint32_t left = 0, total = 0;  // of SEND, before the text
    std::uint32_t crc = 0;
  };

  void say(std::string_view text);
  void typed(Instant now, std::uint8_t c);
  void lineEnded(Instant now);
  void obey(Instant now, std::string_view command, std::string_view argument);
  void startFile(Instant now, std::uint32_t bytes);
  void fileByte(std::uint8_t byte);
  static std::string summary(std::string_view what, std::uint32_t bytes, std::uint32_t crc);

  const Facts& m_facts;
  std::string m_line;
  bool m_lineTooLong = false;
  bool m_afterReturn = false;  // a LF now belongs to the CR before it
  bool m_echoes = false;
  std::deque<Piece> m_out;
  std::size_t m_waiting = 0;  // characters of all texts in m_out
  std::uint64_t m_lost = 0;
  std::uint32_t m_fileLeft = 0, m_fileSize = 0;
  std::uint32_t m_fileCrc = 0;
  Instant m_fileBy = kNever;
};

class PipeEnd {
 public:
  static constexpr std::size_t kPacket = 7;  // characters
  static constexpr Duration kAckTimeout = 1s, kPeerSilence = 10s;
  static constexpr Duration kThinking = 2ms;  // from a packet to its acknowledgement; ours

  struct Outgoing {
    Instant due;
    Address to;
    MessageId message;
    Encoded data;
  };

  explicit PipeEnd(const PipeShell::Facts& facts) : m_shell(facts) {}

  void misbehave(const PipeFaults& how);
  // No characters: an acknowledgement.
  void received(Instant now, Address from, std::span<const std::uint8_t> characters);
  void timeCame(Instant now);
  Instant nextTime() const { return std::min(m_ackBy, m_shell.nextTime()); }
  void takeOutgoing(std::vector<Outgoing>& out);
  void clear();

  // PipeFaults::vanishAfter has come true; true once.
  bool vanishes();
  // "PIPE IN 12 OUT 3": data packets since it started.
  std::string status() const;

 private:
  bool isTakenByAnother(Instant now, Address from) const;
  void acknowledge(Instant now);
  void send(Instant now);

  PipeShell m_shell;
  PipeFaults m_faults;
  unsigned m_in = 0, m_acks = 0, m_out = 0;  // since the misbehaviour was set, for Losses
  bool m_vanished = false;
  unsigned m_taken = 0, m_sent = 0;
  Address m_peer = kNullAddress;
  Instant m_heardAt = kNotYet;
  Instant m_ackBy = kNever;  // kNever: none is on its way
  std::size_t m_onItsWay = 0;
  std::vector<Outgoing> m_outgoing;
};

}  // namespace deckpipe::simulator
