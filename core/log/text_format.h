// SPDX-License-Identifier: GPL-3.0-or-later
// The entry of a text format in the table of log_format.h, made from its parser.
#pragma once

#include <memory>

#include "log/log_format.h"
#include "log/text_reader.h"
#include "log/text_stream.h"

namespace deckpipe {

template <typename Parser>
std::unique_ptr<TextParser> makeTextParser() {
  return std::make_unique<Parser>();
}

template <typename Parser>
constexpr LogFormat textFormat(std::string_view name, std::string_view patterns,
                               decltype(LogFormat::write) write = nullptr) {
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
            return readText(bytes, makeTextParser<Parser>, target.frames, target.unkept, options);
          },
      .stream = [](FrameStore& store, UnkeptList& unkept,
                   const ReadOptions& options) -> std::unique_ptr<StreamReader> {
        return std::make_unique<TextStream>(std::make_unique<Parser>(), store, unkept, options);
      },
      .write = write,
  };
}

}  // namespace deckpipe
