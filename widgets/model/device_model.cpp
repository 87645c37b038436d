// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/device_model.h"

#include <QLocale>
#include <algorithm>

#include "model/device_details.h"
#include "text/device_text.h"
#include "text/time_text.h"

namespace deckpipe {
namespace {

int toInt(std::size_t n) { return static_cast<int>(n); }

// What is written of an age, so that a row changes only when its text does.
Duration shownAge(Duration age) {
  if (age < 1s) return 0s;
  return age < 10s ? age - age % 100ms : age - age % 1s;
}

// Two devices of the same rate would overtake each other all the time if all digits counted.
std::uint32_t leadingDigits(std::uint32_t n) {
  std::uint32_t unit = 1;
  while (n / unit >= 100) unit *= 10;
  return n - n % unit;
}

// `hint` is where it stands unless something came or went.
int findRow(const std::vector<DeviceRow>& rows, const DeviceKey& key, std::size_t hint = 0) {
  if (hint < rows.size() && rows[hint].key == key) return toInt(hint);
  const auto found = std::ranges::find(rows, key, &DeviceRow::key);
  return found == rows.end() ? -1 : toInt(static_cast<std::size_t>(found - rows.begin()));
}

}  // namespace

DeviceModel::DeviceModel(QObject* parent)
    : TableModel(
          {{tr("Device"),
            tr("Your own label or the PIN; where it is heard if it has not said its PIN. F2 edits the "
               "label.")},
           {tr("Type")},
           {tr("Addr.", "address, in hexadecimal"), tr("J1939 address or CANopen node, hexadecimal"), true},
           {tr("Age"), tr("Time since it was last heard, at the cursor"), true},
           {tr("Health"), tr("What it reported, and what stopped coming; its page says all of it")},
           {tr("Rate", "frames a second"), tr("Frames in the last whole second before the cursor"), true},
           {tr("Frames"), tr("Frames it sent, up to the cursor"), true}},
          parent) {
  setObjectName(QStringLiteral("deviceModel"));
}

void DeviceModel::setView(const LogView& view) {
  m_view = view;
  std::vector<DeviceRow> next;
  if (view.state != nullptr) next = deviceRows(*view.state);
  for (DeviceRow& row : next) {
    if (row.age) row.age = shownAge(*row.age);
  }

  // What was an address without a PIN and has one now is the same row under a new key, and so is what had a PIN before
  // the link was down.
  for (std::size_t i = 0; i < next.size(); ++i) {
    const DeviceRow& row = next[i];
    const bool hasPin = row.key.kind == DeviceKey::Kind::Pin;
    if (hasPin ? row.address == kNullAddress : row.formerPin.isNull()) continue;
    if (findRow(m_rows, row.key, i) >= 0) continue;
    const DeviceKey before =
        hasPin ? DeviceKey::at(row.channel, row.address) : DeviceKey::of(row.formerPin, row.channel);
    const int at = rowOf(before);
    if (at < 0 || findRow(next, before) >= 0) continue;
    replace(at, row);
    Q_EMIT keyChanged(before, row.key);
  }
  removeGone(next);
  for (std::size_t i = 0; i < next.size(); ++i) {
    const int at = findRow(m_rows, next[i].key, i);
    const int to = toInt(i);
    if (at < 0) {
      beginInsertRows({}, to, to);
      m_rows.insert(m_rows.begin() + to, next[i]);
      endInsertRows();
      continue;
    }
    if (at != to) {
      beginMoveRows({}, at, at, {}, to);  // what stands before `to` is in place, so it only moves up
      std::rotate(m_rows.begin() + to, m_rows.begin() + at, m_rows.begin() + at + 1);
      endMoveRows();
    }
    replace(to, next[i]);
  }
}

void DeviceModel::setLabels(const DeviceLabels& labels) {
  if (labels == m_labels) return;
  m_labels = labels;
  sayChanged(DeviceColumn, DeviceColumn);
}

void DeviceModel::removeGone(const std::vector<DeviceRow>& next) {
  for (int row = toInt(m_rows.size()); row-- > 0;) {
    if (findRow(next, keyAt(row), static_cast<std::size_t>(row)) >= 0) continue;
    beginRemoveRows({}, row, row);
    m_rows.erase(m_rows.begin() + row);
    endRemoveRows();
  }
}

void DeviceModel::replace(int row, const DeviceRow& next) {
  DeviceRow& shown = m_rows[static_cast<std::size_t>(row)];
  if (shown == next) return;
  int first = ColumnCount, last = -1;
  const auto changed = [&](int column, bool isChanged) {
    if (!isChanged) return;
    first = std::min(first, column);
    last = std::max(last, column);
  };
  const bool isOther = shown.key != next.key || shown.type != next.type || shown.group != next.group ||
                       shown.isJoystick != next.isJoystick || shown.formerPin != next.formerPin;
  changed(DeviceColumn, isOther);
  changed(FramesColumn, isOther);  // all columns: sorted by any of them, the row may belong elsewhere now
  changed(AddressColumn, shown.address != next.address || shown.previousAddress != next.previousAddress);
  changed(AgeColumn, shown.age != next.age);
  changed(HealthColumn, shown.health != next.health);
  changed(RateColumn, shown.rate != next.rate);
  changed(FramesColumn, shown.frames != next.frames);
  shown = next;
  if (last >= 0) Q_EMIT dataChanged(index(row, first), index(row, last));
}

int DeviceModel::rowOf(const DeviceKey& key) const { return findRow(m_rows, key); }

DeviceKey DeviceModel::keyAt(int row) const {
  return row >= 0 && row < rowCount() ? m_rows[static_cast<std::size_t>(row)].key : DeviceKey{};
}

QString DeviceModel::emptyText() const {
  if (m_view.state == nullptr || m_view.document == nullptr)
    return tr("Nothing is open.\nConnect an adapter or open a log.");
  const State& state = *m_view.state;
  const std::uint64_t frames = state.cursor().frames;
  if (frames == 0) {
    if (m_view.frameCount > 0) return tr("No device heard yet.\nThe log is at its begin.");
    return tr("No device heard yet.\nNot one frame has come.");
  }
  std::uint64_t errors = 0;
  for (std::uint8_t c = 0; c < kMaxChannels; ++c) errors += state.channel(Channel{c}).errorFrames;
  const QString heard = frames == 1 ? tr("One frame heard, not from a known device.")
                                    : tr("%1 frames heard, none from a known device.")
                                          .arg(QLocale().toString(static_cast<qulonglong>(frames)));
  if (errors == 0) return heard;
  if (frames == 1) return tr("%1\nIt is an error frame: check bit rate and termination.").arg(heard);
  return errors == 1 ? tr("%1\nOne of them is an error frame: check bit rate and termination.").arg(heard)
                     : tr("%1\n%2 of them are error frames: check bit rate and termination.")
                           .arg(heard, QLocale().toString(static_cast<qulonglong>(errors)));
}

QString DeviceModel::textOf(const DeviceRow& row, int column) const {
  switch (column) {
    case DeviceColumn: {
      const QString label = m_labels.of(row.key);
      if (!label.isEmpty()) return label;
      return row.formerPin.isNull()
                 ? deviceText(row)
                 : tr("was %1", "a PIN; the address stands beside").arg(pinText(row.formerPin));
    }
    case TypeColumn: return typeText(row);
    case AddressColumn:
      if (row.key.kind == DeviceKey::Kind::Node) return hexText(row.key.node.value);
      return row.hasLostAddress() ? tr("lost", "an address") : hexText(row.address.value);
    case AgeColumn: return row.age ? calmAge(*row.age) : QString();
    case HealthColumn: return healthWord(row.health);
    case RateColumn:
      // Without times none is known.
      return row.age ? tr("%1/s", "frames a second").arg(QLocale().toString(row.rate)) : QString();
    case FramesColumn: return QLocale().toString(row.frames);
    default: return {};
  }
}

QString DeviceModel::detailOf(const DeviceRow& row) const {
  QStringList parts;
  if (!m_labels.of(row.key).isEmpty()) parts << deviceText(row);
  if (const QString label = m_labels.of(row.formerPin); !label.isEmpty())
    parts << tr("was %1", "a label").arg(label);
  parts << typeText(row);
  if (const QString channel = channelText(m_view, row.channel); !channel.isEmpty()) parts << channel;
  return parts.join(QStringLiteral(" · "));
}

QVariant DeviceModel::sortKey(const DeviceRow& row, int column) const {
  switch (column) {
    case AddressColumn:
      return row.channel.value * 256 +
             (row.key.kind == DeviceKey::Kind::Node ? row.key.node.value : row.address.value);
    case AgeColumn: return static_cast<qlonglong>(row.age.value_or(Duration::max()).count());
    case HealthColumn: return static_cast<int>(HealthCause::Count) - static_cast<int>(row.health.worst());
    case RateColumn: return leadingDigits(row.rate);
    case FramesColumn: return leadingDigits(row.frames);
    default: return textOf(row, column);
  }
}

QVariant DeviceModel::cell(int at, int column, int role) const {
  const DeviceRow& row = m_rows[static_cast<std::size_t>(at)];
  switch (role) {
    case Qt::DisplayRole: return textOf(row, column);
    case Qt::EditRole: return column == DeviceColumn ? m_labels.of(row.key) : QVariant();
    case Qt::AccessibleTextRole:
      if (column == DeviceColumn)
        return tr("%1, %2, %3").arg(nameText(row, m_labels), typeText(row), groupText(row.group));
      if (column == AddressColumn)
        return row.hasLostAddress() ? tr("address lost")
                                    : tr("address %1 hex").arg(textOf(row, AddressColumn));
      if (column == HealthColumn)
        return (QStringList{healthWord(row.health)} + healthSentences(row.health, m_view.cursor.time))
            .join(QLatin1Char(' '));
      return textOf(row, column);
    case Qt::ToolTipRole: return detailsText(m_view, row.key, m_labels);
    case KeyRole: return QVariant::fromValue(row.key);
    case GroupRole: return static_cast<int>(row.group);
    case GroupTextRole: return groupText(row.group);
    case DetailRole: return detailOf(row);
    case SearchRole:
      return QStringList{nameText(row, m_labels), typeText(row), groupText(row.group),
                         textOf(row, AddressColumn), healthWords(row.health).join(QLatin1Char(' '))}
          .join(QLatin1Char(' '));
    case HealthRole: return static_cast<int>(row.health.severity());
    case HealthWordsRole: return healthWords(row.health);
    case SortRole: return sortKey(row, column);
    default: return {};
  }
}

Qt::ItemFlags DeviceModel::flags(const QModelIndex& index) const {
  const Qt::ItemFlags flags = TableModel::flags(index);
  const bool hasPin = keyAt(index.row()).kind == DeviceKey::Kind::Pin;
  return index.column() == DeviceColumn && hasPin ? flags | Qt::ItemIsEditable : flags;
}

bool DeviceModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::EditRole || (flags(index) & Qt::ItemIsEditable) == 0) return false;
  Q_EMIT labelEdited(keyAt(index.row()).pin, value.toString());
  return true;
}

}  // namespace deckpipe
