// SPDX-License-Identifier: GPL-3.0-or-later
// Arbitrary frames, intents, links that come and go and jumps of time into the services, whose own frames come
// back as echoes, get lost or are refused. Whatever happens: no crash, nothing is sent while locked or
// without a link, never two packets are in flight to one device, and in the end every ask has come to its
// end.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <memory>
#include <span>

#include "service/pipe_service.h"
#include "service/services.h"

namespace {

using namespace deckpipe;

void demand(bool condition) {
  if (!condition) std::abort();
}

class Console {
 public:
  Instant now;

  void intend(Intent intent) {
    m_services.apply(now, m_state, {std::move(intent), now, 0});
    take();
  }
  void setLink(bool isUp) {
    m_services.linkChanged(now, m_state, isUp);
    take();
  }
  void hear(const Frame& frame) {
    m_state.apply(frame, now);
    m_services.received(now, m_state, frame);
    const J1939Id id = J1939Id::of(frame.identifier());
    // At the latest now it may be taken for an ack.
    if (frame.isExtended() && id.pgn == pgn::kProprietaryA && frame.length == 1 && frame.data[0] == 0xFE)
      m_inFlight.erase(deviceAt(id.source));
    take();
  }
  // To every deadline on the way, so many at most: repeated polls have no last one.
  void passTime(Duration d, int deadlines = 2'000) {
    const Instant end = now + d;
    for (Instant next = m_services.nextTime(); next <= end && deadlines-- > 0; next = m_services.nextTime()) {
      now = std::max(now, next);
      m_services.timeCame(now, m_state);
      take();
    }
    now = end;
    m_state.timeCame(now);
    m_services.timeCame(now, m_state);
    take();
  }
  ServiceStatus status() { return m_services.status(now, m_state); }
  bool losesFrames = false;
  bool refusesFrames = false;

 private:
  DeviceKey deviceAt(Address address) const {
    const Device* device = m_state.devices().byAddress(Channel{}, address);
    return device != nullptr && !device->pin.isNull() ? DeviceKey::of(device->pin)
                                                      : DeviceKey::at(Channel{}, address);
  }
  void take() {
    std::vector<OutFrame> frames;
    m_services.takeFrames(frames);
    std::vector<Note> notes;
    m_services.takeNotes(notes);
    for (Note& note : notes) {
      note.time = now;
      m_state.apply(note);
    }
    const ServiceStatus after = status();
    for (const OutFrame& out : frames) {
      Frame frame = out.frame;
      m_services.wrote(now, m_state, out, refusesFrames ? WriteResult::QueueFull : WriteResult::Accepted);
      demand(!after.locked && after.linkUp);
      if (refusesFrames) continue;
      const J1939Id id = J1939Id::of(frame.identifier());
      if (id.pgn == pgn::kProprietaryA && frame.length > 1 && frame.data[0] == 0xFE) {
        const auto [flight, isFirst] = m_inFlight.try_emplace(deviceAt(id.destination), now);
        demand(isFirst || now - flight->second >= deckpipe::Pipe::kSettle);
        flight->second = now;
      }
      if (losesFrames) continue;
      frame.flags |= Frame::kSent | Frame::kConfirmed;
      m_state.apply(frame, now);
      m_services.received(now, m_state, frame);
    }
    if (!frames.empty()) take();
  }

  State m_state;
  Services m_services{ServiceSettings{}};
  std::map<DeviceKey, Instant> m_inFlight;
};

// What the bytes say, cut off where they end.
struct Input {
  std::span<const std::uint8_t> rest;
  std::uint8_t next() {
    if (rest.empty()) return 0;
    const std::uint8_t first = rest.front();
    rest = rest.subspan(1);
    return first;
  }
};

// Mostly who is there and the console itself, so that something comes of it.
Address addressFrom(Input& in) {
  constexpr std::uint8_t kUsual[] = {0x80, 0x81, 0xF9, 0xFA, 0xFF, 0xFE};
  const std::uint8_t byte = in.next();
  return {byte < 0xC0 ? kUsual[byte % std::size(kUsual)] : byte};
}

Frame frameFrom(Input& in) {
  constexpr std::uint32_t kPgns[] = {pgn::kProprietaryA, pgn::kAddressClaimed, pgn::kRequest, 0xFF00};
  Frame frame;
  const std::uint32_t pgn = kPgns[in.next() % std::size(kPgns)];
  const Address source = addressFrom(in), destination = addressFrom(in);
  frame.id = J1939Id{6, pgn, source, destination}.frameId();
  frame.length = in.next() % 9;
  for (unsigned i = 0; i < frame.length; ++i) frame.data[i] = in.next();
  return frame;
}

DeviceKey deviceFrom(Input& in) {
  const std::uint8_t byte = in.next();
  if (byte % 4 == 0) return DeviceKey::of(*Pin::make(1032, 'A', 'E', byte / 4u % 2));
  return byte % 4 == 1 ? DeviceKey{} : DeviceKey::at(Channel{}, addressFrom(in));
}

// A device that says who it is: without that little is taken.
void announce(Console& console, Input& in) {
  const std::uint8_t which = in.next();
  const Address source{static_cast<std::uint8_t>(0x80 + which % 2)};
  const auto serial = static_cast<std::uint8_t>(which / 2 % 2);
  Frame name{.id = J1939Id{6, pgn::kAddressClaimed, source, kGlobalAddress}.frameId(), .length = 8};
  name.data = {serial, 0, 0xC0, 0x28, 0, 0x42, 0, 0x90};
  if (which < 0xC0) console.hear(name);
  Frame pin{.id = J1939Id{6, pgn::kProprietaryA, source, kGlobalAddress}.frameId(), .length = 8};
  pin.data = {0xFF, 0x83, 0x15, 0x02, 0, 0, 0, serial};
  if (which % 8 < 6) console.hear(pin);
}

void wishFrom(Console& console, Input& in) {
  const DeviceKey device = deviceFrom(in);
  RequestSet requests;
  const unsigned bits = in.next();
  for (const Request request : kAllOf<Request>) {
    if ((bits >> static_cast<unsigned>(request) & 1u) != 0) requests.add(request);
  }
  switch (in.next() % 12) {
    case 0: return console.intend(intent::Lock{});
    case 1: return console.intend(intent::RequestNames{});
    case 2: return console.intend(intent::Cancel{device});
    case 3:
      return console.intend(
          intent::Repeat{device, requests, Duration(1s) * static_cast<std::int64_t>(in.next())});
    case 4:
    case 5: return console.intend(intent::SendRequests{device, requests});
    case 6: return console.intend(intent::PipeWrite{device, std::string(in.next(), 'x')});
    case 7:
      return console.intend(
          intent::PipeFile{device, "f", std::make_shared<const std::string>(in.next() * 4u, 'f')});
    case 8:
    case 9:
      return console.intend(intent::PipeAction{device, static_cast<intent::PipeAction::What>(in.next() % 6)});
    default: return console.intend(intent::Unlock{});
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto console = std::make_unique<Console>();  // its State is large
  Input in{{data, size}};
  console->setLink(true);
  console->intend(intent::Unlock{});
  console->passTime(2s);
  while (!in.rest.empty()) {
    switch (in.next() % 8) {
      case 0:
      case 1: console->hear(frameFrom(in)); break;
      case 2: console->passTime(Duration(1ms) * static_cast<std::int64_t>(in.next())); break;
      case 3: console->passTime(Duration(100ms) * static_cast<std::int64_t>(in.next())); break;
      case 4: announce(*console, in); break;
      case 5:
        if (const std::uint8_t byte = in.next(); byte % 8 == 0) {
          console->setLink(byte >= 128);
        } else {
          console->losesFrames = byte % 8 == 1;
          console->refusesFrames = byte % 8 == 2;
        }
        break;
      default: wishFrom(*console, in);
    }
  }
  console->intend(intent::Repeat{{}, kPolls, Duration{0}});
  console->passTime(600s, 200'000);
  console->setLink(false);  // a command that is not on the bus ends with its link
  for (const DeviceServices& device : console->status().devices) {
    for (const RequestStatus& request : device.requests)
      demand(request.progress == RequestStatus::Progress::Idle ||
             request.progress == RequestStatus::Progress::Ended);
  }
  return 0;
}
