// SPDX-License-Identifier: GPL-3.0-or-later
#include "state/in_force.h"

#include <algorithm>
#include <bitset>
#include <map>
#include <optional>
#include <tuple>

#include "base/overload.h"
#include "bus/j1939.h"
#include "protocol/lists.h"
#include "state/role_notes.h"

namespace deckpipe {
namespace {

constexpr std::uint64_t kGlance = 65'536;  // frames between two looks at whether to go on

constexpr EnumArray<MessageId, bool> kIsIdentity = [] {
  EnumArray<MessageId, bool> is;
  for (const MessageId id : kIdentityMessages) is[id] = true;
  return is;
}();

struct Said {
  std::uint64_t frame = 0;
  // Whose address it was once that frame had come.
  Name holder{};
  Pin pin{};
};
using Key = std::tuple<std::uint8_t, std::uint8_t, MessageId>;  // channel, address

// What the clock of a channel shows when frame `at` comes.
std::int64_t stampAt(const FrameStore& frames, std::uint8_t channel, std::uint64_t at) {
  if (!frames[at].hasStamp()) return kNoStamp;
  if (!frames.hasTimes()) return frames[at].stamp;
  std::int64_t offset = 0;
  if (const auto* offsets = frames.offsets(channel)) {
    for (std::size_t i = 0; i < offsets->size() && (*offsets)[i].frame <= at; ++i)
      offset = (*offsets)[i].offset;
  }
  return saturatedMinus(frames.timeAt(at).ns, offset);
}

// What a note that holds until the next one is about: its group, channel and address.
using NoteSubject = std::tuple<int, Channel, Address>;
std::optional<NoteSubject> subjectOf(const NoteValue& value) {
  using About = std::optional<NoteSubject>;
  const auto of = [](int group, Channel channel, Address address = {}) {
    return About({group, channel, address});
  };
  return std::visit(Overload{[&](const note::LinkUp& n) { return of(0, n.channel); },
                             [&](const note::LinkDown& n) { return of(0, n.channel); },
                             [&](const note::Locked& n) { return of(1, n.channel); },
                             [&](const note::Unlocked& n) { return of(1, n.channel); },
                             [&](const note::OwnAddress& n) { return of(2, n.channel); },
                             [&](const note::DriveSaid& n) { return of(3, n.channel, n.address); },
                             [](const note::Mark&) { return About(); },
                             [](const note::Dropped&) { return About(); },
                             [](const note::Asked&) { return About(); },
                             [](const note::AnglesBefore&) { return About(); },
                             [](const note::RequestEnded&) { return About(); },
                             [](const note::RequestWaits&) { return About(); },
                             [](const note::StillWaits&) { return About(); },
                             [](const note::Pipe&) { return About(); },
                             [](const note::LeftOut&) { return About(); },
                             [](const note::Label&) { return About(); },
                             [](const note::Added&) { return About(); },
                             [](const note::Filtered&) { return About(); },
                             [](const note::RanUntil&) { return About(); },
                             [](const note::MotionArmed&) { return About(); },
                             [](const note::MotionEnded&) { return About(); },
                             [](const note::MotionLate&) { return About(); }},
                    value);
}

}  // namespace

bool tellsWhoIsWho(const Frame& frame) {
  if (frame.isError() || frame.isRemote() || !frame.isExtended()) return false;
  const auto sent = J1939Id::of(frame.identifier()).pgn;
  return sent == pgn::kAddressClaimed ||
         (sent == pgn::kProprietaryA && hasTypeOf(frame, MessageId::AddressAnnouncement));
}

std::vector<Frame> framesInForce(const FrameStore& frames, const NoteStore& notes, std::uint64_t at,
                                 const std::stop_token& stop) {
  const std::vector<Note> before = notes.between(0, at + 1);
  auto note = before.begin();
  LogTimes times(frames);
  RoleWalk walk;
  std::map<Key, Said> last, challenges;
  std::bitset<256> isDown;  // by channel: its link
  // Behind a gap nothing that was said before it is known to hold.
  const auto passNotes = [&](std::uint64_t i) {
    for (; note != before.end() && note->frame <= i; ++note) {
      teach(walk, *note);
      if (const auto* down = std::get_if<note::LinkDown>(&note->value)) isDown.set(down->channel.value);
      const auto* up = std::get_if<note::LinkUp>(&note->value);
      if (up == nullptr || !isDown[up->channel.value]) continue;
      isDown.reset(up->channel.value);
      std::erase_if(last, [&](const auto& entry) { return std::get<0>(entry.first) == up->channel.value; });
    }
  };
  for (std::uint64_t i = 0; i < at;) {
    for (const Frame& frame : frames.run(i)) {
      if (i == at) break;
      if (i % kGlance == 0 && stop.stop_requested()) return {};
      passNotes(i);
      const Classified what = walk.next(frame, times.at(i));
      if (what.isDecoded() && kIsIdentity[what.message]) {
        const Address source = J1939Id::of(frame.identifier()).source;
        const AddressBook& book = walk.book({frame.channel});
        // A claim of somebody who does not have the address yet, and may have it later.
        if (what.message == MessageId::Name && Name::of(frame) != book.holder(source))
          challenges[{frame.channel, source.value, what.message}] = {i, Name::of(frame), {}};
        else
          last[{frame.channel, source.value, what.message}] = {i, book.holder(source), book.pin(source)};
      }
      ++i;
    }
  }
  passNotes(at);
  walk.timeCame(frames.timeAt(at));

  for (const auto& [key, said] : challenges) {
    if (said.holder != walk.book({std::get<0>(key)}).holder({std::get<1>(key)})) continue;
    Said& claim = last[key];
    if (claim.holder != said.holder) claim = said;
  }
  std::vector<std::uint64_t> inForce;
  for (const auto& [key, said] : last) {
    const Address address{std::get<1>(key)};
    const AddressBook& book = walk.book({std::get<0>(key)});
    const bool isSameHolder = said.holder.isNull() || said.holder == book.holder(address);
    const bool isSamePin = said.pin.isNull() || said.pin == book.pin(address);
    if (address < kNullAddress && isSameHolder && isSamePin && !book.wasLeft(address))
      inForce.push_back(said.frame);
  }
  std::ranges::sort(inForce);
  std::vector<Frame> found;
  for (const std::uint64_t i : inForce) {
    Frame frame = frames[i];
    frame.stamp = stampAt(frames, frame.channel, at);
    frame.flags &= Frame::kSent | Frame::kConfirmed;
    found.push_back(frame);
  }
  return found;
}

std::vector<Note> notesInForce(const FrameStore& frames, const NoteStore& notes, std::uint64_t at) {
  const std::vector<Note> before = notes.between(0, at);
  std::map<NoteSubject, std::size_t> last;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (const auto about = subjectOf(before[i].value)) last[*about] = i;
  }
  std::vector<std::size_t> order;
  for (const auto& [about, i] : last) order.push_back(i);
  std::ranges::sort(order);
  std::vector<Note> found;
  for (const std::size_t i : order)
    found.push_back({.frame = at, .time = frames.timeAt(at), .value = before[i].value});
  return found;
}

}  // namespace deckpipe
