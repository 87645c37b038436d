// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/common/notice_bar.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QPainter>
#include <QPushButton>
#include <QToolButton>
#include <QWidgetAction>

#include "paint/app_style.h"
#include "panel/common/build.h"
#include "panel/common/labels.h"

namespace deckpipe {
namespace {

constexpr int kWholeWidth = 560;  // of the unfolded text

QString actionText(Notice::Action action) {
  switch (action) {
    case Notice::Action::None: return {};
    case Notice::Action::GoToEnd: return NoticeBar::tr("Live");
    case Notice::Action::Reconnect: return NoticeBar::tr("Connect again");
    case Notice::Action::CopyDetails: return NoticeBar::tr("Copy the list");
    case Notice::Action::ShowRecordings: return NoticeBar::tr("Recordings…");
    case Notice::Action::AddUpTimes: return NoticeBar::tr("Add them up");
    case Notice::Action::ChangeBitRate: return NoticeBar::tr("Bit rate…");
  }
  return {};
}

}  // namespace

NoticeBar::NoticeBar(QWidget* parent)
    : QWidget(parent),
      m_sign(new GlyphLabel(this)),
      m_text(named(new ElidedLabel(this), "noticeText", tr("Notice"))),
      m_more(makeToolButton(this, "noticeMore", tr("More"), tr("The whole notice"))),
      m_whole(makeWords(this, "noticeWhole", tr("The whole notice"))),
      m_command(makeCommand(this, "noticeCommand", tr("Command for a terminal"))),
      m_copy(makeButton(this, "noticeCopy", tr("Copy"), tr("Copy the command"))),
      m_act(new QPushButton(this)),
      m_close(makeButton(this, "noticeClose", tr("Close"), tr("Close the notice"))) {
  named(this, "noticeBar", tr("Notice"));
  m_act->setObjectName(QStringLiteral("noticeAction"));
  inRow(this, {14, 2, 8, 2}, 8, {{m_sign, 0, Qt::AlignVCenter}, {m_text, 1}, m_more, m_act, m_close});

  auto* whole = new QWidget;
  m_whole->setMinimumWidth(kWholeWidth);
  m_whole->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  inColumn(whole, {16, 12, 16, 12}, 8, {m_whole, inRow(8, {{m_command, 1}, m_copy})});
  auto* menu = new QMenu(m_more);
  auto* part = new QWidgetAction(menu);
  part->setDefaultWidget(whole);
  menu->addAction(part);
  m_more->setMenu(menu);
  m_more->setPopupMode(QToolButton::InstantPopup);

  connect(m_copy, &QPushButton::clicked, this,
          [this] { QGuiApplication::clipboard()->setText(m_notice.command); });
  connect(m_act, &QPushButton::clicked, this, &NoticeBar::act);
  connect(m_close, &QPushButton::clicked, this, &NoticeBar::closeRequested);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  for (QWidget* kept : {static_cast<QWidget*>(this), static_cast<QWidget*>(m_more)}) {
    QSizePolicy policy = kept->sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    kept->setSizePolicy(policy);
    kept->hide();
  }
}

QSize NoticeBar::sizeHint() const { return {480, m_act->sizeHint().height() + 4}; }

void NoticeBar::setNotice(const Notice& notice) {
  if (notice == m_notice) return;
  m_notice = notice;
  setText(*m_text, notice.text);
  setText(*m_whole, notice.text);
  setText(*m_command, notice.command);
  m_command->setVisible(!notice.command.isEmpty());
  m_copy->setVisible(!notice.command.isEmpty());
  const QString action = actionText(notice.action);
  m_act->setText(action);
  m_act->setAccessibleName(action);
  m_act->setVisible(!action.isEmpty());
  m_close->setVisible(notice.canClose);
  setAccessibleDescription(notice.text);
  m_sign->setGlyph(glyphOf(notice.tone), inkOf(notice.tone));
  update();
  setVisible(!notice.text.isEmpty());
  if (notice.text.isEmpty()) m_more->menu()->close();
  offerMore();
}

void NoticeBar::offerMore() {
  layout()->activate();
  const bool fits = m_notice.command.isEmpty() && !m_notice.text.contains(QLatin1Char('\n')) &&
                    m_text->fontMetrics().horizontalAdvance(m_notice.text) <= m_text->width();
  m_more->setVisible(!fits);
}

void NoticeBar::resizeEvent(QResizeEvent*) { offerMore(); }

void NoticeBar::act() {
  if (m_notice.action == Notice::Action::CopyDetails) {
    QGuiApplication::clipboard()->setText(m_notice.details);
    return;
  }
  Q_EMIT actionRequested(m_notice.action);
}

// A bar at the left in the tone's colour, beside the sign that says the same.
void NoticeBar::paintEvent(QPaintEvent*) {
  const Colours& c = coloursOf(this);
  QPainter p(this);
  p.fillRect(rect(), c.surface);
  p.fillRect(QRect(0, 0, 6, height()), inkOf(c, inkOf(m_notice.tone)));
}

}  // namespace deckpipe
