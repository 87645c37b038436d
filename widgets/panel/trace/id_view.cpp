// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/trace/id_view.h"

#include <QKeyEvent>
#include <QPainter>
#include <QSortFilterProxyModel>
#include <QStyledItemDelegate>
#include <algorithm>
#include <utility>

#include "paint/app_style.h"
#include "panel/common/build.h"
#include "panel/common/flat_header.h"

namespace deckpipe {
namespace {

constexpr int kMinIdRow = 24;

// What a column must hold without being cut; Name holds what it can, Decoded has what is left.
constexpr std::pair<IdModel::Column, const char*> kWidest[] = {
    {IdModel::ChannelName, "Channel ▲"},
    {IdModel::Identifier, "18EFFF80"},
    {IdModel::Ends, "From→To ▲"},
    {IdModel::Name, "Malformed: Position / lim"},
    {IdModel::Count, "99,999,999"},
    {IdModel::Period, "1,000.0 ms"},
    {IdModel::Jitter, "±1,000.0 ms"},
    {IdModel::Age, "00 min 00"},
    {IdModel::Data, "00 00 00 00 00 00 00 00"},
};

bool isFigures(int column) {
  return column == IdModel::Identifier || column == IdModel::Count || column == IdModel::Period ||
         column == IdModel::Jitter || column == IdModel::Data;
}

// Bytes that changed are bold and underlined: colour would not be seen by everybody, nor in the sun.
class IdDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const Colours& colours = coloursOf(option.widget);
    const bool isSelected = (option.state & QStyle::State_Selected) != 0;
    painter->fillRect(option.rect, isSelected             ? colours.accent.fill
                                   : index.row() % 2 != 0 ? colours.surfaceAlternate
                                                          : colours.surface);
    const QRect area = option.rect.adjusted(FlatHeader::kPadding, 0, -FlatHeader::kPadding, 0);
    const QFont font = isFigures(index.column()) ? figureFont(option.font) : option.font;
    const QString text = index.data().toString();
    const bool isPlain = index.column() == IdModel::Name || index.column() == IdModel::Decoded ||
                         index.column() == IdModel::Identifier || index.column() == IdModel::Data;
    painter->setPen(isSelected ? colours.accent.onFill : isPlain ? colours.text : colours.textSecondary);
    painter->setFont(font);
    const unsigned changed = index.column() == IdModel::Data ? index.data(IdModel::ChangedRole).toUInt() : 0;
    if (changed != 0) {
      paintBytes(*painter, area, font, text, changed);
      return;
    }
    const auto alignment = index.data(Qt::TextAlignmentRole).value<Qt::Alignment>();
    painter->drawText(area, static_cast<int>(alignment) | Qt::TextSingleLine,
                      QFontMetrics(font).elidedText(text, Qt::ElideRight, area.width()));
  }

 private:
  static void paintBytes(QPainter& painter, const QRect& area, const QFont& font, const QString& text,
                         unsigned changed) {
    QFont bold = font;
    bold.setBold(true);
    bold.setUnderline(true);
    const double digit = QFontMetricsF(font).horizontalAdvance(u'0');
    const QFontMetrics metrics(font);
    const double baseline = area.top() + (area.height() - metrics.height()) / 2.0 + metrics.ascent();
    painter.save();
    painter.setClipRect(area);
    for (int byte = 0; 3 * byte + 1 < text.size(); ++byte) {
      painter.setFont((changed >> byte & 1u) != 0 ? bold : font);
      painter.drawText(QPointF(area.left() + 3 * byte * digit, baseline), text.mid(3 * byte, 2));
    }
    painter.restore();
  }
};

}  // namespace

IdView::IdView(QWidget* parent)
    : QTableView(parent), m_rows(new IdModel(this)), m_sorted(new QSortFilterProxyModel(this)) {
  named(this, "traceById", tr("Traffic by identifier"));
  setWhatsThis(tr(
      "One row for each identifier up to the cursor: how many frames, how regular, and the last of them; "
      "bytes that changed are bold and underlined. With a filter only what passes it is counted. Enter or a "
      "double click shows a row's frames in order. A right click on the titles chooses the columns."));
  m_sorted->setSourceModel(m_rows);
  m_sorted->setSortRole(IdModel::SortRole);
  m_sorted->setSortCaseSensitivity(Qt::CaseInsensitive);
  setModel(m_sorted);
  setItemDelegate(new IdDelegate(this));
  makeFlat(*this);
  verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  m_header = named(new FlatHeader(this), "traceByIdHeader", tr("Columns of the traffic by identifier"));
  setHorizontalHeader(m_header);
  m_header->setSectionsClickable(true);
  setSortingEnabled(true);
  sortByColumn(IdModel::Identifier, Qt::AscendingOrder);
  m_header->setSectionsMovable(true);
  updateFonts();
  m_header->setStretchLastSection(true);
  connect(selectionModel(), &QItemSelectionModel::currentRowChanged, this, &IdView::tellCurrent);
  connect(this, &QAbstractItemView::doubleClicked, this, [this](const QModelIndex& index) {
    Q_EMIT filterRequested(index.data(IdModel::FilterRole).toString());
  });
}

void IdView::updateFonts() {
  const QFontMetrics figures(figureFont(font())), words(font());
  verticalHeader()->setDefaultSectionSize(
      denseRowHeight(this, std::max({kMinIdRow, figures.height() + 6, words.height() + 6})));
  QList<int> widths;
  for (const auto& [column, widest] : kWidest) {
    const QFontMetrics& metrics = isFigures(column) ? figures : words;
    widths.push_back(metrics.horizontalAdvance(QString::fromUtf8(widest)) + 2 * FlatHeader::kPadding + 4);
  }
  m_header->setUsualWidths(widths);
}

void IdView::changeEvent(QEvent* event) {
  QTableView::changeEvent(event);
  const bool isOtherLook = event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange;
  if (isOtherLook && m_header != nullptr) updateFonts();
}

QByteArray IdView::saveState() const { return m_header->saveColumns(); }

bool IdView::restoreState(const QByteArray& state) { return m_header->restoreColumns(state); }

void IdView::resetColumns() {
  m_header->showUsual();
  sortByColumn(IdModel::Identifier, Qt::AscendingOrder);
}

void IdView::setView(const LogView& view) {
  m_rows->setView(view);
  tellCurrent();
}

std::optional<std::uint64_t> IdView::currentFrame() const {
  const QModelIndex current = currentIndex();
  return current.isValid() ? std::optional<std::uint64_t>(current.data(IdModel::FrameRole).toULongLong())
                           : std::nullopt;
}

void IdView::tellCurrent() {
  const auto now = currentFrame();
  if (now == m_told || !isVisible()) return;
  m_told = now;
  Q_EMIT currentFrameChanged(now);
}

void IdView::keyPressEvent(QKeyEvent* event) {
  const bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (isEnter && currentIndex().isValid()) {
    Q_EMIT filterRequested(currentIndex().data(IdModel::FilterRole).toString());
    return;
  }
  if (event->key() == Qt::Key_Space) {
    if (currentIndex().isValid()) Q_EMIT detailRequested();
    return;
  }
  QTableView::keyPressEvent(event);
}

}  // namespace deckpipe
