// SPDX-License-Identifier: GPL-3.0-or-later
// What went through the data pipe of one device up to the cursor: packets with their direction and the ack of
// each. Read from the log, so live and of a file alike. The terminal appends what is new on every tick and
// saves it as text; another device or an earlier cursor starts anew.
#pragma once

#include <QString>
#include <optional>
#include <string>
#include <vector>

#include "state/log_view.h"

namespace deckpipe {

struct PipePacket {
  std::uint64_t frame = 0;
  Instant time;
  bool isFromDevice = false;
  std::string bytes;
  std::optional<Instant> acknowledged;  // by the other end
  Address sender;
  bool isOurs = false;  // sent by this console, as its log knows; no log of another program does
};

class PipeTranscript {
 public:
  // Says whether it started anew: what was shown before is not its begin any more.
  bool take(const LogView& view, const DeviceKey& device);

  const std::vector<PipePacket>& packets() const { return m_packets; }
  Instant begin() const { return m_begin; }
  // The device's last restart before the cursor, where something was said before it: what it was told by
  // then it does not know any more. kNotYet: none.
  Instant restarted() const {
    return !m_packets.empty() && m_packets.front().time < m_restarted ? m_restarted : kNotYet;
  }
  // … after which nothing was sent to it yet.
  Instant restartedSinceSent() const { return m_lastSent < m_restarted ? restarted() : kNotYet; }

  // Both directions, a line a packet or line of text, with times; for saving.
  QString text() const;
  // "time,direction,bytes,ack_ms" of every packet, the ack empty where none came.
  QString ledger() const;

 private:
  std::shared_ptr<const Exchanges::List> m_exchanges;
  DeviceKey m_device;
  std::size_t m_taken = 0;
  std::uint64_t m_cursor = 0;
  Instant m_begin;
  Instant m_restarted = kNotYet;
  Instant m_lastSent = kNotYet;  // to the device
  std::vector<PipePacket> m_packets;
  // The last packet of each direction that waits for its ack; [1] from the device.
  std::array<std::optional<std::size_t>, 2> m_open;
};

// Characters that are not printable ASCII as their bytes: "⟨1B⟩"; line ends stay.
QString pipeText(std::string_view bytes);
QString pipeHex(std::string_view bytes);
// A line of its own between what was said before and after.
QString pipeRestartText();

}  // namespace deckpipe
