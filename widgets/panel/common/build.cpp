// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/common/build.h"

#include <QAction>
#include <QFontDatabase>
#include <QFontInfo>
#include <QHeaderView>
#include <QKeyEvent>
#include <QPushButton>
#include <QScrollArea>
#include <QTableView>
#include <QToolButton>
#include <QTreeView>
#include <algorithm>
#include <cmath>

#include "paint/app_style.h"
#include "paint/figures.h"
#include "text/time_text.h"

namespace deckpipe {
namespace {

template <typename Layout>
Layout* filled(Layout* layout, const QMargins& margins, int spacing, LayoutParts parts) {
  layout->setContentsMargins(margins);
  layout->setSpacing(spacing);
  for (const LayoutPart& part : parts) {
    if (part.widget != nullptr) {
      layout->addWidget(part.widget, part.share, part.alignment);
    } else if (part.layout != nullptr) {
      layout->addLayout(part.layout, part.share);
    } else if (part.share > 0) {
      layout->addStretch(part.share);
    } else {
      layout->addSpacing(part.gapPixels);
    }
  }
  return layout;
}

void makeFlatView(QAbstractItemView& view) {
  view.setSelectionBehavior(QAbstractItemView::SelectRows);
  view.setSelectionMode(QAbstractItemView::SingleSelection);
  view.setEditTriggers(QAbstractItemView::NoEditTriggers);
  view.setFrameShape(QFrame::NoFrame);
}

}  // namespace

QFont strongFont(const QFont& font, double size) {
  QFont strong = font;
  if (size != 1) strong.setPointSizeF(font.pointSizeF() * size);
  strong.setWeight(QFont::DemiBold);
  return strong;
}

int widestAge(const QFont& font) {
  double width = 0;
  for (const Duration longest :
       {Duration(500ms), Duration(99s), Duration(59min + 59s), Duration(47h + 59min), Duration(99 * 24h)})
    width = std::max(width, figuresWidth(font, calmAge(longest)));
  return static_cast<int>(std::ceil(width));
}

QFont boldFont(const QFont& font) {
  QFont bold = font;
  bold.setBold(true);
  return bold;
}

QFont secondaryFont(const QFont& font) {
  QFont smaller = font;
  smaller.setPixelSize(std::max(12, static_cast<int>(std::lround(QFontInfo(font).pixelSize() * 0.88))));
  smaller.setWeight(QFont::Normal);
  return smaller;
}

QFont figureFont(const QFont& font) {
  QFont figures = QFontDatabase::systemFont(QFontDatabase::FixedFont);
  figures.setPixelSize(QFontInfo(font).pixelSize());
  return figures;
}

QLabel* makeWords(QWidget* parent, const char* name, const QString& spoken, Ink ink) {
  auto* label = named(new QLabel(parent), name, spoken);
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  if (ink != Ink::Text) setInk(*label, ink);
  return label;
}

QLabel* makeMessage(QWidget* parent, const char* name, const QString& spoken, int margin) {
  auto* label = makeWords(parent, name, spoken, Ink::Secondary);
  label->setAlignment(Qt::AlignCenter);
  label->setMargin(margin);
  label->setAutoFillBackground(true);
  label->setBackgroundRole(QPalette::Base);
  return label;
}

QLabel* makeTitle(QWidget* parent, const char* name, const QString& text, double size) {
  auto* label = named(new QLabel(text, parent), name, text);
  label->setFont(strongFont(label->font(), size));
  return label;
}

QLabel* makeCommand(QWidget* parent, const char* name, const QString& spoken) {
  auto* label = makeWords(parent, name, spoken);
  label->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  return label;
}

QPushButton* makeButton(QWidget* parent, const char* name, const QString& text, const QString& spoken) {
  auto* button = named(new QPushButton(text, parent), name, spoken.isEmpty() ? text : spoken);
  button->setAutoDefault(true);  // Enter presses it, as Space does
  return button;
}

QToolButton* makeToolButton(QWidget* parent, const char* name, const QString& text, const QString& tip) {
  auto* button = named(new QToolButton(parent), name, tip);
  button->setText(text);
  button->setToolTip(tip);
  return button;
}

void offer(QAction& action, const QString& whyNot) {
  const QString& tip = whyNot.isEmpty() ? action.whatsThis() : whyNot;
  if (action.toolTip() != tip) action.setToolTip(tip);
  action.setEnabled(whyNot.isEmpty());
}

QPushButton* ExtraPage::makeDone(const char* name, const QString& spoken) {
  auto* done = makeButton(this, name, tr("Done"), spoken);
  connect(done, &QPushButton::clicked, this, &ExtraPage::closeRequested);
  return done;
}

void ExtraPage::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) {
    Q_EMIT closeRequested();
  } else {
    QWidget::keyPressEvent(event);
  }
}

void makeFlat(QTreeView& list) {
  makeFlatView(list);
  list.setRootIsDecorated(false);
  list.setItemsExpandable(false);
  list.setIndentation(0);
  list.setAllColumnsShowFocus(true);  // the ring is around a row
  list.setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
}

void makeFlat(QTableView& table) {
  makeFlatView(table);
  table.setTabKeyNavigation(false);
  table.setShowGrid(false);
  table.setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  table.setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
  table.verticalHeader()->hide();
}

QScrollArea* makeScroll(QWidget* parent, const char* name, QWidget* content) {
  auto* scroll = new QScrollArea(parent);
  scroll->setObjectName(QLatin1String(name));
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidgetResizable(true);
  scroll->setWidget(content);
  return scroll;
}

void fillScrolled(QWidget* page, QWidget* content, const char* name) {
  QScrollArea* scroll = makeScroll(page, name, content);
  scroll->setFocusPolicy(Qt::NoFocus);
  inColumn(page, {scroll});
}

QHBoxLayout* inRow(QWidget* owner, const QMargins& margins, int spacing, LayoutParts parts) {
  return filled(new QHBoxLayout(owner), margins, spacing, parts);
}
QHBoxLayout* inRow(QWidget* owner, LayoutParts parts) { return inRow(owner, {}, -1, parts); }
QHBoxLayout* inRow(int spacing, LayoutParts parts) { return inRow(nullptr, {}, spacing, parts); }
QHBoxLayout* inRow(LayoutParts parts) { return inRow(nullptr, {}, -1, parts); }

QVBoxLayout* inColumn(QWidget* owner, const QMargins& margins, int spacing, LayoutParts parts) {
  return filled(new QVBoxLayout(owner), margins, spacing, parts);
}
QVBoxLayout* inColumn(QWidget* owner, LayoutParts parts) { return inColumn(owner, {}, -1, parts); }
QVBoxLayout* inColumn(int spacing, LayoutParts parts) { return inColumn(nullptr, {}, spacing, parts); }

}  // namespace deckpipe
