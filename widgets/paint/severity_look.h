// SPDX-License-Identifier: GPL-3.0-or-later
// The sign and the colour of a severity, the same wherever one is shown.
#pragma once

#include <optional>

#include "base/severity.h"
#include "paint/glyph.h"
#include "paint/palette.h"

namespace deckpipe {

struct SeverityLook {
  std::optional<Glyph> glyph;
  Ink ink;
};

inline constexpr EnumTable<Severity, SeverityLook> kSeverityLooks{{
    {Severity::Plain, {{}, Ink::Text}},
    {Severity::Fine, {Glyph::Fine, Ink::Fine}},
    {Severity::Unknown, {Glyph::NoData, Ink::Stale}},
    {Severity::Busy, {Glyph::Stale, Ink::Accent}},
    {Severity::Warning, {Glyph::Warning, Ink::Warning}},
    {Severity::Fault, {Glyph::Fault, Ink::Fault}},
    {Severity::Silent, {Glyph::Stale, Ink::Stale}},
}};

inline std::optional<Glyph> glyphOf(Severity severity) { return kSeverityLooks[severity].glyph; }
inline Ink inkOf(Severity severity) { return kSeverityLooks[severity].ink; }

}  // namespace deckpipe
