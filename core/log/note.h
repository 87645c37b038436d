// SPDX-License-Identifier: GPL-3.0-or-later
// Notes: facts of a log that no frame carries. Each kind is a small struct; Note puts one at its place in the
// log. The window and the tool make sentences of them, State and the indexes take from them what they need,
// note_codec.h writes and reads them as bytes, note_text.h as text. To add a kind: the struct, its place in
// NoteValue, its layout and word in note_layout.h; the compiler names the other places.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "base/event_kind.h"
#include "base/ids.h"
#include "base/link_fault.h"
#include "base/time.h"
#include "control/motion.h"
#include "control/pipe_event.h"
#include "control/request.h"

namespace deckpipe {

// A person's or an adapter's words, in UTF-8. Longer text is cut at a whole character.
class NoteText {
 public:
  static constexpr std::size_t kMaxBytes = 200;

  NoteText() = default;
  NoteText(std::string text);
  NoteText(const char* text) : NoteText(std::string(text)) {}

  const std::string& str() const { return m_text; }
  bool isEmpty() const { return m_text.empty(); }
  friend bool operator==(const NoteText&, const NoteText&) = default;

 private:
  std::string m_text;
};

namespace note {

// A person's own words at a place of the log.
struct Mark {
  NoteText text;
  friend bool operator==(const Mark&, const Mark&) = default;
};
struct LinkUp {
  Channel channel;
  NoteText adapter{};         // plugin, interface and rate in words; empty where that was not written down
  std::uint32_t bitRate = 0;  // bit/s, of the driver or as it was asked for and set; 0: not known
  friend bool operator==(const LinkUp&, const LinkUp&) = default;
};
struct LinkDown {
  Channel channel;
  LinkFault fault = LinkFault::None;  // None: closed by us
  NoteText words{};                   // the adapter's own; may be empty
  friend bool operator==(const LinkDown&, const LinkDown&) = default;
};
// So many frames were lost before this place.
struct Dropped {
  Channel channel;
  std::uint64_t count = 0;
  friend bool operator==(const Dropped&, const Dropped&) = default;
};
// The transmit lock was set.
struct Locked {
  Channel channel;
  friend bool operator==(const Locked&, const Locked&) = default;
};
// … and released.
struct Unlocked {
  Channel channel;
  friend bool operator==(const Unlocked&, const Unlocked&) = default;
};
// A person said that a Copley drive is at this address, or that none is there after all.
struct DriveSaid {
  Channel channel;
  Address address;
  bool isDrive = true;
  friend bool operator==(const DriveSaid&, const DriveSaid&) = default;
};
// The console's own address on the bus changed. The address is ours from here on; null = none.
struct OwnAddress {
  // Numbers stand in files: never renumber one, never use one again.
  enum class How : std::uint8_t {
    Claimed = 1,
    Lost = 2,         // to a numerically lower NAME
    CannotClaim = 3,  // none is free
    SameName = 4,     // another node has our NAME
    Locked = 5,       // given up by the transmit lock
    LinkLost = 6,     // given up, as the link went
    InUse = 7,        // left, as another node sends from it
    Disputed = 8,     // claimed again, as another node sends from it
  };
  Channel channel;
  Address address;
  How how = How::Claimed;
  friend bool operator==(const OwnAddress&, const OwnAddress&) = default;
};
// A device was asked something; of a repeated poll only its first end and changes of it are noted.
struct Asked {
  Channel channel;
  Address address;
  Pin pin;  // null where the device has none
  Request request = Request::Fault;
  friend bool operator==(const Asked&, const Asked&) = default;
};
struct RequestEnded {
  Channel channel;
  Address address;
  Pin pin;  // null where the device has none
  Request request = Request::Fault;
  RequestEnd end = RequestEnd::None;
  friend bool operator==(const RequestEnded&, const RequestEnded&) = default;
};
// A command was handed over and is not on the bus yet; it may still go out.
struct RequestWaits {
  Channel channel;
  Address address;
  Pin pin;  // null where the device has none
  Request request = Request::Fault;
  friend bool operator==(const RequestWaits&, const RequestWaits&) = default;
};
// An angle in 0.1 degree, right and up positive; nothing where none held.
struct NotedAngle {
  std::optional<std::int16_t> tenths;
  friend bool operator==(const NotedAngle&, const NotedAngle&) = default;
};
// Where a device stood by its own last report when a command was handed over that changes it. Left out where no angle
// held.
struct AnglesBefore {
  Channel channel;
  Address address;
  Pin pin;  // null where the device has none
  Request request = Request::ZeroAxes;
  NotedAngle rotation, elevation;
  friend bool operator==(const AnglesBefore&, const AnglesBefore&) = default;
};
// At a lock, a close or the loss of an address so many frames of ours were not on the bus yet.
struct StillWaits {
  Channel channel;
  std::uint64_t count = 0;
  friend bool operator==(const StillWaits&, const StillWaits&) = default;
};
// So many frames came before this place, and after the note of this kind before, that the log cannot hold; of the kinds
// that are no frames (countsFrames()), so many were in the file that the log was saved from.
struct LeftOut {
  // Numbers stand in files: never renumber one, never use one again.
  enum class Why : std::uint8_t {
    CanFd = 1,
    NotClassic = 2,  // what the adapter handed over is no frame of classic CAN
    CanXl = 3,
    Unreadable = 4,    // lines of which nobody knows what they were
    RecorderLost = 5,  // places where the recorder says that it lost frames, and not how many
    NotWhole = 6,      // places of the file that the log was saved from; any of them may lie in a part of it
    Damaged = 7,       // frames that stood here in a recording, which is damaged; of any channel
  };
  static constexpr bool countsFrames(Why why) { return why < Why::Unreadable || why == Why::Damaged; }
  Channel channel;
  Why why = Why::CanFd;
  std::uint64_t count = 0;
  friend bool operator==(const LeftOut&, const LeftOut&) = default;
};
// What the person who saved the log calls a device.
struct Label {
  Pin pin;
  NoteText text;
  friend bool operator==(const Label&, const Label&) = default;
};
// So many frames from here on were not received at this place: saving a part of a log put them there, since
// they tell who held which address then.
struct Added {
  std::uint64_t count = 0;
  friend bool operator==(const Added&, const Added&) = default;
};
// The log was saved through this filter, as a person wrote it: frames that did not pass it are missing, so that nothing
// which rests on a silence can be told.
struct Filtered {
  NoteText text;
  friend bool operator==(const Filtered&, const Filtered&) = default;
};
// The log ran until this time, also where nothing came at its end. It is no event: the store of notes keeps the latest
// time alone (NoteStore::ranUntil()).
struct RanUntil {
  friend bool operator==(const RanUntil&, const RanUntil&) = default;
};
// Something happened to the data pipe of a device.
struct Pipe {
  Channel channel;
  Address address;
  Pin pin;  // null where the device has none
  PipeEvent event = PipeEvent::FileBegan;
  NoteText file;  // its name, where the event is a file's
  friend bool operator==(const Pipe&, const Pipe&) = default;
};

// The console's joystick was armed; one for each monitor that it was said to move.
struct MotionArmed {
  Channel channel;
  Address address;  // the joystick's
  Pin pin;
  std::uint16_t limit = 0;  // of the speed, 0.1 %
  bool isProven = false;    // an echo says that a frame was on the bus
  NoteText platform{};      // what the hand is on
  friend bool operator==(const MotionArmed&, const MotionArmed&) = default;
};
// It was held, or armed, and is not any more.
struct MotionEnded {
  Channel channel;
  Address address;  // the joystick's
  MotionCause cause = MotionCause::None;
  bool isDisarmed = false;
  std::uint32_t messages = 0;  // of the last hold, on the bus
  std::uint32_t period = 0;    // of these, the mean, in µs
  std::uint32_t worstGap = 0;  // since it was armed, in µs
  friend bool operator==(const MotionEnded&, const MotionEnded&) = default;
};
// A motion frame of before has just gone out.
struct MotionLate {
  Channel channel;
  Address address;  // the joystick's
  friend bool operator==(const MotionLate&, const MotionLate&) = default;
};

}  // namespace note

template <>
inline constexpr note::OwnAddress::How kLastOf<note::OwnAddress::How> = note::OwnAddress::How::Disputed;
template <>
inline constexpr note::LeftOut::Why kLastOf<note::LeftOut::Why> = note::LeftOut::Why::Damaged;

using NoteValue =
    std::variant<note::Mark, note::LinkUp, note::LinkDown, note::Dropped, note::Locked, note::Unlocked,
                 note::DriveSaid, note::OwnAddress, note::Asked, note::RequestEnded, note::RequestWaits,
                 note::StillWaits, note::Pipe, note::LeftOut, note::Label, note::Added, note::Filtered,
                 note::AnglesBefore, note::RanUntil, note::MotionArmed, note::MotionEnded, note::MotionLate>;

struct Note {
  std::uint64_t frame = 0;  // stands before this frame; the store's count where it is the last thing so far
  Instant time{};
  NoteValue value{};

  friend bool operator==(const Note&, const Note&) = default;
};

// The word for a kind in machine-readable output; never changes once shipped.
std::string_view noteKey(const NoteValue& value);

// Frames that a note says are not in the log although they came.
inline std::uint64_t framesMissed(const NoteValue& value) {
  if (const auto* dropped = std::get_if<note::Dropped>(&value)) return dropped->count;
  const auto* leftOut = std::get_if<note::LeftOut>(&value);
  return leftOut != nullptr && note::LeftOut::countsFrames(leftOut->why) ? leftOut->count : 0;
}

// Whether it tells of something that happened. Added frames are marked one by one where they stand.
inline bool isEvent(const NoteValue& value) {
  return !std::holds_alternative<note::Added>(value) && !std::holds_alternative<note::RanUntil>(value);
}

// How much a note wants attention.
Severity noteWeight(const NoteValue& value);

// The channel that a note speaks of; nothing if it speaks of the whole log.
inline std::optional<Channel> channelOf(const NoteValue& value) {
  return std::visit(
      [](const auto& n) -> std::optional<Channel> {
        if constexpr (requires { n.channel; }) {
          return n.channel;
        } else {
          return {};
        }
      },
      value);
}

inline void setChannel(NoteValue& value, Channel channel) {
  std::visit(
      [channel](auto& n) {
        if constexpr (requires { n.channel; }) n.channel = channel;
      },
      value);
}

}  // namespace deckpipe
