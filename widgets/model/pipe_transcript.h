// SPDX-License-Identifier: GPL-3.0-or-later
// What went through the data pipe of one device up to the cursor: packets with their direction and the ack of
// each. Read from the log, so live and of a file alike. The terminal appends what is new on every tick and
// saves it as text; another device or an earlier cursor starts anew.
#pragma once

#include <QString>
#include <QStringList>
#include <optional>
#include <span>
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
  // The device's restarts before the cursor, in order, but for those before the first packet: what the device
  // was told by then it does not know any more.
  std::span<const Instant> restarts() const;
  // The last of them, if nothing was sent to the device since. kNotYet: none.
  Instant restartedSinceSent() const;

  // Both directions, a line a packet or line of text, with times; for saving.
  QString text() const;
  // "time_s,direction,bytes,ack_ms,repair" of every packet: the ack is empty where none came, the repair says
  // what this console's user did about a missing ack: "skipped", "resent" of the packet that was sent again,
  // or both.
  QString ledger() const;

 private:
  void findRestarts(const LogView& view);
  void addRestart(Instant time);
  bool isOfDevice(Channel channel, Address address, const Pin& pin) const;
  // What was done about missing acks, by packet.
  std::vector<QStringList> repairs() const;

  std::shared_ptr<const LogDocument> m_document;
  std::shared_ptr<const Exchanges::List> m_exchanges;
  DeviceKey m_device;
  std::size_t m_taken = 0;
  std::uint64_t m_cursor = 0;
  Instant m_begin;
  unsigned m_generation = 0;  // of the log's events
  std::size_t m_eventsSeen = 0;
  std::vector<Instant> m_restarts;  // all that are known, in order
  std::size_t m_restartsShown = 0;  // of these before the cursor
  Instant m_lastSent = kNotYet;     // to the device
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
