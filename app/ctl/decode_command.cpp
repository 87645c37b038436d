// SPDX-License-Identifier: GPL-3.0-or-later
// deckpipectl decode: protocol.md section 5.
#include <algorithm>
#include <array>
#include <optional>

#include "command.h"
#include "log_input.h"
#include "output.h"
#include "report/decode_lines.h"
#include "state/role_notes.h"

namespace deckpipe::ctl {
namespace {

struct ChannelAddress {
  std::string channel;  // empty: all of them
  Address address;
};

// Walks the store as it grows, with the roles of every channel.
class Decoder {
 public:
  Decoder(const LogInput& input, DecodeFormat format, std::vector<ChannelAddress> drives)
      : m_frames(input.frames),
        m_notes(input.notes),
        m_times(input.frames),
        m_format(format),
        m_drives(std::move(drives)) {}

  // Everything that has come since the last call, and out with it. False where standard output takes no more. Stamps
  // of 0 say nothing unless another one follows them: they wait for it, or for `isWhole`, the end of the log. Where no
  // frame has a time, no stamp is one.
  bool decodeNew(bool isWhole) {
    const std::uint64_t count = m_frames.count();
    m_hasTimes = m_frames.hasTimes();
    if (!m_hasTimes && !isWhole && m_frames[0].stamp == 0) return true;
    if (m_next == 0 && count > 0) m_output.text() += decodeHeader(m_format);
    const std::vector<Note> notes = m_notes.between(m_next, count);
    auto note = notes.begin();
    while (m_next < count) {
      for (const Frame& frame : m_frames.run(m_next)) {
        if (m_next == count) break;
        for (; note != notes.end() && note->frame == m_next; ++note) teach(m_roles, *note);
        decodeOne(m_hasTimes ? frame : withoutTime(frame), m_times.at(m_next++));
        if (!m_output.write()) return false;
      }
    }
    return m_output.flush();
  }

 private:
  static Frame withoutTime(Frame frame) {
    frame.stamp = kNoStamp;
    return frame;
  }

  void decodeOne(const Frame& frame, Instant time) {
    std::optional<std::string_view>& name = m_names[frame.channel];
    if (!name) {
      name = m_frames.channelName(frame.channel);
      for (const ChannelAddress& drive : m_drives) {
        if (drive.channel.empty() || drive.channel == *name)
          m_roles.sayDrive({frame.channel}, drive.address, true, time);
      }
    }
    appendDecoded(m_output.text(), m_format, frame, *name, m_roles.next(frame, time));
  }

  const FrameStore& m_frames;
  const NoteStore& m_notes;
  LogTimes m_times;
  DecodeFormat m_format;
  std::vector<ChannelAddress> m_drives;
  std::array<std::optional<std::string_view>, 256> m_names;  // of the channels seen so far
  RoleWalk m_roles;
  std::uint64_t m_next = 0;
  bool m_hasTimes = true;
  Output m_output;
};

}  // namespace

ExitStatus decodeCommand(const QStringList& given) {
  Arguments arguments(given,
                      "Decodes every frame of a log, one line each, to standard output.\n"
                      "What cannot be read is said on standard error with its line.");
  arguments.addArgument("FILE", logArgumentHelp());
  arguments.add(
      {{"format", "jsonl (default), csv or text.", "FORMAT", "jsonl"},
       {"drive", "A Copley drive is at this address (hex), on all channels or on one.", "[CHANNEL:]ADDR"},
       deltasOption()});
  if (const auto status = arguments.parse()) return *status;
  constexpr DecodeFormat kFormats[] = {DecodeFormat::JsonLines, DecodeFormat::Csv, DecodeFormat::Text};
  const std::size_t format = arguments.oneOf("format", {"jsonl", "csv", "text"});
  std::vector<ChannelAddress> drives;
  for (const QString& text : arguments.texts("drive")) {
    const qsizetype colon = text.lastIndexOf(QLatin1Char(':'));
    const auto address = parseAddress(text.mid(colon + 1));
    if (!address || colon == 0)
      arguments.bad(
          QStringLiteral("--drive '%1' is not [CHANNEL:]ADDR with ADDR in hex, 00 to FD").arg(text));
    drives.push_back(
        {text.left(std::max<qsizetype>(colon, 0)).toStdString(), address.value_or(kNullAddress)});
  }
  if (arguments.areBad()) return kBadUsage;

  LogInput input(arguments);
  Decoder decoder(input, kFormats[format], std::move(drives));
  bool written = true;
  const ExitStatus status = input.read([&] { return written = decoder.decodeNew(false); });
  written = written && decoder.decodeNew(true);
  return written ? status : kNotWhole;
}

}  // namespace deckpipe::ctl
