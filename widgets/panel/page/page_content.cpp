// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/page/page_content.h"

#include <QCoreApplication>
#include <QEvent>
#include <algorithm>

namespace deckpipe {
namespace {

constexpr int kPageMargin = 16;
constexpr int kTightMargin = 8;  // above and below the dial where height is short
constexpr int kTightRoom = 420;
constexpr int kReasonGap = 8;    // between the dial and what is wrong
constexpr int kPartGap = 16;     // between parts under one another
constexpr int kSideGap = 24;     // between the dial and what stands beside it
constexpr int kFactGap = 32;     // between columns of facts
constexpr int kFactWidth = 288;  // the least that a column of facts is read in
constexpr int kNarrow = 740;     // below this, one column
constexpr int kWideDial = 480;   // both drawings with their limits
constexpr int kMinBeside = 480;  // two columns of switches

int heightOf(const QWidget& part, int width) {
  return part.hasHeightForWidth() ? part.heightForWidth(width) : part.sizeHint().height();
}

// Under one another from `top`; returns where the last one ends.
template <typename Take>
int stack(const std::vector<QWidget*>& parts, int left, int top, int width, Take take) {
  int y = top;
  for (QWidget* part : parts) {
    if (y != top) y += kPartGap;
    const int height = heightOf(*part, width);
    take(part, QRect(left, y, width, height));
    y += height;
  }
  return y;
}

}  // namespace

PageContent::PageContent(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("pageContent"));
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::Base);
  QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Preferred);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
}

void PageContent::setParts(const Parts& parts) {
  if (parts == m_parts) return;
  m_parts = parts;
  int height = 0;
  const std::vector<Place> used = places(width(), height);
  for (QObject* child : children()) {
    auto* part = qobject_cast<QWidget*>(child);
    if (part != nullptr) part->setVisible(std::ranges::find(used, part, &Place::part) != used.end());
  }
  updateGeometry();
  arrange();
}

void PageContent::setRoom(int height) {
  if (height == m_room) return;
  m_room = height;
  updateGeometry();
  arrange();
}

std::vector<PageContent::Place> PageContent::places(int width, int& height) const {
  std::vector<Place> all;
  const auto take = [&](QWidget* part, const QRect& rect) { all.push_back({part, rect}); };
  const int inner = std::max(0, width - 2 * kPageMargin);
  const bool isWide = width >= kNarrow;
  const int top = m_parts.dial != nullptr && m_room < kTightRoom ? kTightMargin : kPageMargin;
  int y = top;
  // At `at`, if the page has them; returns where they end.
  const auto takeReasons = [&](int at, int reasonsWidth) {
    if (m_parts.reasons == nullptr) return at;
    const int reasonsHeight = heightOf(*m_parts.reasons, reasonsWidth);
    take(m_parts.reasons, QRect(kPageMargin, at, reasonsWidth, reasonsHeight));
    return at + reasonsHeight;
  };
  if (m_parts.dial == nullptr && m_parts.reasons != nullptr) y = takeReasons(y, inner) + kPartGap;

  if (m_parts.dial != nullptr || !m_parts.sticks.empty()) {
    int mainWidth = 0, mainHeight = 0;
    if (m_parts.dial != nullptr) {
      // No wider than its height can use: the words beside it need the room.
      const int usable = std::max(kWideDial, (m_room - 2 * top) * 7 / 4);
      mainWidth = isWide ? std::min(inner * 5 / 9, usable) : inner;
      // All of the room that is seen without scrolling, but for what is wrong.
      const int said =
          m_parts.reasons == nullptr ? 0 : kReasonGap + m_parts.reasons->minimumSizeHint().height();
      const int least = m_parts.dial->minimumSizeHint().height();
      mainHeight = std::clamp(m_room - 2 * top - said, least, std::max(least, mainWidth * 11 / 16));
      take(m_parts.dial, QRect(kPageMargin, y, mainWidth, mainHeight));
      mainHeight = takeReasons(y + mainHeight + kReasonGap, mainWidth) - y;
    } else {
      placeSticks(inner, y, mainWidth, mainHeight, take);
    }
    const int besideLeft = isWide ? kPageMargin + mainWidth + kSideGap : kPageMargin;
    const int besideWidth = isWide ? inner - mainWidth - kSideGap : inner;
    const int besideTop = isWide ? y : y + mainHeight + kPartGap;
    const int besideEnd = stack(m_parts.beside, besideLeft, besideTop, besideWidth, take);
    y = std::max(y + mainHeight, besideEnd) + kPartGap;
  }
  if (!m_parts.below.empty()) y = stack(m_parts.below, kPageMargin, y, inner, take) + kPartGap;

  const int count = static_cast<int>(m_parts.facts.size());
  const int fitting = std::max(1, (inner + kFactGap) / (kFactWidth + kFactGap));
  const int rows = (count + fitting - 1) / fitting;
  const int columns = rows == 0 ? 1 : (count + rows - 1) / rows;  // four are two and two, not three and one
  const int factWidth = (inner - (columns - 1) * kFactGap) / columns;
  for (int first = 0; first < count; first += columns) {
    int highest = 0;
    for (int i = first; i < std::min(count, first + columns); ++i) {
      QWidget* part = m_parts.facts[static_cast<std::size_t>(i)];
      const int factHeight = heightOf(*part, factWidth);
      take(part, QRect(kPageMargin + (i - first) * (factWidth + kFactGap), y, factWidth, factHeight));
      highest = std::max(highest, factHeight);
    }
    y += highest + kPartGap;
  }
  height = y - kPartGap + kPageMargin;
  return all;
}

void PageContent::placeSticks(int inner, int top, int& width, int& height, const Take& take) const {
  const int count = static_cast<int>(m_parts.sticks.size());
  const auto rowWidth = [](int n, int each) { return n * each + (n - 1) * kSideGap; };
  const int each = m_parts.sticks.front()->minimumWidth();  // fixed
  const bool isRow = rowWidth(count, each) + kSideGap + kMinBeside <= inner;
  width = isRow ? rowWidth(count, each) : std::min(inner, each);
  height = 0;
  int left = kPageMargin, y = top;
  for (QWidget* stick : m_parts.sticks) {
    const int stickHeight = stick->sizeHint().height();
    take(stick, QRect(left, y, each, stickHeight));
    if (isRow) {
      left += each + kSideGap;
      height = std::max(height, stickHeight);
    } else {
      y += stickHeight + kPartGap;
      height = y - kPartGap - top;
    }
  }
}

int PageContent::heightForWidth(int width) const {
  int height = 0;
  places(width, height);
  return height;
}

QSize PageContent::sizeHint() const { return {1000, heightForWidth(1000)}; }

void PageContent::arrange() {
  int height = 0;
  for (const Place& place : places(width(), height)) place.part->setGeometry(place.rect);
}

bool PageContent::event(QEvent* event) {
  if (event->type() == QEvent::LayoutRequest) {  // a part wants another size
    updateGeometry();                            // tells the scroll area
    arrange();
  }
  return QWidget::event(event);
}

// Parts that changed while nothing was visible told nobody.
void PageContent::showEvent(QShowEvent*) {
  QCoreApplication::postEvent(this, new QEvent(QEvent::LayoutRequest));
}

void PageContent::resizeEvent(QResizeEvent*) { arrange(); }

}  // namespace deckpipe
