// SPDX-License-Identifier: GPL-3.0-or-later
// Values of the catalogue's fields in the words of people: units, numbers that the manuals name, keys as
// words. For the trace's Decoded column, the decode detail and their tooltips. Core says keys; everything
// that a person reads of them is made here.
#pragma once

#include <QString>
#include <cstdint>
#include <string_view>

#include "protocol/message.h"
#include "protocol/value.h"

namespace deckpipe {

QString toQString(std::string_view text);
// Upper case, without a prefix, so many digits at least.
QString hexText(std::uint64_t number, int digits);

// "47.3°", "−40.0 %", "on", "11 (rotation sensor error)", "“A?\r\n”"; "no value" for null.
QString valueText(const Field& field, const Value& value);

// What a manual calls this value of this field, empty where none does.
QString numberName(const Field& field, std::int64_t number);
// "5001.02", and what the gateway's manual calls it (empty for others).
QString objectText(unsigned index, unsigned subindex);
QString objectName(unsigned index, unsigned subindex);

}  // namespace deckpipe
