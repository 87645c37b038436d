// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/device_rows.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>

#include "model/device_model.h"
#include "protocol/device_types.h"
#include "protocol/j1939.h"
#include "text/device_text.h"
#include "text/j1939_text.h"
#include "text/plural.h"

namespace deckpipe {
namespace {

using From = DeviceType::From;

struct Row {
  Q_DECLARE_TR_FUNCTIONS(Row)
};

bool isJoystick(const State& state, Channel channel, Address address) {
  return state.channel(channel).joysticks.find(address) != nullptr;
}

DeviceGroup groupOf(const Device& d, const DeviceRow& row) {
  if (d.kind == Device::Kind::Node) return DeviceGroup::CanopenNodes;
  if (isMonitor(d)) return DeviceGroup::Monitors;
  if (row.isJoystick || isControl(row)) return DeviceGroup::Controls;
  return DeviceGroup::OtherAkron;
}

DeviceRow rowOf(const State& state, const Device& d) {
  DeviceRow row;
  row.key = keyOf(d);
  row.type = typeOf(d);
  row.isJoystick = d.kind != Device::Kind::Node && isJoystick(state, d.channel, d.address);
  row.group = groupOf(d, row);
  row.channel = d.channel;
  row.address = d.address;
  row.previousAddress = d.previousAddress();
  if (d.kind == Device::Kind::Address) row.formerPin = state.channel(d.channel).book.formerPin(d.address);
  row.age = ageAt(d.lastHeard, state.cursor().time);
  row.health = healthOf(state, d);
  row.frames = d.frames;
  row.rate = d.rate.at(state.cursor().time, d.lastHeard);
  return row;
}

DeviceRow rowOf(const State& state, Channel channel, Address address) {
  const Node node = state.channel(channel).nodes[address];
  DeviceRow row;
  row.key = DeviceKey::at(channel, address);
  row.type = typeOf(state, channel, address);
  row.isJoystick = isJoystick(state, channel, address);
  row.group = row.isJoystick                     ? DeviceGroup::Controls
              : row.type.from == From::AkronName ? DeviceGroup::OtherAkron
                                                 : DeviceGroup::OtherNodes;
  row.channel = channel;
  row.address = address;
  row.formerPin = state.channel(channel).book.formerPin(address);
  row.age = ageAt(node.lastHeard, state.cursor().time);
  row.health = healthOf(state, channel, address);
  row.frames = node.frames;
  row.rate = node.rate.at(state.cursor().time, node.lastHeard);
  return row;
}

// What is left of an address after the device that had it went on to another one, or lost it, and nobody else
// was heard there: the device has its own row.
bool wasLeft(const State& state, Channel channel, Address address) {
  const AddressBook& book = state.channel(channel).book;
  if (book.wasLeft(address)) return true;
  return std::ranges::any_of(state.devices().all(), [&](const Device& d) {
    return d.kind == Device::Kind::Pin && d.channel == channel && isNameOf(book.lastHolder(address), d.pin);
  });
}

}  // namespace

DeviceKey keyOf(const Device& d) {
  switch (d.kind) {
    case Device::Kind::Pin: return DeviceKey::of(d.pin, d.channel);
    case Device::Kind::Address: return DeviceKey::at(d.channel, d.address);
    case Device::Kind::Node: return DeviceKey::at(d.channel, d.node);
    case Device::Kind::Free: break;
  }
  return {};
}

const Device* findDevice(const State& state, const DeviceKey& key) {
  switch (key.kind) {
    case DeviceKey::Kind::Pin: {
      const Device* device = state.devices().byPin(key.channel, key.pin);
      if (device != nullptr) return device;
      const Address former = state.channel(key.channel).book.formerAddress(key.pin);
      return former == kNullAddress ? nullptr : state.devices().byAddress(key.channel, former);
    }
    case DeviceKey::Kind::Address: return state.devices().byAddress(key.channel, key.address);
    case DeviceKey::Kind::Node: return state.devices().byNode(key.channel, key.node);
    case DeviceKey::Kind::None: break;
  }
  return nullptr;
}

bool isControl(const DeviceRow& row) { return isOfUse(row.type.pinDigits().value_or(0), DeviceUse::Control); }

std::vector<DeviceRow> deviceRows(const State& state) {
  std::vector<DeviceRow> rows;
  for (const Device& d : state.devices().all()) {
    if (d.kind != Device::Kind::Free) rows.push_back(rowOf(state, d));
  }
  for (std::size_t c = 0; c < state.channelCount(); ++c) {
    const Channel channel{static_cast<std::uint8_t>(c)};
    for (unsigned a = 0; a < kNullAddress.value; ++a) {
      const Address address{static_cast<std::uint8_t>(a)};
      if (!state.channel(channel).book.isHeard(address)) continue;
      if (state.devices().byAddress(channel, address) != nullptr) continue;
      if (!wasLeft(state, channel, address)) rows.push_back(rowOf(state, channel, address));
    }
  }
  return rows;
}

std::optional<DeviceRow> deviceRow(const State& state, const DeviceKey& key) {
  if (const Device* d = findDevice(state, key)) return rowOf(state, *d);
  if (key.kind != DeviceKey::Kind::Address || key.channel.value >= kMaxChannels) return {};
  if (!state.channel(key.channel).book.isHeard(key.address)) return {};
  return rowOf(state, key.channel, key.address);
}

QString untrackedText(const State& state) {
  QStringList lines;
  if (const std::uint64_t frames = state.untrackedFrames(); frames != 0) {
    lines << Row::tr("%Ln frames on channels beyond the first %1: their devices are not listed", nullptr,
                     forPlural(frames))
                 .arg(kMaxChannels);
  }
  if (const std::uint64_t frames = state.devices().untracked(); frames != 0) {
    lines << Row::tr("%Ln frames of devices beyond the first %1, which are not listed", nullptr,
                     forPlural(frames))
                 .arg(kMaxDevices);
  }
  return lines.join(QLatin1Char('\n'));
}

QString groupText(DeviceGroup group) {
  switch (group) {
    case DeviceGroup::Monitors: return Row::tr("Monitors");
    case DeviceGroup::Controls: return Row::tr("Controls");
    case DeviceGroup::OtherAkron: return Row::tr("Other Akron devices");
    case DeviceGroup::CanopenNodes: return Row::tr("CANopen nodes");
    case DeviceGroup::OtherNodes: return Row::tr("Other nodes");
  }
  return {};
}

QString typeText(const DeviceRow& row) {
  switch (row.type.from) {
    case From::Pin: return deviceTypeText(row.type.number);
    case From::Part: return partText(row.type.number);
    case From::Messages83: return Row::tr("Monitor, type not known");
    case From::Messages84: return deviceTypeText(soleSenderOf(MessageId::MiniDigitalOutputs));
    case From::Messages85: return Row::tr("6039 CAN I/O module");
    case From::AkronMessages: return Row::tr("Akron device, type not known");
    case From::AkronName: return Row::tr("Akron device, not announced");
    case From::Drive: return Row::tr("Copley drive");
    case From::Own: return Row::tr("This console");
    case From::GatewayNode: return Row::tr("6051 CAN Gateway, by its default node");
    case From::MonitorNode: return Row::tr("Monitor, by its messages");
    case From::CanopenNode: return Row::tr("Type not known");
    case From::OtherName:
    case From::NoName: break;
  }
  if (row.isJoystick) {
    return row.type.from == From::NoName ? Row::tr("Joystick source")
                                         : Row::tr("Joystick, %1").arg(makerText(row.type.number));
  }
  QString type = Row::tr("No NAME heard");
  if (row.type.from != From::NoName) {
    type = makerText(row.type.number);
    type.replace(0, 1, type.at(0).toUpper());
  }
  const QString use = usualUse(row.address);
  return use.isEmpty()
             ? type
             : Row::tr("%1; %2", "what is known of a node, what its address is usually for").arg(type, use);
}

QString deviceText(const DeviceRow& row) {
  if (!row.formerPin.isNull())
    return Row::tr("Address %1, was %2", "an address and a PIN")
        .arg(hexText(row.address.value), pinText(row.formerPin));
  const bool lacksPin = row.group == DeviceGroup::Monitors || row.group == DeviceGroup::OtherAkron;
  if (row.key.kind == DeviceKey::Kind::Address && lacksPin)
    return Row::tr("No PIN, address %1").arg(hexText(row.address.value));
  return keyText(row.key);
}

QString formerText(const DeviceRow& row, const DeviceLabels& labels) {
  if (row.formerPin.isNull()) return {};
  return Row::tr("was %1, before the link went down")
      .arg(nameText(DeviceKey::of(row.formerPin, row.channel), labels));
}

QString nameText(const DeviceRow& row, const DeviceLabels& labels) {
  return labels.of(row.key).isEmpty() ? deviceText(row) : nameText(row.key, labels);
}

QString nameText(const DeviceKey& key, const DeviceLabels& labels) {
  const QString label = labels.of(key);
  if (label.isEmpty()) return keyText(key);
  return Row::tr("%1 (%2)", "label and PIN").arg(label, keyText(key));
}

QString keyText(const DeviceKey& key) {
  switch (key.kind) {
    case DeviceKey::Kind::Pin: return pinText(key.pin);
    case DeviceKey::Kind::Address: return Row::tr("Address %1").arg(hexText(key.address.value));
    case DeviceKey::Kind::Node: return Row::tr("Node %1").arg(hexText(key.node.value));
    case DeviceKey::Kind::None: break;
  }
  return {};
}

DeviceOrder::DeviceOrder(QObject* parent) : QSortFilterProxyModel(parent) {
  setObjectName(QStringLiteral("deviceOrder"));
  orderBy(-1, Qt::AscendingOrder);
}

void DeviceOrder::orderBy(int column, Qt::SortOrder order) {
  const bool wasOther = m_column != column;
  m_column = column;
  // Sorting by the same column of the base class does nothing, and -1 stands for its first one.
  if (wasOther) invalidate();
  sort(column < 0 ? 0 : column, column < 0 ? Qt::AscendingOrder : order);
}

void DeviceOrder::setFilter(const QString& text) {
  m_words = text.split(QLatin1Char(' '), Qt::SkipEmptyParts);
  invalidateFilter();
}

bool DeviceOrder::filterAcceptsRow(int row, const QModelIndex& parent) const {
  if (m_words.isEmpty()) return true;
  const QString text =
      sourceModel()->index(row, DeviceModel::DeviceColumn, parent).data(DeviceModel::SearchRole).toString();
  return std::ranges::all_of(m_words,
                             [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}

bool DeviceOrder::startsGroup(int row) const {
  const auto groupAt = [this](int r) { return index(r, 0).data(DeviceModel::GroupRole).toInt(); };
  return row == 0 || (row < rowCount() && groupAt(row) != groupAt(row - 1));
}

bool DeviceOrder::lessThan(const QModelIndex& left, const QModelIndex& right) const {
  const int a = left.data(DeviceModel::GroupRole).toInt();
  const int b = right.data(DeviceModel::GroupRole).toInt();
  // Groups keep their order when a column is sorted backwards.
  if (a != b) return sortOrder() == Qt::AscendingOrder ? a < b : a > b;
  if (m_column < 0) return left.row() < right.row();
  const QVariant l = left.data(DeviceModel::SortRole), r = right.data(DeviceModel::SortRole);
  return QVariant::compare(l, r) == QPartialOrdering::Less;
}

}  // namespace deckpipe
