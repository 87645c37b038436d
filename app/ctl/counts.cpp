// SPDX-License-Identifier: GPL-3.0-or-later
#include "counts.h"

#include <algorithm>
#include <cstdio>

#include "base/time.h"

namespace deckpipe::ctl {

std::string counted(std::uint64_t number, std::string_view one, std::string_view many) {
  return std::to_string(number).append(" ").append(pluralOf(number, one, many));
}

std::string framesThat(std::uint64_t number, std::string_view doesOne, std::string_view doMany) {
  return framesText(number).append(" ").append(pluralOf(number, doesOne, doMany));
}

std::string lengthText(Duration length) {
  using Form = AgeFigures::Form;
  const AgeFigures figures = ageFigures(length);
  if (figures.form == Form::Tenths && figures.whole == 0)
    return std::to_string(std::max<std::int64_t>(0, length.count()) / 1'000'000) + " ms";
  const long long whole = figures.whole, rest = figures.rest;
  char text[48] = "";
  switch (figures.form) {
    case Form::Tenths: std::snprintf(text, sizeof text, "%lld.%lld s", whole, rest); break;
    case Form::Seconds: std::snprintf(text, sizeof text, "%lld s", whole); break;
    case Form::Minutes: std::snprintf(text, sizeof text, "%lld min %02lld s", whole, rest); break;
    case Form::Hours: std::snprintf(text, sizeof text, "%lld h %02lld min", whole, rest); break;
    case Form::Days: std::snprintf(text, sizeof text, "%lld d %02lld h", whole, rest); break;
  }
  return text;
}

}  // namespace deckpipe::ctl
