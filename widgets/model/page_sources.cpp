// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/page_sources.h"

#include <QStringList>
#include <initializer_list>

#include "text/source_text.h"

namespace deckpipe {
namespace {

struct GroupSource {
  const char* key;
  std::initializer_list<MessageId> messages;
};

const GroupSource kSources[] = {
    {"dial",
     {MessageId::PositionLimitStatus, MessageId::RotationSoftLimits, MessageId::ElevationSoftLimits,
      MessageId::DigitalOutputs, MessageId::BasicJoystick}},
    {"stops", {MessageId::PositionLimitStatus}},
    {"status", {MessageId::PositionLimitStatus}},
    {"outputs", {MessageId::DigitalOutputs}},
    {"riser", {MessageId::MiniDigitalOutputs}},
    {"inputs", {MessageId::DigitalInputs}},
    {"permissive", {MessageId::SoePermissive}},
    {"switches", {MessageId::BasicJoystick}},
    {"detents", {MessageId::BasicJoystick}},
    {"grip", {MessageId::ExtendedJoystick}},
    {"joystick", {MessageId::BasicJoystick, MessageId::ExtendedJoystick}},
    {"faults", {MessageId::FaultResponse}},
    {"versions", {MessageId::FirmwareResponse, MessageId::PcodeResponse, MessageId::ConfigResponse}},
    {"node", {MessageId::Heartbeat, MessageId::SdoReadResponse}},
    {"address", {MessageId::Name, MessageId::AddressAnnouncement}},
};

}  // namespace

QString pageSourceText(const QString& groupKey) {
  QStringList lines;
  for (const GroupSource& source : kSources) {
    if (groupKey != QLatin1String(source.key)) continue;
    for (const MessageId id : source.messages) lines.append(sourceText(id));
  }
  return lines.join(QLatin1Char('\n'));
}

}  // namespace deckpipe
