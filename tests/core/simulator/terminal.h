// SPDX-License-Identifier: GPL-3.0-or-later
// The console's end of a data pipe, as a test wants it: sends text as packets, each after the device's
// acknowledgement, acknowledges what comes, and keeps what it read.
#pragma once

#include <deque>

#include "rig.h"

namespace deckpipe::simulator::test {

class Terminal {
 public:
  Terminal(Rig& rig, const Device& device, unsigned address = 0xF9)
      : m_rig(rig), m_device(device), m_address{static_cast<std::uint8_t>(address)} {}

  bool acknowledges = true;
  std::string text;        // read so far
  unsigned acks = 0;       // of the device
  unsigned packets = 0;    // of the device
  unsigned sent = 0;       // by us
  bool isWaiting = false;  // for an acknowledgement

  void type(std::string_view characters) { m_toSend += characters; }
  bool isDone() const { return m_toSend.empty() && !isWaiting; }
  void packet(std::string_view characters) {
    std::string data = "FE";
    char hex[3];
    for (const char c : characters) {
      std::snprintf(hex, sizeof hex, "%02X", static_cast<unsigned>(static_cast<std::uint8_t>(c)));
      data += hex;
    }
    char id[9];
    std::snprintf(id, sizeof id, "18EF%02X%02X", static_cast<unsigned>(m_device.address().value),
                  static_cast<unsigned>(m_address.value));
    m_rig.send(id, data);
  }
  // Reads and writes for so long; both ends at once.
  void run(Duration d) {
    for (const Instant end = m_rig.now() + d; m_rig.now() < end; m_rig.run(1ms)) step();
    step();
  }
  // One line to it, and what came back.
  std::string request(std::string_view line, Duration d = 1s) {
    text.clear();
    type(line);
    run(d);
    return text;
  }
  void step() {
    while (m_read < m_rig.log.size()) {
      const Seen seen = m_rig.log[m_read++];
      if (seen.destination() != m_address || seen.source() != m_device.address() || seen.frame.length == 0 ||
          seen.frame.data[0] != 0xFE)
        continue;
      if (seen.frame.length == 1) {
        ++acks;
        isWaiting = false;
        continue;
      }
      ++packets;
      const auto bytes = seen.frame.bytes().subspan(1);
      text.append(bytes.begin(), bytes.end());
      if (acknowledges) packet({});
    }
    if (isWaiting || m_toSend.empty() || m_device.address() == kNullAddress) return;
    const std::string next = m_toSend.substr(0, 7);
    m_toSend.erase(0, next.size());
    isWaiting = true;
    ++sent;
    packet(next);
  }

 private:
  Rig& m_rig;
  const Device& m_device;
  Address m_address;
  std::string m_toSend;
  std::size_t m_read = 0;
};

}  // namespace deckpipe::simulator::test
