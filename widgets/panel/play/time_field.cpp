// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/play/time_field.h"

#include <QDateTime>
#include <QFocusEvent>
#include <QFontInfo>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QPainter>

#include <algorithm>
#include <cmath>

#include "model/typed_place.h"
#include "paint/app_style.h"
#include "paint/figures.h"
#include "panel/common/build.h"

namespace deckpipe {
namespace {

constexpr int kBesideSentence = 8;

}  // namespace

TimeField::TimeField(QWidget* clock, QWidget* bar) : QLineEdit(bar), m_clock(clock) {
  named(this, "timeField", tr("Go to a time"));
  setAlignment(Qt::AlignRight);
  m_sentence = makeWords(bar, "timeFieldSentence", tr("About the time that is typed"));
  m_sentence->setFrameShape(QFrame::Box);
  m_sentence->setMargin(6);
  m_sentence->setAutoFillBackground(true);
  m_sentence->setBackgroundRole(QPalette::Base);
  hide();
  m_sentence->hide();
  connect(this, &QLineEdit::returnPressed, this, &TimeField::take);
  connect(this, &QLineEdit::textEdited, this, [this] { say(placeHelp(m_view), false); });
}

TimeField::~TimeField() { delete m_sentence; }

void TimeField::open(const QString& text) {
  setText(text);
  show();
  raise();
  say(placeHelp(m_view), false);
  setFocus(Qt::ShortcutFocusReason);
  selectAll();
}

void TimeField::place() {
  setGeometry(m_clock->geometry());
  if (!m_sentence->isVisible()) return;
  const QPoint above = m_clock->mapTo(window(), QPoint(0, 0)),
               bar = parentWidget()->mapTo(window(), QPoint(0, 0));
  const int width = std::min(m_sentence->sizeHint().width(), window()->width() - above.x() - kBesideSentence);
  const int height = m_sentence->heightForWidth(width);
  m_sentence->setGeometry(above.x(), std::max(0, bar.y() - height), width, height);
  m_sentence->raise();
}

void TimeField::say(const QString& sentence, bool isWrong) {
  setInk(*m_sentence, isWrong ? Ink::Warning : Ink::Text);
  m_sentence->setText(sentence);
  setAccessibleDescription(sentence);
  if (m_sentence->parentWidget() != window()) m_sentence->setParent(window());
  m_sentence->show();
  place();
}

void TimeField::take() {
  if (!text().trimmed().isEmpty()) {
    const auto typed = placeOf(text(), m_view);
    if (!typed) return say(typed.error(), true);
    if (const auto* frames = std::get_if<std::uint64_t>(&typed.value())) {
      Q_EMIT framesTyped(*frames);
    } else {
      Q_EMIT timeTyped(std::get<Instant>(typed.value()));
    }
  }
  hide();
  Q_EMIT done();
}

void TimeField::hideEvent(QHideEvent* event) {
  QLineEdit::hideEvent(event);
  if (m_sentence != nullptr) m_sentence->hide();
}

void TimeField::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) {
    hide();
    Q_EMIT done();
    return;
  }
  QLineEdit::keyPressEvent(event);
}

void TimeField::focusOutEvent(QFocusEvent* event) {
  QLineEdit::focusOutEvent(event);
  const bool isLeft = event->reason() == Qt::MouseFocusReason || event->reason() == Qt::TabFocusReason ||
                      event->reason() == Qt::BacktabFocusReason;
  if (isLeft) hide();
}

namespace {

constexpr int kBesideFigures = 6;

}  // namespace

QString stampTimeText(std::int64_t stampNs) {
  if (!isDate(stampNs)) {
    const std::int64_t whole = stampNs - stampNs % 1'000'000;
    return TimeReadout::tr("%1 s").arg(static_cast<double>(whole) / 1e9, 0, 'f', 3);
  }
  return QDateTime::fromMSecsSinceEpoch(stampNs / 1'000'000).toString(QStringLiteral("yyyy-MM-dd HH:mm:ss")) +
         millisecondsText(stampNs);
}

std::optional<std::int64_t> stampAt(const LogView& view) {
  if (!view.document || view.cursor.frames == 0 || view.cursor.frames > view.document->frames.count())
    return {};
  if (!view.hasTimes()) return {};
  const std::uint64_t last = view.cursor.frames - 1;
  const Frame& frame = view.document->frames[last];
  if (!frame.hasStamp()) return {};
  std::int64_t stamp = 0;
  const Duration since = std::max(view.cursor.time - view.document->frames.timeAt(last), Duration(0));
  return __builtin_add_overflow(frame.stamp, since.count(), &stamp) ? frame.stamp : stamp;
}

TimeReadout::TimeReadout(QWidget* parent) : QAbstractButton(parent) {
  named(this, "timeReadout", tr("Time of the cursor"));
  setAttribute(Qt::WA_Hover);
  setFocusPolicy(Qt::TabFocus);
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  setView({});
}

void TimeReadout::setView(const LogView& view) {
  const QString dash(QChar(0x2013));
  const bool isEmpty = !view.document || view.frameCount == 0 || !view.hasTimes();
  const Instant now = std::max(view.cursor.time, view.begin);
  const bool hasFrames = view.document && view.frameCount > 0;
  setEnabled(hasFrames);
  QString elapsed = isEmpty ? dash : elapsedText(now - view.begin);
  const auto stamp = stampAt(view);
  QString absolute = stamp ? stampTimeText(*stamp) : dash;
  if (hasFrames && !view.hasTimes()) {
    elapsed = QLocale().toString(static_cast<qulonglong>(view.cursor.frames));
    absolute = tr("frames, no times");
  }
  if (elapsed == m_elapsed && absolute == m_absolute) return;
  m_elapsed = elapsed;
  m_absolute = absolute;
  const QString where = !view.hasTimes() ? tr("The number of the frame; this log has no times")
                        : stamp          ? tr("Since the log's begin; below, the log's own clock: %1 s")
                                      .arg(static_cast<double>(*stamp) / 1e9, 0, 'f', 6)
                                : tr("Since the log's begin");
  setToolTip(tr("%1. A click or Ctrl+G takes another place.").arg(where));
  setAccessibleDescription(tr("%1; %2").arg(m_elapsed, m_absolute));
  update();
}

void TimeReadout::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) return click();
  QAbstractButton::keyPressEvent(event);
}

QFont TimeReadout::elapsedFont() const {
  QFont large = font();
  large.setPixelSize(QFontInfo(font()).pixelSize() * 3 / 2);
  large.setWeight(QFont::DemiBold);
  return large;
}

QSize TimeReadout::sizeHint() const {
  const double width = std::max(figuresWidth(elapsedFont(), QStringLiteral("000:00:00.000")),
                                figuresWidth(font(), QStringLiteral("0000-00-00 00:00:00.000")));
  const int height = QFontMetrics(elapsedFont()).height() + QFontMetrics(font()).height();
  return {static_cast<int>(std::ceil(width)) + 2 * kBesideFigures, std::max(40, height + 4)};
}

void TimeReadout::paintEvent(QPaintEvent*) {
  const Colours& c = coloursOf(this);
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  const bool isTouched = isEnabled() && (underMouse() || isDown());
  p.setPen(QPen(c.outline, c.stroke));
  p.setBrush(isTouched ? c.surfaceAlternate : c.surface);
  p.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 4, 4);
  if (hasFocus()) drawFocusRing(p, c, rect());
  const double upper = height() * 0.56, right = width() - kBesideFigures;
  Figures figures;
  figures.number = m_elapsed;
  figures.numberFont = elapsedFont();
  figures.numberColour = m_absolute == m_elapsed ? c.textSecondary : c.text;
  drawFigures(p, QRectF(0, 1, right, upper - 1), figures);
  figures.number = m_absolute;
  figures.numberFont = font();
  figures.numberColour = c.textSecondary;
  drawFigures(p, QRectF(0, upper - 1, right, height() - upper), figures);
}

}  // namespace deckpipe
