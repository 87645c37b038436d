// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/page/page_header.h"

#include <QAbstractButton>
#include <QEvent>
#include <QGridLayout>
#include <QPainter>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "paint/app_style.h"
#include "paint/figures.h"
#include "panel/common/build.h"
#include "panel/common/health_look.h"
#include "panel/common/labels.h"
#include "text/time_text.h"

namespace deckpipe {
namespace {

constexpr int kRoomForTrace = 640;

}  // namespace

// The button that spreads a dial over the window, and takes it back: four corners, outwards or inwards. Used
// by PageHeader on a monitor's page and over the full dial.
class FullButton : public QAbstractButton {
 public:
  explicit FullButton(QWidget* parent) : QAbstractButton(parent) {
    setObjectName(QStringLiteral("fullButton"));
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setFocusPolicy(Qt::StrongFocus);
    setFull(false);
  }

  void setFull(bool isFull) {
    m_isFull = isFull;
    setAccessibleName(isFull ? PageHeader::tr("Back to the page") : PageHeader::tr("Large dial"));
    setToolTip(isFull ? PageHeader::tr("Back to the page (Esc)") : PageHeader::tr("Large dial (F11)"));
    update();
  }

  QSize sizeHint() const override { return {44, 44}; }
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent*) override {
    const Colours& c = coloursOf(this);
    QPainter p(this);
    p.setRenderHint(QPainter::Antialiasing);
    const QRectF box = QRectF(rect()).adjusted(2.5, 2.5, -2.5, -2.5);
    p.setPen(QPen(c.outline, 1));
    p.setBrush(isDown() ? c.surfaceAlternate : c.surface);
    p.drawRoundedRect(box, 6, 6);
    if (hasFocus()) drawFocusRing(p, c, rect());
    p.setPen(QPen(c.accent.ink, 2 * c.stroke, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    p.setBrush(Qt::NoBrush);
    const double arm = 6, far = 9;
    const QPointF middle = box.center();
    for (const double sx : {-1.0, 1.0}) {
      for (const double sy : {-1.0, 1.0}) {
        // Outwards the corner is far from the middle, inwards it is near it.
        const double corner = m_isFull ? far - arm : far, end = m_isFull ? far : far - arm;
        p.drawPolyline(QPolygonF{middle + QPointF(sx * end, sy * corner),
                                 middle + QPointF(sx * corner, sy * corner),
                                 middle + QPointF(sx * corner, sy * end)});
      }
    }
  }

 private:
  bool m_isFull = false;
};

PageHeader::PageHeader(QWidget* parent)
    : QWidget(parent),
      m_title(named(new QLabel(this), "pageTitle", tr("Device"))),
      m_type(named(new QLabel(this), "pageType", tr("Type"))),
      m_place(named(new ElidedLabel(this), "pageAddress", tr("Address"))),
      m_age(named(new QLabel(this), "pageAge", tr("Last heard"))),
      m_sign(new GlyphLabel(this)),
      m_word(named(new QLabel(this), "pageHealth", tr("Health"))),
      m_trace(named(new QToolButton(this), "traceButton", tr("Only this device in the trace"))),
      m_full(new FullButton(this)) {
  setObjectName(QStringLiteral("pageHeader"));
  m_title->setTextInteractionFlags(Qt::TextSelectableByMouse);
  for (QLabel* label : {m_type, m_place, m_age}) setInk(*label, Ink::Secondary);
  for (QLabel* label : {m_title, m_type}) {
    label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    label->installEventFilter(this);
  }

  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(16, 8, 16, 8);
  grid->setHorizontalSpacing(16);
  grid->setVerticalSpacing(4);
  // The title takes all that it needs, the type what is left.
  grid->addLayout(inRow(16, {{m_title, 100}, {m_type, 1, Qt::AlignBottom}}), 0, 0);
  grid->addLayout(inRow(16, {inRow(8, {m_sign, m_word}), m_place, m_age, LayoutPart::rest()}), 1, 0);
  grid->addWidget(m_trace, 0, 1, 2, 1);
  grid->addWidget(m_full, 0, 2, 2, 1);
  m_trace->setText(tr("Its frames"));
  m_trace->setToolTip(tr("Only this device in the trace (Ctrl+T)"));
  m_trace->hide();
  connect(m_trace, &QAbstractButton::clicked, this, &PageHeader::traceRequested);
  m_full->hide();
  connect(m_full, &QAbstractButton::clicked, this, &PageHeader::fullRequested);
  grid->setColumnStretch(0, 1);
  setFonts();
}

// In the letters of the density; a change of a text or of its font moves no other.
void PageHeader::setFonts() {
  m_title->setFont(strongFont(font(), 1.4));
  m_word->setFont(strongFont(font()));
  m_widestWord = 0;
  for (const HealthCause cause : kAllOf<HealthCause>)
    m_widestWord = std::max(m_widestWord, m_word->fontMetrics().horizontalAdvance(healthWord(cause)));
  const QFont small = secondaryFont(font());
  for (QLabel* label : {m_place, m_age}) label->setFont(small);
  m_age->setMinimumWidth(m_age->fontMetrics().horizontalAdvance(tr("heard %1 ago").arg(QString())) +
                         widestAge(small));
  showTexts();
  fitLine();
}

void PageHeader::fitLine() {
  int room = width() - 32;
  for (const QWidget* button : {static_cast<QWidget*>(m_trace), static_cast<QWidget*>(m_full)}) {
    if (!button->isHidden()) room -= button->sizeHint().width() + 16;
  }
  room -= m_sign->sizeHint().width() + 8 + m_widestWord + 16 + m_place->sizeHint().width();
  m_word->setMinimumWidth(room >= 0 ? m_widestWord : 0);  // no word moves the place
  m_age->setVisible(room >= 16 + m_age->minimumWidth());
}

void PageHeader::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange) setFonts();
}

void PageHeader::setPage(const DevicePageValues& page) {
  if (page.title != m_titleText) {
    m_titleText = page.title;
    m_title->setToolTip(page.title);
    m_title->setAccessibleDescription(page.title);
    showTexts();
  }
  const QString type =
      page.identity.isEmpty() ? page.type : QStringLiteral("%1 · %2").arg(page.identity, page.type);
  if (type != m_typeText) {
    m_typeText = type;
    m_type->setToolTip(type);
    m_type->setAccessibleDescription(type);
    showTexts();
  }
  setText(*m_place, page.channel.isEmpty() ? page.address : tr("%1 on %2").arg(page.address, page.channel));
  const bool isAgo = page.age.kind == Age::Kind::Ago;
  setText(*m_age, isAgo ? tr("heard %1 ago").arg(ageText(page.age)) : ageText(page.age));
  if (page.health == m_health && !m_word->text().isEmpty()) return;
  m_health = page.health;
  const Ink ink = inkOf(m_health.severity());
  m_sign->setGlyph(healthGlyph(m_health.severity()), ink);
  setText(*m_word, healthWord(m_health));
  setInk(*m_word, ink);
}

void PageHeader::showTexts() {
  const QFontMetricsF title(m_title->font());
  m_title->setMaximumWidth(static_cast<int>(std::ceil(title.horizontalAdvance(m_titleText))));
  setText(*m_title, elidedPin(m_titleText, title, m_title->width()));
  setText(*m_type, m_type->fontMetrics().elidedText(m_typeText, Qt::ElideRight, m_type->width()));
}

bool PageHeader::eventFilter(QObject* watched, QEvent* event) {
  if ((watched == m_title || watched == m_type) && event->type() == QEvent::Resize) showTexts();
  return QWidget::eventFilter(watched, event);
}

void PageHeader::setFullOffered(bool isOffered) {
  m_full->setVisible(isOffered);
  fitLine();
}

void PageHeader::setTraceOffered(bool isOffered) {
  m_isTraceOffered = isOffered;
  m_trace->setVisible(isOffered && width() >= kRoomForTrace);
  fitLine();
}

// What is said of the device goes before a button that the View menu has too.
void PageHeader::resizeEvent(QResizeEvent*) { setTraceOffered(m_isTraceOffered); }

void PageHeader::setMarked(bool isMarked) {
  m_isMarked = isMarked;
  update();
}

void PageHeader::setFull(bool isFull) { m_full->setFull(isFull); }

void PageHeader::paintEvent(QPaintEvent*) {
  const Colours& c = coloursOf(this);
  QPainter painter(this);
  painter.fillRect(rect(), c.surface);
  const QColor line = m_isMarked ? c.accent.ink : c.stale.fill;
  const int thick = m_isMarked ? 2 : 1;
  painter.fillRect(QRect(0, height() - thick, width(), thick), line);
}

}  // namespace deckpipe
