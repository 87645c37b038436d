// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/device_details.h"

#include <QCoreApplication>
#include <QStringList>

#include "model/device_rows.h"
#include "text/catalogue_text.h"
#include "text/device_text.h"
#include "text/j1939_text.h"
#include "text/time_text.h"

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

QString addressNow(const State& state, const Device& d) {
  const std::optional<Duration> age = ageAt(d.addressSince, state.cursor().time);
  if (d.address == kNullAddress) {
    if (d.previousAddress() == kNullAddress) return Details::tr("none");
    const QString before = addressText(d.previousAddress());
    return age ? Details::tr("lost %1, it was %2").arg(agoText(*age), before)
               : Details::tr("lost, it was %1").arg(before);
  }
  const QString address = addressText(d.address);
  return age ? Details::tr("%1 for %2").arg(address, briefAge(*age)) : address;
}

QStringList addressesBefore(const State& state, const Device& d) {
  QStringList lines;
  int listed = 0;
  for (const FormerAddress& former : d.formerAddresses) {
    if (former.address == kNullAddress) continue;
    ++listed;
    // The one that it lost is said where the present one would stand.
    if (listed == 1 && d.address == kNullAddress) continue;
    const QString address = addressText(former.address);
    const std::optional<Duration> age = ageAt(former.until, state.cursor().time);
    lines << (age ? Details::tr("%1 until %2").arg(address, agoText(*age)) : address);
  }
  const int all = d.addressChanges + (d.address == kNullAddress ? 1 : 0);
  if (all > listed) lines << Details::tr("and %n earlier", nullptr, all - listed);
  return lines;
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

QString contestText(const AddressBook& book, Address address) {
  const int won = book.claimsWon(address), lost = book.claimsLost(address);
  if (won == 0 && lost == 0) return {};
  return Details::tr("%1 won, %2 lost").arg(won).arg(lost);
}

QString detailsText(const LogView& view, const DeviceKey& key, const DeviceLabels& labels) {
  if (view.state == nullptr) return {};
  const State& state = *view.state;
  const std::optional<DeviceRow> row = deviceRow(state, key);
  if (!row) return {};
  const Device* device = findDevice(state, key);
  QStringList lines{
      Details::tr("%1 – %2", "device and its type").arg(nameText(*row, labels), typeText(*row))};
  if (const QString former = formerText(*row, labels); !former.isEmpty())
    lines << Details::tr("PIN: %1").arg(former);
  if (const QString channel = channelText(view, row->channel); !channel.isEmpty())
    lines << Details::tr("Channel: %1").arg(channel);
  if (device != nullptr && device->kind != Device::Kind::Node) {
    lines << Details::tr("Address: %1").arg(addressNow(state, *device));
    for (const QString& before : addressesBefore(state, *device))
      lines << Details::tr("Before: %1").arg(before);
  }
  if (row->age) lines << Details::tr("Last heard: %1").arg(agoText(*row->age));
  for (const HealthReason& reason : healthReasons(row->health, state.cursor().time))
    lines << reason.text << QStringLiteral("    ") + healthAdvice(reason.cause);
  const ChannelState& channel = state.channel(row->channel);
  if (const Joystick* stick = channel.joysticks.find(row->address); stick != nullptr && stick->priority())
    lines << Details::tr("Joystick priority: %1").arg(priorityText(*stick->priority()));
  if (row->address == kNullAddress) return lines.join(QLatin1Char('\n'));

  if (const QString use = reservedUse(row->address); !use.isEmpty())
    lines << Details::tr("J1939 keeps this address for: %1").arg(use);
  if (const QString use = usualUse(row->address); !use.isEmpty())
    lines << Details::tr("By J1939 this address is %1, which is no proof").arg(use);
  if (const QString contests = contestText(channel.book, row->address); !contests.isEmpty())
    lines << Details::tr("Contests for the address: %1").arg(contests);
  lines << Details::tr("Claim: %1")
               .arg(wordText(claimKey(channel.book.claim(row->address, state.cursor().time))));
  const Name former = channel.book.formerHolder(row->address);
  if (!former.isNull()) lines << Details::tr("Before the link went down:");
  const Name name = former.isNull() ? channel.book.lastHolder(row->address) : former;
  if (!name.isNull()) {
    lines
        << Details::tr("NAME %1 hex").arg(QString::number(name.value, 16).toUpper().rightJustified(16, u'0'));
    for (const QString& line : nameLines(name)) lines << QStringLiteral("    ") + line;
  }
  return lines.join(QLatin1Char('\n'));
}

}  // namespace deckpipe
