// SPDX-License-Identifier: GPL-3.0-or-later
// Values and when they came: what a view shows with an age.
#pragma once

#include <optional>
#include <type_traits>

#include "base/time.h"
#include "bus/frame.h"

namespace deckpipe {

// How old something is that happened at `at`; nothing if it never did. Of a log without times every frame is at 0, and
// of nothing in it is known how old it is.
constexpr std::optional<Duration> ageAt(Instant at, Instant now) {
  if (at == kNotYet || now == Instant{}) return {};
  return now - at;
}

template <typename T>
struct Timed {
  T value{};
  Instant at = kNotYet;

  bool isKnown() const { return at != kNotYet; }
  void set(const T& newValue, Instant time) {
    value = newValue;
    at = time;
  }
  friend bool operator==(const Timed&, const Timed&) = default;
};

// The last message of a kind, kept as its bytes and decoded when somebody looks: most are replaced before
// anyone does.
class Report {
 public:
  Instant at = kNotYet;

  bool isKnown() const { return at != kNotYet; }
  Frame frame() const {
    Frame frame;
    frame.data = m_data;
    frame.length = m_length;
    return frame;
  }
  void set(const Frame& frame, Instant time) {
    m_data = frame.data;
    m_length = frame.length;
    at = time;
  }
  friend bool operator==(const Report&, const Report&) = default;

 private:
  Payload m_data{};
  std::uint8_t m_length = 0;
};

// The same where it is known what to read it as; `Of` is the typed struct's reader of a frame.
template <auto Of>
class Reported : public Report {
 public:
  using Value = std::invoke_result_t<decltype(Of), const Frame&>;

  Reported() = default;
  explicit Reported(const Report& report) : Report(report) {}
  Value value() const { return Of(frame()); }
};

}  // namespace deckpipe
