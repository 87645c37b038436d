// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/axis_text.h"

#include <QCoreApplication>

namespace deckpipe {
namespace {

struct Axis {
  Q_DECLARE_TR_FUNCTIONS(Axis)
};

AxisText discharge() { return {Axis::tr("Discharge valve"), Axis::tr("Open"), Axis::tr("Close"), {}}; }

}  // namespace

AxisText axisText(std::optional<unsigned> deviceType, int axis) {
  constexpr unsigned kUniversal = 1032, kForestry = 1040, kGlobal = 1042, kStreamMaster = 1052;
  const unsigned type = deviceType.value_or(0);
  const bool isKnown = type == kUniversal || type == kForestry || type == kGlobal || type == kStreamMaster;
  if (axis == 1) return {Axis::tr("Rotation"), Axis::tr("Right"), Axis::tr("Left"), {}};
  if (axis == 2) return {Axis::tr("Elevation"), Axis::tr("Up"), Axis::tr("Down"), {}};
  if (axis == 3 && isKnown) return {Axis::tr("Pattern"), Axis::tr("Stream"), Axis::tr("Fog"), {}};
  if (axis == 4 && type == kUniversal) {
    return {Axis::tr("Axis 4"), Axis::tr("High | Deploy"), Axis::tr("Low | Stow"),
            Axis::tr("Axis 4 is monitor specific. Trident Dual Gallonage: flow control, + is high flow. "
                     "DeckMaster: swing arm, + is deploy. Other monitors have none.")};
  }
  if (axis == 4 && type == kForestry) return discharge();
  if (axis == 5 && type == kUniversal) return discharge();
  return {Axis::tr("Axis %1").arg(axis), Axis::tr("Plus"), Axis::tr("Minus"),
          Axis::tr("The manual names no use of this axis on this device.")};
}

}  // namespace deckpipe
