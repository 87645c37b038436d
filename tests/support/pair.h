// SPDX-License-Identifier: GPL-3.0-or-later
// The console's services and the simulator back to back on one simulated bus, time jumping from deadline to
// deadline. The wire in between may lose, delay and double frames, by a function that a test sets. What each
// side sends the other hears after kFlight; the console's own frames come back to it as echoes. Its adapter
// may refuse frames, keep them waiting, and lose or delay echoes, by functions of the console.
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "protocol/classify.h"
#include "service/services.h"
#include "simulator/standard_simulator.h"
#include "support/frames.h"

namespace deckpipe::test {

// What becomes of a frame on its way.
struct Fate {
  int copies = 1;
  Duration delay{0};
};

// One console: its State fed with all that is on the bus, its notes, its adapter.
struct Console {
  explicit Console(ServiceSettings settings = {}) : echoes(settings.echoes), services(settings) {}

  // Whether the adapter takes a frame.
  std::function<WriteResult(const Frame&)> take = [](const Frame&) { return WriteResult::Accepted; };
  // How long a frame waits in the adapter before it is on the bus; nothing: until the link goes.
  std::function<std::optional<Duration>(const Frame&)> leaves = [](const Frame&) { return Duration{0}; };
  // Of the echo, once the frame is on the bus.
  std::function<Fate(const Frame&)> echo = [](const Frame&) { return Fate{}; };
  bool echoes;

  State state;
  Services services;
  std::vector<Note> notes;
  std::uint64_t serial = 0;
  Instant frozenUntil = kNotYet;

  ServiceStatus status(Instant now) { return services.status(now, state); }
  RequestStatus request(Instant now, const DeviceKey& key, Request request) {
    const ServiceStatus all = status(now);
    const DeviceServices* device = all.find(key);
    return device != nullptr ? device->of(request) : RequestStatus{};
  }
  PipeStatus pipe(Instant now, const DeviceKey& key) {
    const ServiceStatus all = status(now);
    const DeviceServices* device = all.find(key);
    return device != nullptr && device->pipe ? *device->pipe : PipeStatus{};
  }
};

class Pair {
 public:
  static constexpr Duration kFlight = 700us;

  using Fate = test::Fate;
  struct Seen {
    Instant time;
    Frame frame;
    const Console* sender;  // null: the simulator, or a frame of the test's own
    J1939Id id() const { return J1939Id::of(frame.identifier()); }
  };

  simulator::Simulator simulator;
  // What happens to a frame on its way to whoever is not its sender.
  std::function<Fate(const Frame&)> wire = [](const Frame&) { return Fate{}; };
  std::vector<Seen> log;      // as they went onto the bus
  std::vector<Seen> written;  // as consoles handed them to their adapters, refused ones too

  Console& console() { return *m_consoles.front(); }
  Console& addConsole(const ServiceSettings& settings = {}) {
    Console& console = *m_consoles.emplace_back(std::make_unique<Console>(settings));
    console.services.linkChanged(m_now, console.state, true);
    return console;
  }
  Instant now() const { return m_now; }

  template <typename Intent>
  Refusal intend(Console& console, Intent intent) {
    const Refusal refusal =
        console.services.apply(m_now, console.state, {std::move(intent), m_now, ++console.serial});
    pump();
    return refusal;
  }
  template <typename Intent>
  Refusal intend(Intent intent) {
    return intend(console(), std::move(intent));
  }
  // Unlocks and waits until the address is held.
  void unlock() {
    intend(intent::Unlock{});
    run(1s);
  }
  // From outside, to everyone.
  void inject(const Frame& frame) {
    post(m_now, frame, nullptr, true);
    pump();
  }
  // Its thread stands still: frames wait for it, and then come with the times at which they came.
  void freeze(Console& console, Duration d) { console.frozenUntil = m_now + d; }
  // The console's receive buffer overflowed.
  void loseEchoes(Console& console) {
    console.services.echoesLost(m_now, console.state);
    pump();
  }
  // What waits in the adapter goes with the link.
  void setLink(Console& console, bool isUp) {
    if (!isUp) {
      std::erase_if(m_waiting, [&](const Waiting& waiting) { return waiting.of == &console; });
      std::erase_if(m_inFlight, [&](const InFlight& inFlight) { return inFlight.to == &console; });
    }
    console.services.linkChanged(m_now, console.state, isUp);
    pump();
  }

  void run(Duration d) { runTo(m_now + d); }
  void runTo(Instant end) {
    for (Instant next = nextTime(); next <= end; next = nextTime()) {
      m_now = std::max(m_now, next);
      step();
    }
    m_now = end;
    step();
  }
  // Until so, or the patience ends; says whether it is so.
  template <typename Condition>
  bool runUntil(Condition condition, Duration patience) {
    const Instant end = m_now + patience;
    while (!condition()) {
      const Instant next = nextTime();
      if (next > end) return false;
      m_now = std::max(m_now, next);
      step();
    }
    return true;
  }

  // Sent by anyone, of this type in EF00.
  std::vector<Seen> sent(std::uint8_t type, const Console* sender, Instant from = kNotYet) const {
    std::vector<Seen> out;
    for (const Seen& seen : log) {
      if (seen.time >= from && seen.sender == sender && seen.id().pgn == pgn::kProprietaryA &&
          seen.frame.length > 0 && seen.frame.data[0] == type)
        out.push_back(seen);
    }
    return out;
  }
  std::vector<Seen> sentBy(const Console* sender, Instant from = kNotYet) const {
    std::vector<Seen> out;
    for (const Seen& seen : log) {
      if (seen.time >= from && seen.sender == sender) out.push_back(seen);
    }
    return out;
  }

 private:
  struct InFlight {
    Instant due;
    std::uint64_t order;
    Frame frame;
    Console* to;  // null: the simulator
  };
  struct Waiting {
    Instant due;
    Frame frame;
    Console* of;
  };

  void post(Instant at, const Frame& frame, Console* sender, bool toSimulator) {
    log.push_back({at, frame, sender});
    const auto fly = [&](Console* to, const Frame& f, const Fate& fate) {
      for (int i = 0; i < fate.copies; ++i) {
        m_inFlight.push_back({at + kFlight + fate.delay + i * kFlight, m_order++, f, to});
      }
    };
    const Fate fate = wire(frame);
    for (auto& console : m_consoles) {
      if (console.get() == sender) {
        Frame echo = frame;
        echo.flags |= Frame::kSent;
        if (console->echoes) echo.flags |= Frame::kConfirmed;
        fly(console.get(), echo, console->echo(frame));
      } else {
        fly(console.get(), frame, fate);
      }
    }
    if (toSimulator) fly(nullptr, frame, fate);
  }

  Instant nextTime() const {
    Instant next = simulator.nextTime();
    for (const Waiting& waiting : m_waiting) next = std::min(next, waiting.due);
    for (const InFlight& inFlight : m_inFlight) next = std::min(next, timeFor(inFlight.to, inFlight.due));
    for (const auto& console : m_consoles)
      next = std::min(next, timeFor(console.get(), console->services.nextTime()));
    return next;
  }

  static Instant timeFor(const Console* console, Instant time) {
    return console != nullptr ? std::max(time, console->frozenUntil) : time;
  }

  // Frames before deadlines, as the contract of the services wants it.
  void step() {
    simulator.timeCame(m_now);
    pump();
    for (const Waiting& waiting : std::exchange(m_waiting, {})) {
      if (waiting.due <= m_now) {
        post(m_now, waiting.frame, waiting.of, true);
      } else {
        m_waiting.push_back(waiting);
      }
    }
    std::vector<InFlight> due;
    std::erase_if(m_inFlight, [&](const InFlight& inFlight) {
      if (timeFor(inFlight.to, inFlight.due) > m_now) return false;
      due.push_back(inFlight);
      return true;
    });
    std::ranges::sort(due, {}, [](const InFlight& f) { return std::pair(f.due.ns, f.order); });
    for (const InFlight& inFlight : due) {
      if (inFlight.to == nullptr) {
        simulator.received(m_now, inFlight.frame);
      } else {
        const Instant at = std::max(inFlight.due, inFlight.to->state.cursor().time);
        inFlight.to->state.apply(inFlight.frame, at);
        inFlight.to->services.received(at, inFlight.to->state, inFlight.frame);
      }
      pump();
    }
    for (auto& console : m_consoles) {
      if (console->frozenUntil > m_now) continue;
      console->state.timeCame(m_now);
      console->services.timeCame(m_now, console->state);
    }
    pump();
  }

  void write(Console& console, const OutFrame& out) {
    written.push_back({m_now, out.frame, &console});
    const WriteResult result = console.take(out.frame);
    if (result == WriteResult::Accepted) {
      const auto wait = console.leaves(out.frame);
      if (wait == Duration{0}) post(m_now, out.frame, &console, true);
      if (wait && *wait > 0ns) m_waiting.push_back({m_now + *wait, out.frame, &console});
    }
    console.services.wrote(m_now, console.state, out, result);
  }

  // What everyone wants sent now goes onto the bus.
  void pump() {
    m_due.clear();
    simulator.takeFrames(m_due);
    for (const simulator::DueFrame& due : m_due) post(m_now, due.frame, nullptr, false);
    for (auto& console : m_consoles) {
      std::vector<OutFrame> frames;
      console->services.takeFrames(frames);
      for (const OutFrame& out : frames) write(*console, out);
      std::vector<Note> notes;
      console->services.takeNotes(notes);
      for (Note& note : notes) {
        note.time = m_now;
        console->state.apply(note);
        console->notes.push_back(note);
      }
    }
  }

  Instant m_now{};
  std::vector<std::unique_ptr<Console>> m_consoles;
  std::vector<InFlight> m_inFlight;
  std::vector<Waiting> m_waiting;
  std::uint64_t m_order = 0;
  std::vector<simulator::DueFrame> m_due;
};

// The standard truck, up for two seconds, and one console that has listened.
class TruckPair : public Pair {
 public:
  static constexpr std::string_view kMonitor = "1032AE100801035", kRiser = "1033AE100802117";

  explicit TruckPair(std::uint64_t seed = 1) {
    simulator::StandardSimulator truck = simulator::standardSimulator(seed);
    simulator = std::move(truck.simulator);
    addConsole();
    simulator.powerOn(now());
    run(4s);
  }
  static DeviceKey monitor() { return DeviceKey::of(*Pin::parse(kMonitor)); }
  static DeviceKey riser() { return DeviceKey::of(*Pin::parse(kRiser)); }
  ClaimStatus claim() { return console().status(now()).claim; }
  Address addressOf(const DeviceKey& key) {
    const Device* device = console().state.devices().byPin(key.pin);
    return device != nullptr ? device->address : kNullAddress;
  }
};

}  // namespace deckpipe::test
