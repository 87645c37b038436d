// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/trace/trace_bar.h"

#include <QCheckBox>
#include <QEvent>
#include <QLocale>
#include <QMenu>
#include <QSignalBlocker>
#include <QTabBar>
#include <QToolButton>

#include "model/filter_keys.h"
#include "model/trace_model.h"
#include "paint/app_style.h"
#include "panel/common/build.h"
#include "panel/common/labels.h"
#include "panel/trace/trace_filter_edit.h"

namespace deckpipe {
namespace {

constexpr int kMinFilter = 240;
constexpr int kMargin = 8, kSpacing = 8;

}  // namespace

TraceBar::TraceBar(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("traceBar"));
  m_filter = new TraceFilterEdit(this);
  makeHelp();
  m_find = makeToolButton(this, "traceFind", tr("Find"), tr("Find in the rows (Ctrl+F)"));
  connect(m_find, &QToolButton::clicked, this, &TraceBar::findRequested);
  m_count = new ElidedLabel(this);
  m_count->setObjectName(QStringLiteral("traceCount"));
  setInk(*m_count, Ink::Secondary);
  measureCount();
  m_time = named(new QComboBox(this), "traceTime", tr("How the Time column says time"));
  m_time->setToolTip(m_time->accessibleName());
  for (int mode = 0; mode < static_cast<int>(TraceModel::TimeMode::Count); ++mode)
    m_time->addItem(TraceModel::modeText(static_cast<TraceModel::TimeMode>(mode)));
  connect(m_time, &QComboBox::activated, this, &TraceBar::timeModeChosen);
  m_follow = new QCheckBox(this);
  m_follow->setObjectName(QStringLiteral("traceFollow"));
  m_follow->setText(tr("Follow"));
  m_follow->setAccessibleName(tr("Follow the end of the log"));
  m_follow->setToolTip(m_follow->accessibleName());
  connect(m_follow, &QAbstractButton::toggled, this, &TraceBar::followToggled);
  m_order = named(new QTabBar(this), "traceOrder", tr("Rows of the trace"));
  m_order->setExpanding(false);
  m_order->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  m_order->setDrawBase(false);
  m_order->addTab(tr("In order"));
  m_order->addTab(tr("By ID"));
  m_order->setTabToolTip(InOrder, tr("Every frame, as it came"));
  m_order->setTabToolTip(ById, tr("The last frame of each identifier, how often and how regular it comes"));
  connect(m_order, &QTabBar::currentChanged, this, [this](int order) {
    fit();
    Q_EMIT orderChosen(order);
  });
  inRow(this, {kMargin, 4, kMargin, 4}, kSpacing,
        {m_order, {m_filter, 1}, m_help, m_find, m_count, m_time, m_follow});
}

void TraceBar::measureCount() {
  const QString many = QLocale().toString(10'000'000);
  m_count->setMinimumWidth(fontMetrics().horizontalAdvance(tr("%1 of %2").arg(many, many)));
}

void TraceBar::fit() {
  int room = width() - 2 * kMargin - m_order->sizeHint().width() - kSpacing - kMinFilter - kSpacing -
             m_help->sizeHint().width() - kSpacing - m_find->sizeHint().width();
  const auto show = [&room](QWidget* widget, int wanted) {
    room -= kSpacing + wanted;
    widget->setVisible(room >= 0);
  };
  const bool isInOrder = m_order->currentIndex() == InOrder;
  if (isInOrder) {
    show(m_follow, m_follow->sizeHint().width());
    show(m_time, m_time->sizeHint().width());
  } else {  // they are about frames one by one
    m_follow->hide();
    m_time->hide();
  }
  show(m_count, m_count->minimumWidth());
}

QSize TraceBar::minimumSizeHint() const {
  return {2 * kMargin + m_order->sizeHint().width() + kSpacing + kMinFilter,
          QWidget::minimumSizeHint().height()};
}

void TraceBar::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fit();
}

void TraceBar::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() != QEvent::FontChange) return;
  measureCount();
  fit();
}

void TraceBar::makeHelp() {
  m_help = new QToolButton(this);
  m_help->setObjectName(QStringLiteral("traceFilterHelp"));
  m_help->setText(QStringLiteral("?"));
  m_help->setAccessibleName(tr("How filters are written"));
  m_help->setMinimumWidth(32);
  m_help->setToolTip(filterHelp());
  m_help->setPopupMode(QToolButton::InstantPopup);
  auto* examples = new QMenu(m_help);
  for (const char* example : {"pgn=EF00 and sa=80", "type=01,83", "name~\"soft limits\"", "rotation_deg>30",
                              "data~\"01 1D\"", "dir=tx", "malformed or err", "t>=10 and t<20"}) {
    const QString text = QLatin1String(example);
    examples->addAction(text, m_filter, [this, text] { m_filter->setExpression(text); });
  }
  m_help->setMenu(examples);
}

void TraceBar::setOrder(int order) { m_order->setCurrentIndex(order); }

void TraceBar::setTimeMode(int mode) {
  const QSignalBlocker blocker(m_time);
  m_time->setCurrentIndex(mode);
}

void TraceBar::setFollowing(bool isFollowing) { m_follow->setChecked(isFollowing); }

void TraceBar::setCount(const QString& text) { setText(*m_count, text); }

}  // namespace deckpipe
