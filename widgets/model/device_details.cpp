// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/device_details.h"

#include <QCoreApplication>
#include <QStringList>

#include "model/device_rows.h"
#include "text/age_text.h"
#include "text/catalogue_text.h"
#include "text/device_text.h"
#include "text/joystick_text.h"

namespace deckpipe {
namespace {

struct Details {
  Q_DECLARE_TR_FUNCTIONS(Details)
};

}  // namespace

QString channelText(const LogView& view, Channel channel) {
  if (view.document == nullptr || view.document->frames.channelCount() < 2) return {};
  const std::string_view name = view.document->frames.channelName(channel.value);
  return QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()));
}

QString addressHistory(const State& state, const Device& d) {
  const Instant now = state.cursor().time;
  const QString before = addressText(d.previousAddress);
  if (d.address == kNullAddress) {
    return d.previousAddress == kNullAddress
               ? Details::tr("none")
               : Details::tr("lost %1, it was %2").arg(agoText(now - d.addressSince), before);
  }
  QString text = addressText(d.address);
  if (d.addressSince != kNotYet) text = Details::tr("%1 for %2").arg(text, briefAge(now - d.addressSince));
  if (d.previousAddress != kNullAddress) text = Details::tr("%1, before that %2").arg(text, before);
  if (d.addressChanges > 1) text += Details::tr(", %n changes", nullptr, d.addressChanges);
  return text;
}

std::string_view claimKey(ClaimState claim) {
  switch (claim) {
    case ClaimState::NoClaim: return "no_claim";
    case ClaimState::Claiming: return "claiming";
    case ClaimState::Claimed: return "claimed";
    case ClaimState::Contested: return "contested";
    case ClaimState::CannotClaim: return "cannot_claim";
  }
  return {};
}

QString contestText(const Node& node) {
  if (node.claimsWon == 0 && node.claimsLost == 0) return {};
  return Details::tr("%1 won, %2 lost").arg(node.claimsWon).arg(node.claimsLost);
}

QString detailsText(const LogView& view, const DeviceKey& key) {
  if (view.state == nullptr) return {};
  const State& state = *view.state;
  const std::optional<DeviceRow> row = deviceRow(state, key);
  if (!row) return {};
  const Device* device = findDevice(state, key);
  QStringList lines{deviceText(*row) + QStringLiteral(" – ") + typeText(*row)};
  if (const QString channel = channelText(view, row->channel); !channel.isEmpty())
    lines << Details::tr("Channel: %1").arg(channel);
  if (device != nullptr && device->kind != Device::Kind::Node)
    lines << Details::tr("Address: %1").arg(addressHistory(state, *device));
  if (row->age) lines << Details::tr("Last heard: %1").arg(agoText(*row->age));
  lines << healthReasons(row->health);
  const ChannelState& channel = state.channel(row->channel);
  if (const Joystick* stick = channel.joysticks.find(row->address); stick != nullptr && stick->priority())
    lines << Details::tr("Joystick priority: %1").arg(priorityText(*stick->priority()));
  if (row->address == kNullAddress) return lines.join(QLatin1Char('\n'));

  const Node& node = channel.claims[row->address];
  if (const QString use = reservedUse(row->address); !use.isEmpty())
    lines << Details::tr("J1939 keeps this address for: %1").arg(use);
  if (const QString contests = contestText(node); !contests.isEmpty())
    lines << Details::tr("Contests for the address: %1").arg(contests);
  lines << Details::tr("Claim: %1").arg(wordText(claimKey(node.claim)));
  if (node.name.value != 0) {
    lines << Details::tr("NAME %1 hex")
                 .arg(QString::number(node.name.value, 16).toUpper().rightJustified(16, u'0'));
    for (const QString& line : nameLines(node.name)) lines << QStringLiteral("    ") + line;
  }
  return lines.join(QLatin1Char('\n'));
}

}  // namespace deckpipe
