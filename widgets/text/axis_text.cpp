// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/axis_text.h"

#include <QCoreApplication>

#include "protocol/device_types.h"

namespace deckpipe {
namespace {

struct Axis {
  Q_DECLARE_TR_FUNCTIONS(Axis)
};

}  // namespace

AxisText axisText(std::optional<unsigned> deviceType, int axis) {
  const DeviceTypeFacts* known = deviceTypeOf(deviceType.value_or(0));
  switch ((known != nullptr ? *known : DeviceTypeFacts{}).axes.at(static_cast<std::size_t>(axis - 1))) {
    case AxisUse::Rotation: return {Axis::tr("Rotation"), Axis::tr("Right"), Axis::tr("Left"), {}};
    case AxisUse::Elevation: return {Axis::tr("Elevation"), Axis::tr("Up"), Axis::tr("Down"), {}};
    case AxisUse::Pattern: return {Axis::tr("Pattern"), Axis::tr("Stream"), Axis::tr("Fog"), {}};
    case AxisUse::DependsOnMonitor:
      return {Axis::tr("Axis %1").arg(axis), Axis::tr("High | Deploy"), Axis::tr("Low | Stow"),
              Axis::tr("Axis 4 is monitor specific. Trident Dual Gallonage: flow control, + is high flow. "
                       "DeckMaster: swing arm, + is deploy. Other monitors have none.")};
    case AxisUse::DischargeValve:
      return {Axis::tr("Discharge valve"), Axis::tr("Open"), Axis::tr("Close"), {}};
    case AxisUse::Unnamed: break;
  }
  return {Axis::tr("Axis %1").arg(axis), Axis::tr("Plus"), Axis::tr("Minus"),
          Axis::tr("The manual names no use of this axis on this device.")};
}

}  // namespace deckpipe
