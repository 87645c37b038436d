// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that was heard on the bus as rows of plain values: devices in order of first appearance, then
// J1939 addresses that are no Akron device. A pure function of the state; DeviceModel compares two of these
// lists, the page takes the words for a type from here.
#pragma once

#include <QSortFilterProxyModel>
#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

#include "base/ids.h"
#include "model/device_details.h"
#include "model/device_labels.h"
#include "state/device_type.h"

namespace deckpipe {

enum class DeviceGroup : std::uint8_t { Monitors, Controls, OtherAkron, CanopenNodes, OtherNodes };

struct DeviceRow {
  DeviceKey key;
  DeviceGroup group = DeviceGroup::OtherNodes;
  DeviceType type;
  bool isJoystick = false;  // sends joystick messages
  Channel channel;
  Address address;          // null: none (a node), or lost
  Address previousAddress;  // null: none
  // The PIN that was there before the link was down, as long as nobody has said since who is there. Null: none.
  Pin formerPin;
  std::optional<Duration> age;
  Health health;
  std::uint32_t frames = 0;
  unsigned rate = 0;  // frames in the last whole second

  bool hasLostAddress() const { return key.kind == DeviceKey::Kind::Pin && address == kNullAddress; }
  friend bool operator==(const DeviceRow&, const DeviceRow&) = default;
};

DeviceKey keyOf(const Device& device);
// Whoever the key means now: an address means the device that has it, and a PIN of before the link was down whoever is
// where it was. Null where that is none.
const Device* findDevice(const State& state, const DeviceKey& key);
// Operator station, joystick, wireless interface, switchbox: they send joystick messages.
bool isControl(const DeviceRow& row);

std::vector<DeviceRow> deviceRows(const State& state);
// The row of one key; nothing where no such device was heard up to now.
std::optional<DeviceRow> deviceRow(const State& state, const DeviceKey& key);

// What was heard and is in none of the rows, as there are too many channels or devices; empty where all is.
QString untrackedText(const State& state);

QString groupText(DeviceGroup group);
QString typeText(const DeviceRow& row);
// "1032AE100801035", "No PIN, address 80", "Address 21" of who needs none, "Node 24", "Address 80, was 1032AE100801035".
QString deviceText(const DeviceRow& row);
// "was Roof monitor (1032AE100801035), before the link went down"; empty if it was nobody.
QString formerText(const DeviceRow& row, const DeviceLabels& labels);
QString keyText(const DeviceKey& key);
// What people call it, the label first: "Roof monitor (1032AE100801035)"; without a label as above.
QString nameText(const DeviceRow& row, const DeviceLabels& labels);
QString nameText(const DeviceKey& key, const DeviceLabels& labels);

// The device table in groups, in each group in the order that a person asked for. A DeviceModel is its
// source; the table of the device panel shows it.
class DeviceOrder : public QSortFilterProxyModel {
  Q_OBJECT

 public:
  explicit DeviceOrder(QObject* parent = nullptr);

  // -1: in order of first appearance.
  void orderBy(int column, Qt::SortOrder order);
  // Only rows that have every word of it somewhere, in their name, type, group, address or health.
  void setFilter(const QString& text);
  // Whether a row is the first of its group.
  bool startsGroup(int row) const;

 protected:
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override;
  bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;

 private:
  int m_column = -1;
  QStringList m_words;
};

}  // namespace deckpipe
