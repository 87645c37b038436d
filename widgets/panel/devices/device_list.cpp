// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/devices/device_list.h"

#include <QFontMetrics>
#include <QFontMetricsF>
#include <QHeaderView>
#include <QKeyEvent>
#include <QPaintEvent>
#include <QPainter>
#include <QPolygonF>
#include <QResizeEvent>
#include <QScrollBar>
#include <QToolTip>
#include <algorithm>

#include "model/device_model.h"
#include "model/device_rows.h"
#include "paint/app_style.h"
#include "panel/common/build.h"
#include "panel/devices/device_delegate.h"

namespace deckpipe {
namespace {

constexpr double kSectionPad = 8;
constexpr double kArrow = 3.5;  // half its width

constexpr int kCellPad = 8;
constexpr int kWordsRoom = 64;  // more for type and health before there is a column for the rate

}  // namespace

// The head of the device table: flat, its words in line with the cells below, the sorted column marked by an
// arrow. Used by DeviceList alone.
class DeviceHeader : public QHeaderView {
 public:
  explicit DeviceHeader(QWidget* parent) : QHeaderView(Qt::Horizontal, parent) {
    named(this, "deviceListHeader", DeviceList::tr("Sort the devices by"));
    setSectionsMovable(false);
    setStretchLastSection(false);
    setSortIndicatorClearable(true);
    setSortIndicator(-1, Qt::AscendingOrder);
    setMinimumSectionSize(32);
    setFixedHeight(32);
    setHighlightSections(false);
  }

 protected:
  void paintSection(QPainter* painter, const QRect& rect, int section) const override {
    const Colours& c = coloursOf(this);
    QPainter& p = *painter;
    p.save();
    p.setRenderHint(QPainter::Antialiasing);
    p.fillRect(rect, c.surface);
    const QFont small = secondaryFont(font());
    const QFontMetricsF metrics(small);
    const QString text = model()->headerData(section, orientation()).toString();
    const double width = metrics.horizontalAdvance(text);
    const bool isSorted = sortIndicatorSection() == section;
    double left = rect.left() + kSectionPad;
    if (section == DeviceModel::HealthColumn) {
      left = rect.center().x() + 0.5 - width / 2;  // as its cells: centred
    } else if (section != DeviceModel::DeviceColumn) {
      left = rect.right() + 1 - kSectionPad - width;
    }
    const double baseline = rect.center().y() + metrics.capHeight() / 2;
    p.setFont(small);
    p.setPen(isSorted ? c.accent.ink : c.textSecondary);
    p.drawText(QPointF(left, baseline), text);
    if (isSorted) {
      // Under the word, where it takes no room from it.
      const QPointF tip(left + width / 2, rect.bottom() - 3);
      const double down = sortIndicatorOrder() == Qt::DescendingOrder ? 1 : -1;
      p.setPen(Qt::NoPen);
      p.setBrush(c.accent.ink);
      p.drawPolygon(QPolygonF{tip + QPointF(-kArrow, -2 * down), tip + QPointF(kArrow, -2 * down),
                              tip + QPointF(0, 2.5 * down)});
    }
    p.setPen(QPen(c.stale.fill, 1));
    p.setRenderHint(QPainter::Antialiasing, false);
    p.drawLine(rect.bottomLeft(), rect.bottomRight());
    p.restore();
  }

  // What lies beside the sections, over the scroll bar.
  void paintEvent(QPaintEvent* event) override {
    QPainter(viewport()).fillRect(viewport()->rect(), coloursOf(this).surface);
    QHeaderView::paintEvent(event);
  }
};

DeviceList::DeviceList(QWidget* parent)
    : QTreeView(parent), m_delegate(new DeviceDelegate(this)), m_header(new DeviceHeader(this)) {
  named(this, "deviceList", tr("Devices"));
  setItemDelegate(m_delegate);
  makeFlat(*this);
  setAllColumnsShowFocus(false);  // drawRow() frames the row
  setVerticalScrollMode(ScrollPerPixel);
  setHeader(m_header);
  // setHeader() takes these back where the view does not sort by itself; DeviceListPanel sorts through the
  // proxy.
  m_header->setSectionsClickable(true);
  m_header->setSortIndicatorShown(true);
}

void DeviceList::setModel(QAbstractItemModel* model) {
  QTreeView::setModel(model);
  header()->setSectionResizeMode(QHeaderView::Fixed);
  header()->setSectionResizeMode(DeviceModel::DeviceColumn, QHeaderView::Stretch);
  // They stand under the device.
  setColumnHidden(DeviceModel::TypeColumn, true);
  setColumnHidden(DeviceModel::AgeColumn, true);
  connect(this, &QAbstractItemView::doubleClicked, this, &DeviceList::editLabel);
  layOutColumns();
}

void DeviceList::resizeEvent(QResizeEvent* event) {
  QTreeView::resizeEvent(event);
  layOutColumns();
}

// The columns are as wide in the letters of another density.
void DeviceList::changeEvent(QEvent* event) {
  QTreeView::changeEvent(event);
  if (event->type() == QEvent::FontChange) layOutColumns();
}

// By the widest text that a column can have, never by what it has now: nothing moves while values run.
int DeviceList::widthOf(int column) const {
  const auto widest = [column] {
    switch (column) {
      case DeviceModel::AddressColumn: return QStringLiteral("Addr.");
      case DeviceModel::HealthColumn: return QStringLiteral("Health");
      case DeviceModel::RateColumn: return QStringLiteral("9,999/s");
      case DeviceModel::FramesColumn: return QStringLiteral("99,999,999");
      default: return QStringLiteral("8888WW888888888");  // a PIN
    }
  };
  return std::max(40, QFontMetrics(font()).horizontalAdvance(widest()) + 2 * kCellPad);
}

int DeviceList::leastWidth() const {
  return widthOf(DeviceModel::DeviceColumn) + widthOf(DeviceModel::AddressColumn) +
         widthOf(DeviceModel::HealthColumn) + verticalScrollBar()->sizeHint().width() + 2 * frameWidth();
}

void DeviceList::layOutColumns() {
  if (model() == nullptr) return;
  int room = width() - leastWidth() - kWordsRoom;
  for (const int column : {DeviceModel::AddressColumn, DeviceModel::HealthColumn})
    setColumnWidth(column, widthOf(column));
  for (const int column : {DeviceModel::RateColumn, DeviceModel::FramesColumn}) {
    setColumnWidth(column, widthOf(column));
    room -= widthOf(column);
    setColumnHidden(column, room < 0);
  }
}

void DeviceList::editLabel(const QModelIndex& index) {
  const QModelIndex device = index.siblingAtColumn(DeviceModel::DeviceColumn);
  if (!device.isValid()) return;
  if ((device.flags() & Qt::ItemIsEditable) != 0) {
    edit(device);
    return;
  }
  QToolTip::showText(viewport()->mapToGlobal(visualRect(device).bottomLeft()),
                     tr("Labels are kept by PIN, and this one has not said a PIN."), this);
}

// The words of the health reach from their cell to the left, and the age stands before them.
void DeviceList::dataChanged(const QModelIndex& first, const QModelIndex& last, const QList<int>& roles) {
  QTreeView::dataChanged(first, last, roles);
  if (first.column() > DeviceModel::HealthColumn || last.column() < DeviceModel::AgeColumn) return;
  const QRect from = visualRect(first.siblingAtColumn(DeviceModel::DeviceColumn));
  const QRect to = visualRect(last.siblingAtColumn(DeviceModel::HealthColumn));
  viewport()->update(from.united(to));
}

void DeviceList::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_F2) {
    editLabel(currentIndex());
    return;
  }
  QTreeView::keyPressEvent(event);
}

// QTreeView paints only the cells that it was asked for, and the words of the health lie in those before as well.
void DeviceList::paintEvent(QPaintEvent* event) {
  QPaintEvent rows(QRect(0, event->rect().top(), viewport()->width(), event->rect().height()));
  QTreeView::paintEvent(&rows);
}

void DeviceList::drawRow(QPainter* painter, const QStyleOptionViewItem& option,
                         const QModelIndex& index) const {
  const Colours& c = coloursOf(this);
  QStyleOptionViewItem row = option;
  const auto* order = qobject_cast<const DeviceOrder*>(model());
  if (order != nullptr && order->startsGroup(index.row())) {
    QRect heading = option.rect;
    heading.setHeight(DeviceDelegate::kHeadingHeight);
    painter->save();
    painter->fillRect(heading, c.surfaceAlternate);
    painter->setFont(secondaryFont(font()));
    painter->setPen(c.textSecondary);
    painter->drawText(heading.adjusted(kCellPad, 0, -kCellPad, 0), Qt::AlignVCenter | Qt::AlignLeft,
                      index.data(DeviceModel::GroupTextRole).toString());
    painter->restore();
    row.rect.setTop(heading.bottom() + 1);
  }
  // Once for all cells: the line under the device reaches into the next ones.
  painter->fillRect(row.rect, selectionModel()->isSelected(index) ? c.accent.fill : c.surface);
  QTreeView::drawRow(painter, row, index);
  painter->save();
  painter->setPen(QPen(c.stale.fill, 1));
  painter->drawLine(row.rect.bottomLeft(), row.rect.bottomRight());
  painter->restore();
}

}  // namespace deckpipe
