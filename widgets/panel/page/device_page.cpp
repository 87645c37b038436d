// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/page/device_page.h"

#include <QEvent>
#include <QScrollArea>
#include <QScrollBar>
#include <algorithm>

#include "model/page_sources.h"
#include "paint/dial.h"
#include "panel/common/build.h"
#include "panel/page/fact_list.h"
#include "panel/page/full_dial.h"
#include "panel/page/lamp_grid.h"
#include "panel/page/page_content.h"
#include "panel/page/page_header.h"
#include "panel/page/stick_box.h"

namespace deckpipe {
namespace {

// Lamps that say why a monitor moves or does not stand beside its dial, a joystick's beside its stick.
bool standsBeside(const PageLampGroup& group) {
  constexpr PageGroup kBeside[] = {PageGroup::Status, PageGroup::Permissive, PageGroup::Switches,
                                   PageGroup::Detents, PageGroup::Grip};
  return std::ranges::find(kBeside, group.key, pageGroupKey) != std::end(kBeside);
}

}  // namespace

DevicePage::DevicePage(QWidget* parent)
    : QWidget(parent),
      m_header(new PageHeader(this)),
      m_message(makeMessage(this, "pageMessage", {})),
      m_content(new PageContent),
      m_scroll(makeScroll(this, "pageScroll", m_content)),
      m_dial(new Dial(m_content)),
      m_reasons(new FaultLines(m_content)),
      m_sticks{new StickBox(QStringLiteral("stick"), m_content),
               new StickBox(QStringLiteral("grip"), m_content)},
      m_stops(new StopsGrid(m_content)) {
  named(this, "monitorPage", tr("Device page"));
  m_scroll->setAccessibleName(tr("Values of the device"));
  m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  m_scroll->viewport()->installEventFilter(this);
  m_scroll->installEventFilter(this);
  m_dial->installEventFilter(this);
  m_dial->setToolTip(tr("Double click or F11: large dial") + QStringLiteral("\n\n") +
                     pageSourceText(pageGroupKey(PageGroup::Dial)));
  connect(m_header, &PageHeader::fullRequested, this, &DevicePage::toggleFull);
  connect(m_header, &PageHeader::traceRequested, this, &DevicePage::traceRequested);

  inColumn(this, {0, 0, 0, 0}, 0, {m_header, {m_message, 1}, {m_scroll, 1}});
  showValues();
}

DevicePage::~DevicePage() { delete m_full; }

// An oscillating band moves by itself unless the cursor stands still.
void DevicePage::setView(const PanelView& view) {
  const bool isOther = view.device != m_view.device;
  m_view = view;
  refresh();
  if (isOther) m_scroll->verticalScrollBar()->setValue(0);
  m_dial->setAnimated(view.isMoving);
  if (m_full != nullptr) m_full->setAnimated(view.isMoving);
}

void DevicePage::refresh() {
  DevicePageValues values = devicePageOf(m_view.log, m_view.device, m_view.labels);
  // Without a device the message depends on who else is there.
  if (values == m_values && values.isFound) return;
  m_values = std::move(values);
  showValues();
}

void DevicePage::showValues() {
  const bool isFound = m_values.isFound;
  if (isFound) {
    m_header->setPage(m_values);
    showParts();
    explain();
  } else {
    setText(*m_message, missingText());
  }
  m_header->setFullOffered(isFound && m_values.dial);
  m_header->setTraceOffered(isFound && !m_values.traceFilter.isEmpty());
  if (m_full != nullptr) m_full->setPage(m_values);
  m_message->setVisible(!isFound);
  m_header->setVisible(isFound);
  m_scroll->setVisible(isFound);
}

// For F1 on the page as a whole.
void DevicePage::explain() {
  if (m_explained == m_values.key) return;
  m_explained = m_values.key;
  QStringList keys{pageGroupKey(PageGroup::Health)};
  if (m_values.dial) keys += pageGroupKey(PageGroup::Dial);
  for (const PageLampGroup& group : m_values.lamps) keys += group.key;
  for (const PageFactGroup& group : m_values.facts) keys += group.key;
  QStringList lines;
  for (const QString& key : keys) lines += pageSourceText(key).split(QLatin1Char('\n'), Qt::SkipEmptyParts);
  lines.removeDuplicates();
  m_scroll->setWhatsThis(tr("What this page shows is taken from these messages:") + QLatin1Char('\n') +
                         lines.join(QLatin1Char('\n')));
}

QString DevicePage::missingText() const {
  if (!m_view.device.isNull())
    return tr("%1 was not heard up to this place of the log.").arg(nameText(m_view.device, m_view.labels));
  const LogView& log = m_view.log;
  const bool isAnyone = log.state != nullptr && !deviceRows(*log.state).empty();
  const bool goesOn = log.cursor.frames < log.frameCount && !m_view.isMoving;
  QStringList sentences;
  if (goesOn && log.cursor.frames <= 1) {
    sentences << tr("The log is at its begin: press play, or click into the timeline.");
  } else if (goesOn) {
    sentences << tr("More is heard later in this log: press play, or click further on in the timeline.");
  }
  if (isAnyone) sentences << tr("Choose a device on the left.");
  if (sentences.isEmpty()) sentences << tr("Devices are shown here once they are heard.");
  return sentences.join(QLatin1Char('\n'));
}

void DevicePage::showParts() {
  PageContent::Parts parts;
  m_reasons->setReasons(m_values.reasons);
  parts.reasons = m_reasons;
  if (m_values.dial) {
    m_dial->setValues(*m_values.dial);
    parts.dial = m_dial;
  }
  for (std::size_t i = 0; i < m_values.sticks.size() && i < m_sticks.size(); ++i) {
    m_sticks[i]->setStick(m_values.sticks[i]);
    if (parts.dial == nullptr) parts.sticks.push_back(m_sticks[i]);
  }
  if (!m_values.stops.axes.empty()) {
    m_stops->setStops(m_values.stops);
    parts.beside.push_back(m_stops);
  }
  const bool hasMain = m_values.dial || !m_values.sticks.empty();
  for (std::size_t i = 0; i < m_values.lamps.size(); ++i) {
    if (i == m_lamps.size()) m_lamps.push_back(new LampGrid(m_content));
    m_lamps[i]->setGroup(m_values.lamps[i]);
    (hasMain && standsBeside(m_values.lamps[i]) ? parts.beside : parts.below).push_back(m_lamps[i]);
  }
  // The stick that commands a monitor stands beside its dial.
  if (parts.dial != nullptr) {
    for (std::size_t i = 0; i < m_values.sticks.size() && i < m_sticks.size(); ++i)
      parts.beside.push_back(m_sticks[i]);
  }
  for (std::size_t i = 0; i < m_values.facts.size(); ++i) {
    if (i == m_facts.size()) m_facts.push_back(new FactList(m_content));
    m_facts[i]->setGroup(m_values.facts[i]);
    parts.facts.push_back(m_facts[i]);
  }
  m_content->setParts(parts);
}

bool DevicePage::eventFilter(QObject* watched, QEvent* event) {
  if (watched == m_scroll->viewport() && event->type() == QEvent::Resize)
    m_content->setRoom(m_scroll->viewport()->height());
  if (watched == m_scroll && (event->type() == QEvent::FocusIn || event->type() == QEvent::FocusOut))
    m_header->setMarked(event->type() == QEvent::FocusIn);
  if (watched == m_dial && event->type() == QEvent::MouseButtonDblClick) {
    toggleFull();
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

FullDial* DevicePage::full() const { return m_full; }

void DevicePage::toggleFull() {
  if (m_full != nullptr) {
    Q_EMIT m_full->closed();
    return;
  }
  if (!m_values.isFound || !m_values.dial) return;
  m_full = new FullDial(m_stage != nullptr ? m_stage : window());
  m_full->setAnimated(m_view.isMoving);
  m_full->setPage(m_values);
  connect(m_full, &FullDial::closed, this, [this] {
    m_full->deleteLater();
    m_full = nullptr;
    setFocus();
  });
  m_full->show();
  m_full->raise();
  m_full->setFocus();
}

}  // namespace deckpipe
