// SPDX-License-Identifier: GPL-3.0-or-later
// The catalogue's names and words in the person's language. Core says keys and English names and knows no
// translation; in catalogue_words.cpp and number_words.cpp each stands once more where lupdate finds it. The
// compiler compares the two, so that no name can be added or changed in the catalogue without its text.
#pragma once

#include <QString>
#include <span>
#include <string_view>

#include "protocol/message.h"

namespace deckpipe {

// "Position / limit status"
QString messageName(MessageId id);
// "Rotation", as the catalogue calls a field of any message.
QString fieldName(const Field& field);
// Words that fields take, fault keys and the console's own keys: "internal_fuse" is "Internal fuse". A key
// without a text is given back as it is.
QString wordText(std::string_view key);
// What a manual calls this number; empty where it has no name.
QString numberName(std::span<const ValueName> names, std::int64_t number);
// CiA 301's reason for an abort code; "code 0504FFFF" for one that has none.
QString abortText(std::uint32_t code);

// The texts themselves, not translated.
struct WordText {
  std::string_view key;
  const char* text;
};
const char* messageNameText(MessageId id);
std::span<const char* const> fieldNameTexts();
std::span<const char* const> numberNameTexts();
std::span<const char* const> abortTexts();
std::span<const WordText> wordTexts();

// Where a meaning comes from, for tooltips and help: "Source: CAN Messaging manual, message type 01; gateway
// manual, TPDO1". Titles are cited as they are printed. Empty for what is no message of the catalogue.
QString sourceText(MessageId id);

}  // namespace deckpipe
