// SPDX-License-Identifier: GPL-3.0-or-later
// Why a link is not up, in English: the end of a sentence on standard error.
#pragma once

#include <QString>

#include "link/link_status.h"

namespace deckpipe::ctl {

inline constexpr EnumTable<LinkFault, const char*> kLinkFaultWords{{
    {LinkFault::None, "the link is gone"},
    {LinkFault::NoPlugin, "its plugin cannot be used"},
    {LinkFault::NoInterface, "there is no such CAN interface"},
    {LinkFault::InterfaceDown, "the interface is down"},
    {LinkFault::WrongBitRate, "the interface has another bit rate"},
    {LinkFault::BitRateRefused, "the adapter does not take the bit rate"},
    {LinkFault::NoAnswer, "the adapter does not answer"},
    {LinkFault::Gone, "the adapter is gone"},
    {LinkFault::Other, "the adapter reports a fault"},
}};

inline QString linkErrorText(const LinkError& error) {
  const QString detail = QString::fromStdString(error.detail);
  if (!detail.isEmpty() && (error.fault == LinkFault::None || error.fault == LinkFault::Other)) return detail;
  QString text = QLatin1String(kLinkFaultWords[error.fault]);
  if (error.bitRate != 0) text += QStringLiteral(": %1 bit/s").arg(error.bitRate);
  return detail.isEmpty() ? text : QStringLiteral("%1 (%2)").arg(text, detail);
}

}  // namespace deckpipe::ctl
