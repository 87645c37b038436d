// SPDX-License-Identifier: GPL-3.0-or-later
// The entry of a text format in the table of log_format.h, made from its parser.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "log/log_format.h"
#include "log/sidecar.h"
#include "log/text_reader.h"
#include "log/text_stream.h"

namespace deckpipe {

template <typename Parser>
std::unique_ptr<TextParser> makeTextParser() {
  return std::make_unique<Parser>();
}

template <typename Parser>
constexpr LogFormat textFormat(std::string_view name, std::string_view patterns) {
  return {
      .name = name,
      .patterns = patterns,
      .sniff =
          [](std::string_view head, bool isWhole) {
            Parser parser;
            return sniffText(parser, head, isWhole);
          },
      .read =
          [](const LogBytes& bytes, const LogTarget& target, const ReadOptions& options) {
            return readText(bytes, makeTextParser<Parser>, target.frames, target.skipped, options);
          },
      .stream = [](const LogTarget& target, const ReadOptions& options) -> std::unique_ptr<StreamReader> {
        return std::make_unique<TextStream>(std::make_unique<Parser>(), target.frames, target.skipped,
                                            options);
      },
  };
}

// A format that is a line a frame, written by `writeLine`(frame, channel name, out); what it has no place for
// goes into a sidecar. `nameRead`(channel name) is what is read back of a name.
template <auto writeLine, auto nameRead>
class LineWriter final : public LogWriter {
 public:
  void begin(std::string&) override {}
  void channel(std::string_view name, std::string&) override {
    m_names.emplace_back(name);
    m_sidecar.channel(nameRead(name));
  }
  void note(const Note& note, std::string&) override { m_sidecar.note(note); }
  void frame(const Frame& frame, Instant time, std::string& out) override {
    writeLine(frame, m_names[frame.channel], out);
    m_sidecar.frame(frame, time);
  }
  void end(std::string&) override {}
  std::string beside() const override { return m_sidecar.text(); }

 private:
  std::vector<std::string> m_names;
  SidecarMaker m_sidecar;
};
template <auto writeLine, auto nameRead>
constexpr LogFormat writable(LogFormat format) {
  format.makeWriter = []() -> std::unique_ptr<LogWriter> {
    return std::make_unique<LineWriter<writeLine, nameRead>>();
  };
  return format;
}

}  // namespace deckpipe
