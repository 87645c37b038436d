// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/trace/decode_panel.h"

#include <QBoxLayout>
#include <QEvent>
#include <QHeaderView>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QTableView>
#include <QToolButton>
#include <algorithm>

#include "model/decode_model.h"
#include "paint/app_style.h"
#include "paint/payload_bits.h"
#include "panel/common/build.h"
#include "panel/common/flat_header.h"

namespace deckpipe {
namespace {

DecodeRow::Line lineOf(const QModelIndex& index) {
  return static_cast<DecodeRow::Line>(index.data(DecodeModel::KindRole).toInt());
}

QFont fontOf(const QFont& base, const QModelIndex& index) {
  QFont font = base;
  if (index.column() == DecodeModel::Raw) {
    font = figureFont(base);
  } else if (index.column() == DecodeModel::Value && lineOf(index) == DecodeRow::Line::Title) {
    font.setBold(true);
  }
  return font;
}

QColor inkFor(const QModelIndex& index, const Colours& c) {
  if (lineOf(index) == DecodeRow::Line::Certainty) return c.warning.ink;
  const bool isValue = index.column() == DecodeModel::Name || index.column() == DecodeModel::Value;
  if (!isValue) return c.textSecondary;
  if (index.data(DecodeModel::QuietRole).toBool()) return c.stale.ink;
  const bool isField = lineOf(index) == DecodeRow::Line::Field;
  return index.column() == DecodeModel::Name && !isField ? c.textSecondary : c.text;
}

constexpr int kWide = 820;  // from here on, or up to this height, bits and fields stand side by side
constexpr int kTall = 320;
constexpr int kRow = 24;
constexpr int kMinValue = 120, kMaxValue = 320;

}  // namespace

// How rows of the decode detail are drawn: what is off or has no value lighter, the message's name bold, bits
// in figures that stand under one another, a doubt in the colour of what wants attention, a frame around the
// row whose bits are pointed at.
class DecodeDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  // -1: none.
  void setPointedRow(int row) { m_pointed = row; }

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const Colours& c = coloursOf(option.widget);
    const bool isSelected = (option.state & QStyle::State_Selected) != 0;
    const QColor ground = index.row() % 2 != 0 ? c.surfaceAlternate : c.surface;
    painter->fillRect(option.rect, isSelected ? c.accent.fill : ground);
    if (index.row() == m_pointed && !isSelected) {
      // Lines above and below each cell make one frame of the row.
      for (const int y : {option.rect.top(), option.rect.bottom() - 1})
        painter->fillRect(option.rect.left(), y, option.rect.width(), 2, c.accent.ink);
    }
    const QFont font = fontOf(option.font, index);
    const QRect area = option.rect.adjusted(FlatHeader::kPadding, 0, -FlatHeader::kPadding, 0);
    const QString text = index.data().toString();
    const QFontMetrics metrics(font);
    const bool isSentence = lineOf(index) == DecodeRow::Line::Certainty;
    painter->setFont(font);
    painter->setPen(isSelected ? c.accent.onFill : inkFor(index, c));
    painter->drawText(area,
                      Qt::AlignLeft | Qt::AlignVCenter | (isSentence ? Qt::TextWordWrap : Qt::TextSingleLine),
                      isSentence ? text : metrics.elidedText(text, Qt::ElideRight, area.width()));
  }

 private:
  int m_pointed = -1;
};

DecodePanel::DecodePanel(QWidget* parent) : QWidget(parent) {
  named(this, "decodePanel", tr("Frame in detail"));
  m_delegate = new DecodeDelegate(this);
  m_list = named(new QTableView(this), "decodeFields", tr("Fields of the frame"));
  m_list->setWhatsThis(tr("The frame field by field, with the raw bits of each and where they stand."));
  m_list->setItemDelegate(m_delegate);
  makeFlat(*m_list);
  m_list->viewport()->installEventFilter(this);
  m_list->setMouseTracking(true);
  m_header = new FlatHeader(m_list);
  m_header->setObjectName(QStringLiteral("decodeHeader"));
  m_header->setMinimumSectionSize(48);
  m_list->setHorizontalHeader(m_header);
  m_layout = new QBoxLayout(QBoxLayout::LeftToRight, this);  // the less height
  m_layout->setContentsMargins(0, 0, 0, 0);
  m_layout->setSpacing(0);
  m_around = new QWidget(this);
  m_payload = new PayloadBits(m_around);
  inColumn(m_around, {8, 8, 8, 8}, -1, {m_payload, LayoutPart::rest()});
  m_layout->addWidget(m_list, 1);
  m_layout->addWidget(m_around);
  m_around->hide();
  // In the row of the titles, where it takes no room.
  m_fold = makeToolButton(m_list, "decodeBits", tr("Bits"),
                          tr("The frame bit by bit, and where each field stands"));
  m_fold->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  m_fold->setCheckable(true);
  connect(m_fold, &QAbstractButton::toggled, this, &DecodePanel::showBits);
  m_model = new DecodeModel(this);
  m_list->setModel(m_model);
  m_header->setSectionResizeMode(QHeaderView::Interactive);
  layOut();
  connect(m_model, &QAbstractItemModel::modelReset, this, [this] { point(-1); });
  connect(m_model, &DecodeModel::frameChanged, this, &DecodePanel::showFrame);
  connect(m_list->selectionModel(), &QItemSelectionModel::currentRowChanged, this, &DecodePanel::tellBits);
  showFrame();
  connect(m_payload, &PayloadBits::bitPicked, this, &DecodePanel::pick);
  connect(m_payload, &PayloadBits::bitPointed, this,
          [this](std::uint64_t bit) { point(bit == 0 ? -1 : m_model->rowOfBit(bit)); });
  connect(m_list, &QAbstractItemView::entered, this,
          [this](const QModelIndex& index) { point(index.row()); });
  connect(m_list, &QAbstractItemView::viewportEntered, this, [this] { point(-1); });
}

void DecodePanel::setView(const PanelView& view) {
  m_model->setView(view.log);
  m_model->setFrame(view.frame);
}

bool DecodePanel::areBitsShown() const { return m_fold->isChecked(); }

void DecodePanel::showBits(bool areShown) {
  m_fold->setChecked(areShown);
  m_around->setVisible(areShown);
  layOut();
}

// Once more with each look.
void DecodePanel::layOut() {
  m_rowHeight = denseRowHeight(this, std::max(kRow, fontMetrics().height() + 6));
  m_list->verticalHeader()->setMinimumSectionSize(m_rowHeight);
  m_list->verticalHeader()->setDefaultSectionSize(m_rowHeight);
  m_header->setFixedHeight(targetHeight(this));
  m_fold->setArrowType(areBitsShown() ? Qt::DownArrow : Qt::RightArrow);
  shareWidth();
  showFrame();
}

void DecodePanel::showFrame() {
  m_list->clearSpans();
  for (int row = 0; row < m_model->rowCount(); ++row) {
    const auto line =
        static_cast<DecodeRow::Line>(m_model->index(row, 0).data(DecodeModel::KindRole).toInt());
    const bool isSentence = line == DecodeRow::Line::Title || line == DecodeRow::Line::Certainty;
    if (isSentence)
      m_list->setSpan(row, DecodeModel::Value, 1, DecodeModel::ColumnCount - DecodeModel::Value);
    if (line == DecodeRow::Line::Certainty) m_list->setRowHeight(row, std::max(2 * kRow, m_rowHeight));
  }
  tellBits();
}

void DecodePanel::tellBits() {
  PayloadValues values;
  if (const Frame* frame = m_model->content()) {
    values.bytes = frame->data;
    values.length = static_cast<int>(frame->bytes().size());
  }
  for (int row = 0; row < m_model->rowCount(); ++row) {
    if (const auto bits = m_model->index(row, 0).data(DecodeModel::BitsRole).toULongLong(); bits != 0)
      values.fields.push_back(bits);
  }
  const QModelIndex current = m_list->currentIndex();
  if (current.isValid()) values.selected = current.data(DecodeModel::BitsRole).toULongLong();
  const QModelIndex pointed = m_model->index(m_pointed, 0);
  if (pointed.isValid()) values.pointed = pointed.data(DecodeModel::BitsRole).toULongLong();
  values.related = (values.pointed != 0 ? pointed : current).data(DecodeModel::SignBitsRole).toULongLong();
  m_payload->setValues(values);
}

void DecodePanel::pick(std::uint64_t bit) {
  const int row = m_model->rowOfBit(bit);
  if (row >= 0) m_list->setCurrentIndex(m_model->index(row, 0));
}

void DecodePanel::point(int row) {
  if (row == m_pointed) return;
  m_pointed = row;
  m_delegate->setPointedRow(row);
  m_list->viewport()->update();
  tellBits();
}

// Values get what is left, but no more than they need: what they are made of should stand beside them. Where
// there is little room the raw bits go first, for they are drawn, too. With the bits folded the values have it all.
void DecodePanel::shareWidth() {
  const QSize fold = m_fold->sizeHint();
  m_fold->setGeometry(m_list->viewport()->width() - fold.width(), 0, fold.width(), m_header->height());
  const auto widthOf = [this](const QString& text) {
    return fontMetrics().horizontalAdvance(text) + 2 * FlatHeader::kPadding + 4;
  };
  const int all = m_list->viewport()->width();
  const int name = widthOf(QStringLiteral("Axis 5 (+) hard stop"));
  const int place = widthOf(QStringLiteral("B1.8–7, B2"));
  int raw = widthOf(QStringLiteral("0000 0000 0000 0000 0"));
  m_list->setColumnHidden(DecodeModel::Place, !areBitsShown());
  if (!areBitsShown()) {
    m_list->setColumnHidden(DecodeModel::Raw, true);
    m_header->resizeSection(DecodeModel::Name, name);
    m_header->resizeSection(DecodeModel::Value, std::max(kMinValue, all - name));
    return;
  }
  const bool hasRaw = all >= name + raw + place + kMinValue;
  m_list->setColumnHidden(DecodeModel::Raw, !hasRaw);
  if (!hasRaw) raw = 0;
  const int value = std::clamp(all - name - raw - place, kMinValue, kMaxValue);
  m_header->resizeSection(DecodeModel::Name, name);
  m_header->resizeSection(DecodeModel::Value, value);
  if (hasRaw) m_header->resizeSection(DecodeModel::Raw, raw);
  m_header->resizeSection(DecodeModel::Place, std::max(place, all - name - value - raw));
}

void DecodePanel::resizeEvent(QResizeEvent* event) {
  m_layout->setDirection(width() >= kWide || height() < kTall ? QBoxLayout::LeftToRight
                                                              : QBoxLayout::TopToBottom);
  QWidget::resizeEvent(event);
}

void DecodePanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) layOut();
}

bool DecodePanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched == m_list->viewport() && event->type() == QEvent::Resize) shareWidth();
  if (watched == m_list->viewport() && event->type() == QEvent::Leave) point(-1);
  if (watched == m_list->viewport() && event->type() == QEvent::Paint && (m_model->rowCount() == 0)) {
    QPainter p(m_list->viewport());
    const Colours& c = coloursOf(m_list);
    p.fillRect(m_list->viewport()->rect(), c.surface);
    p.setPen(c.textSecondary);
    p.drawText(m_list->viewport()->rect(), Qt::AlignCenter, tr("No frame selected"));
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

void DecodePanel::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.fillRect(rect(), coloursOf(this).window);
}

}  // namespace deckpipe
