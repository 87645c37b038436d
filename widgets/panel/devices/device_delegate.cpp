// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/devices/device_delegate.h"

#include <QFontMetricsF>
#include <QLineEdit>
#include <QPainter>
#include <QTreeView>
#include <algorithm>
#include <cmath>

#include "model/device_model.h"
#include "model/device_rows.h"
#include "paint/app_style.h"
#include "paint/figures.h"
#include "panel/common/build.h"
#include "panel/common/health_look.h"

namespace deckpipe {
namespace {

constexpr double kPad = 8;
constexpr double kGlyph = 14;

double leftOfRow(const QStyleOptionViewItem& option) {
  const auto* view = qobject_cast<const QTreeView*>(option.widget);
  return view == nullptr ? option.rect.left() : view->columnViewportPosition(DeviceModel::DeviceColumn);
}

// Where the words of the health end: before the age, which ends where the row does.
double rightOfWords(const QFont& small, double rightOfRow) { return rightOfRow - widestAge(small) - kPad; }

QString wordsOf(const QModelIndex& index, const QFontMetricsF& metrics, double width) {
  return wordsThatFit(index.data(DeviceModel::HealthWordsRole).toStringList(), metrics, width);
}

}  // namespace

QSize DeviceDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
  const auto* order = qobject_cast<const DeviceOrder*>(index.model());
  const bool isFirst = order != nullptr && order->startsGroup(index.row());
  // Two lines with air, in a font as large as a person wants.
  const int height = std::max(kRowHeight, static_cast<int>(std::ceil(option.fontMetrics.height() * 2.7)));
  return {0, height + (isFirst ? kHeadingHeight : 0)};
}

QWidget* DeviceDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem&,
                                      const QModelIndex& index) const {
  auto* editor = new QLineEdit(parent);
  const QString pin = keyText(index.data(DeviceModel::KeyRole).value<DeviceKey>());
  named(editor, "labelEditor", tr("Label of %1").arg(pin));
  editor->setPlaceholderText(pin);
  editor->setMaxLength(DeviceLabels::kLongest);
  return editor;
}

// Over the whole row's name, below a group's heading.
void DeviceDelegate::updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                                          const QModelIndex& index) const {
  const auto* order = qobject_cast<const DeviceOrder*>(index.model());
  QRect row = option.rect;
  if (order != nullptr && order->startsGroup(index.row())) row.setTop(row.top() + kHeadingHeight);
  const int height = std::max(32, editor->sizeHint().height());
  editor->setGeometry(row.left() + 2, row.center().y() - height / 2, row.width() - 4, height);
}

void DeviceDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                           const QModelIndex& index) const {
  QPainter& p = *painter;
  p.save();
  p.setRenderHint(QPainter::Antialiasing);
  const Colours& c = coloursOf(option.widget);
  const bool isSelected = (option.state & QStyle::State_Selected) != 0;
  const QRectF cell = QRectF(option.rect).adjusted(kPad, 0, -kPad, 0);
  switch (index.column()) {
    case DeviceModel::DeviceColumn: paintDevice(p, c, cell, index, option); break;
    case DeviceModel::HealthColumn:
      paintHealth(p, c, QRectF(option.rect), index, isSelected, leftOfRow(option) + kPad);
      break;
    default: paintNumber(p, c, cell, index, isSelected); break;
  }
  p.restore();
}

void DeviceDelegate::paintDevice(QPainter& p, const Colours& c, const QRectF& cell, const QModelIndex& index,
                                 const QStyleOptionViewItem& option) const {
  const bool isSelected = (option.state & QStyle::State_Selected) != 0;
  const QFontMetricsF metrics(option.font);
  const QFont small = secondaryFont(option.font);
  const QFontMetricsF smallMetrics(small);
  const double middle = cell.center().y();
  p.setFont(option.font);
  p.setPen(isSelected ? c.accent.onFill : c.text);
  p.drawText(QPointF(cell.left(), middle - 4), elidedPin(index.data().toString(), metrics, cell.width()));
  p.setFont(small);
  p.setPen(isSelected ? c.accent.onFill : c.textSecondary);
  // On to the words of the health: under the numbers between there is nothing.
  double right = cell.right();
  if (const auto* view = qobject_cast<const QTreeView*>(option.widget)) {
    const int column = DeviceModel::HealthColumn;
    right = rightOfWords(small, view->columnViewportPosition(column) + view->columnWidth(column) - kPad);
    right -= smallMetrics.horizontalAdvance(wordsOf(index, smallMetrics, right - cell.left())) + kPad;
  }
  p.drawText(QPointF(cell.left(), middle + 4 + smallMetrics.ascent()),
             smallMetrics.elidedText(index.data(DeviceModel::DetailRole).toString(), Qt::ElideRight,
                                     right - cell.left()));
}

// The sign in its column; under it the age, before that the words, which begin under the columns before.
void DeviceDelegate::paintHealth(QPainter& p, const Colours& c, const QRectF& cell, const QModelIndex& index,
                                 bool isSelected, double left) const {
  const auto severity = static_cast<Severity>(index.data(DeviceModel::HealthRole).toInt());
  const QColor ink = isSelected ? c.accent.onFill : inkOf(c, inkOf(severity));
  const double middle = cell.center().y();
  const double x = cell.center().x();
  drawGlyph(p, QRectF(x - kGlyph / 2, middle - 3 - kGlyph, kGlyph, kGlyph), healthGlyph(severity), ink,
            Qt::transparent, c.stroke);
  const QFont small = secondaryFont(p.font());
  const QFontMetricsF metrics(small);
  const double baseline = middle + 4 + metrics.ascent();
  const double right = rightOfWords(small, cell.right() - kPad);
  const QString words = wordsOf(index, metrics, right - left);
  p.setFont(small);
  p.setPen(ink);
  p.drawText(QPointF(right - metrics.horizontalAdvance(words), baseline), words);
  const QColor ageInk = isSelected ? c.accent.onFill : c.textSecondary;
  const QString age = index.siblingAtColumn(DeviceModel::AgeColumn).data().toString();
  const QRectF slot(right, baseline - metrics.capHeight(), cell.right() - kPad - right, metrics.capHeight());
  drawFigures(p, slot, {age, {}, small, small, ageInk, ageInk});
}

void DeviceDelegate::paintNumber(QPainter& p, const Colours& c, const QRectF& cell, const QModelIndex& index,
                                 bool isSelected) const {
  const QFontMetricsF metrics(p.font());
  const bool isSecondary = index.column() != DeviceModel::AddressColumn;
  const QColor ink = isSelected ? c.accent.onFill : isSecondary ? c.textSecondary : c.text;
  // On the line of the device's name.
  const double baseline = cell.center().y() - 4;
  const QRectF slot(cell.left(), baseline - metrics.capHeight(), cell.width(), metrics.capHeight());
  drawFigures(p, slot, {index.data().toString(), {}, p.font(), p.font(), ink, ink});
}

}  // namespace deckpipe
