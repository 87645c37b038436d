// SPDX-License-Identifier: GPL-3.0-or-later
#include "sending_actions.h"

#include <QAction>
#include <QMenu>
#include <QRandomGenerator>
#include <QSettings>
#include <algorithm>

#include "panel/common/build.h"
#include "panel/common/danger_dialog.h"
#include "protocol/address_book.h"
#include "protocol/name.h"
#include "text/service_text.h"

namespace deckpipe {
namespace {

const QString kIdentityKey = QStringLiteral("bus/identityNumber");
const QString kAddressKey = QStringLiteral("bus/preferredAddress");

std::optional<Address> keptAddress(const QSettings& settings) {
  bool isNumber = false;
  const uint address = settings.value(kAddressKey).toUInt(&isNumber);
  if (!isNumber || address >= kNullAddress.value) return {};
  return Address{static_cast<std::uint8_t>(address)};
}

}  // namespace

SendingActions::SendingActions(Session& session, QWidget* window)
    : QObject(window), m_session(session), m_window(window), m_menu(new QMenu(tr("&Bus"), window)) {
  m_lock = addNamed(m_menu, "lockAction", tr("&Unlock sending…"), QKeySequence(Qt::CTRL | Qt::Key_L), this,
                    &SendingActions::toggleLock);
  m_menu->addSeparator();
  m_names = addNamed(m_menu, "askNamesAction", tr("Ask who is &there"), this,
                     [this] { intent(intent::RequestNames{}); });
  m_names->setWhatsThis(tr("A request for the NAME to everyone (PGN 60928)"));
  m_everyone = addNamed(m_menu, "askEveryoneAction", tr("&Ask every device"), this, [this] {
    intent(intent::SendRequests{{}, kPolls});
  });
  m_stop = addNamed(m_menu, "stopAskingAction", tr("&Give up all that is asked"), this,
                    [this] { intent(intent::Cancel{}); });
  m_stop->setWhatsThis(tr("Ends every poll of every device, repeated ones too"));
  m_endRepeats = addNamed(m_menu, "endRepeatsAction", QString(), this, [this] {
    intent(intent::Repeat{{}, kPolls, Duration{0}});
  });
  setSnapshot({});
}

void SendingActions::setSnapshot(const Snapshot& snapshot) {
  const ServiceStatus& services = *snapshot.services;
  const bool isLive = snapshot.source.kind == SourceStatus::Kind::Link;
  m_isLocked = services.locked;
  m_lock->setText(m_isLocked ? tr("&Unlock sending…") : tr("&Lock sending"));
  const QString noLink = isLive ? QString() : tr("No link is open.");
  const QString past = !noLink.isEmpty()     ? noLink
                       : snapshot.view.atEnd ? QString()
                                             : refusalText(Refusal::NotLive);
  const QString down = !past.isEmpty() ? past : services.linkUp ? QString() : refusalText(Refusal::NoLink);
  const QString locked = !down.isEmpty() ? down : m_isLocked ? refusalText(Refusal::Locked) : QString();
  const QString mute = !locked.isEmpty() || services.canRequest() ? locked : refusalText(Refusal::NoAddress);
  offer(*m_lock, m_isLocked ? down : noLink);
  offer(*m_names, locked);
  offer(*m_everyone, mute);
  const bool isAsking = std::ranges::any_of(services.devices, [](const DeviceServices& device) {
    return device.longestPeriod() > 0ns ||
           std::ranges::any_of(device.requests, [](const RequestStatus& status) { return status.isOpen(); });
  });
  offer(*m_stop, isAsking ? noLink : tr("Nothing is asked at the moment."));
  const auto repeated = std::ranges::count_if(
      services.devices, [](const DeviceServices& device) { return device.longestPeriod() > 0ns; });
  offer(*m_endRepeats, repeated > 0 ? QString() : tr("No poll is repeated."));
  m_endRepeats->setText(
      repeated == 0 ? tr("&End repeated polls")
                    : tr("&End the repeated polls of %n devices", nullptr, static_cast<int>(repeated)));
}

void SendingActions::intent(const Intent& intent) { m_session.intend(intent); }

void SendingActions::lock() { m_session.intend(intent::Lock{}); }

void SendingActions::askToUnlock(const std::function<void()>& then) {
  const SourceStatus& source = m_session.snapshot().source;
  // Is refused; the notice says why and what to do.
  if (source.isListenOnly) return intent(intent::Unlock{});
  const QString where = source.simulated ? tr("the simulated truck") : source.name;
  DangerDialog::request(
      m_window,
      {tr("Unlock sending?"),
       tr("While locked, this program only listens. Unlocked, it claims an address of its own on %1, "
          "answers requests for its NAME, acknowledges data-pipe packets, and sends what you ask "
          "for. It stays unlocked until you lock it or close the link.")
           .arg(where),
       tr("Unlock"), tr("Keep locked")},
      [this, then] {
        intent(intent::Unlock{});
        if (then) then();
      });
}

ClaimSettings claimSettings() {
  QSettings settings;
  ClaimSettings claim;
  bool isKept = false;
  claim.identityNumber = settings.value(kIdentityKey).toUInt(&isKept) & kLargestIdentity;
  if (!isKept || claim.identityNumber == 0) {
    claim.identityNumber =
        static_cast<std::uint32_t>(QRandomGenerator::global()->bounded(1, int{kLargestIdentity} + 1));
    settings.setValue(kIdentityKey, claim.identityNumber);
  }
  if (const auto kept = keptAddress(settings); kept && addressUse(*kept) != AddressUse::Refused)
    claim.preferred = *kept;
  return claim;
}

std::optional<Address> dropRefusedAddress() {
  QSettings settings;
  const auto kept = keptAddress(settings);
  if (!kept || addressUse(*kept) != AddressUse::Refused) return {};
  settings.remove(kAddressKey);
  return kept;
}

void keepClaimSettings(const ClaimSettings& claim) {
  QSettings settings;
  settings.setValue(kIdentityKey, claim.identityNumber);
  settings.setValue(kAddressKey, uint{claim.preferred.value});
}

}  // namespace deckpipe
