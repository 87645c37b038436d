// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/common/device_question.h"

#include <QCoreApplication>
#include <QLocale>
#include <cmath>
#include <utility>

#include "model/device_rows.h"
#include "model/page_command.h"
#include "model/page_dial.h"
#include "paint/dial_text.h"
#include "text/device_text.h"
#include "text/service_text.h"
#include "text/time_text.h"

namespace deckpipe {
namespace {

struct DeviceQuestionText {
  Q_DECLARE_TR_FUNCTIONS(DeviceQuestionText)
};

QString angleText(DialAxisKind kind, const DialAxis& axis) {
  if (axis.reading != PositionState::Ok) return DialText::reading(axis.reading);
  const QString number = QLocale().toString(std::abs(axis.degrees), 'f', 1);
  const bool isPlus = axis.degrees > 0;
  if (axis.degrees == 0) return DeviceQuestionText::tr("%1°").arg(number);
  if (kind == DialAxisKind::Rotation)
    return isPlus ? DeviceQuestionText::tr("%1° right").arg(number)
                  : DeviceQuestionText::tr("%1° left").arg(number);
  return isPlus ? DeviceQuestionText::tr("%1° up").arg(number)
                : DeviceQuestionText::tr("%1° down").arg(number);
}

DangerDialog::Fact factOf(DialAxisKind kind, const DialAxis& axis) {
  QStringList remarks;
  if (const QString stops = DialText::stops(kind, axis); !stops.isEmpty()) remarks << stops;
  if (axis.command)
    remarks << DeviceQuestionText::tr("%1 commands %2", "who, what")
                   .arg(axis.command->source, commandText(*axis.command, kind == DialAxisKind::Rotation));
  return {DialText::title(kind), angleText(kind, axis), ageText(axis.age, axis.isStale),
          remarks.join(QStringLiteral(" · "))};
}

// Two, or none of a device that has no axes.
std::vector<DangerDialog::Fact> factsOf(const State& state, const Device& device) {
  if (!device.position().isKnown()) return {};
  const DialValues dial = dialOf(state, device);
  return {factOf(DialAxisKind::Rotation, dial.rotation), factOf(DialAxisKind::Elevation, dial.elevation)};
}

// Why nothing of what was asked about a device at `address` can be done; empty if it can.
QString whyNot(const PanelView& view, const Device* device, Address address) {
  const ServiceStatus& services = *view.services;
  if (!services.linkUp) return refusalText(Refusal::NoLink);
  if (!view.isLive) return refusalText(Refusal::NotLive);
  if (services.locked || services.isEnding) return refusalText(Refusal::Locked);
  if (!services.canRequest()) return refusalText(Refusal::NoAddress);
  if (device == nullptr || device->address == kNullAddress) return refusalText(Refusal::NoDevice);
  if (device->address != address)
    return DeviceQuestionText::tr("The device is at address %1 now.").arg(addressText(device->address));
  const auto silent = ageAt(device->lastHeard, view.log.state->cursor().time);
  return silent && *silent > kHeardWithin ? refusalText(Refusal::NotHeard) : QString();
}

}  // namespace

void DeviceQuestion::ask(QWidget* panel, const PanelView& view, DangerDialog::Question question,
                         std::function<void(bool isTicked)> act) {
  const Device* device = findDevice(*view.log.state, view.device);
  m_device = view.device;
  m_address = device != nullptr ? device->address : kNullAddress;
  QStringList whom;
  if (device != nullptr && !device->pin.isNull()) whom << deviceTypeText(device->pin.deviceType());
  if (m_address != kNullAddress) whom << DeviceQuestionText::tr("address %1").arg(addressText(m_address));
  question.whom = whom.join(QStringLiteral(" · "));
  if (device != nullptr) question.facts = factsOf(*view.log.state, *device);
  question.canBeWithdrawn = true;
  m_dialog = DangerDialog::request(panel, question, std::move(act));
  setView(view);
}

void DeviceQuestion::setView(const PanelView& view) {
  if (m_dialog == nullptr || m_dialog->isWithdrawn() || view.log.state == nullptr) return;
  const Device* device = findDevice(*view.log.state, m_device);
  if (const QString why = whyNot(view, device, m_address); !why.isEmpty())
    return m_dialog->withdraw(DeviceQuestionText::tr("Withdrawn, nothing was sent: %1").arg(why));
  m_dialog->setFacts(factsOf(*view.log.state, *device));
}

}  // namespace deckpipe
