// SPDX-License-Identifier: GPL-3.0-or-later
// A monitor of the truck and the data pipe to it: what is typed and sent, what becomes of acks, what went out.
#pragma once

#include <gtest/gtest.h>

#include "control/pipe_event.h"
#include "service/pipe_service.h"
#include "support/pair.h"

namespace deckpipe::test {

struct PipeRig : ::testing::Test {
  using What = intent::PipeAction::What;
  static constexpr std::uint8_t kPipe = 0xFE;

  PipeRig() { pair.unlock(); }
  TruckPair pair;
  const DeviceKey monitor = TruckPair::monitor();

  Refusal type(std::string text) { return pair.intend(intent::PipeWrite{monitor, std::move(text)}); }
  Refusal send(std::string content) {
    return pair.intend(
        intent::PipeFile{monitor, "menu.txt", std::make_shared<const std::string>(std::move(content))});
  }
  Refusal act(What what, bool forTheRest = false) {
    return pair.intend(intent::PipeAction{monitor, what, forTheRest});
  }
  PipeStatus status() { return pair.console().pipe(pair.now(), monitor); }
  std::uint8_t address() { return pair.addressOf(monitor).value; }

  // The characters that we sent to the monitor, packets as they went.
  std::vector<std::string> packets(Instant from = kNotYet) {
    std::vector<std::string> out;
    for (const Pair::Seen& seen : pair.sent(kPipe, &pair.console(), from)) {
      if (seen.frame.length < 2) continue;
      out.emplace_back(seen.frame.data.begin() + 1, seen.frame.data.begin() + seen.frame.length);
    }
    return out;
  }
  std::string sentText(Instant from = kNotYet) {
    std::string all;
    for (const std::string& packet : packets(from)) all += packet;
    return all;
  }
  std::size_t acksSent() {
    return static_cast<std::size_t>(std::ranges::count_if(
        pair.sent(kPipe, &pair.console()), [](const Pair::Seen& seen) { return seen.frame.length == 1; }));
  }
  std::vector<PipeEvent> events() {
    std::vector<PipeEvent> out;
    for (const Note& note : pair.console().notes) {
      if (const auto* pipe = std::get_if<note::Pipe>(&note.value)) out.push_back(pipe->event);
    }
    return out;
  }
  static bool isAck(const Frame& f) { return f.length == 1 && f.data[0] == kPipe; }
  static bool isOfDevice(const Frame& f) { return J1939Id::of(f.identifier()).source != Address{0xF9}; }
  // Acks of the device, counted from 0 on, of which `fate` tells what becomes.
  void acks(std::function<Pair::Fate(int)> fate) {
    pair.wire = [fate, n = 0](const Frame& f) mutable {
      return isAck(f) && isOfDevice(f) ? fate(n++) : Pair::Fate{};
    };
  }
  Frame fromDevice(std::string_view data, std::uint8_t source) {
    Frame f = frame("18EF0000", data);
    f.id = J1939Id{6, pgn::kProprietaryA, Address{source}, Address{0xF9}}.frameId();
    return f;
  }
};

}  // namespace deckpipe::test
