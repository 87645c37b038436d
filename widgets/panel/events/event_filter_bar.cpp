// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/events/event_filter_bar.h"

#include <QEvent>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QToolButton>
#include <algorithm>

#include "model/event_model.h"
#include "paint/app_style.h"
#include "panel/common/build.h"

namespace deckpipe {
namespace {

// What a button takes beside its words, and what the choices beside the buttons need.
constexpr int kAroundWords = 36, kChoices = 560;

}  // namespace

EventFilterBar::EventFilterBar(EventModel* events, EventFilter* filter, QWidget* parent)
    : QWidget(parent), m_events(events), m_filter(filter) {
  setObjectName(QStringLiteral("eventFilterBar"));
  auto* row = inRow(this, {4, 2, 4, 2}, 2, {});
  for (const EventGroup group : kAllOf<EventGroup>) {
    auto* button = new QToolButton(this);
    const QString name = eventGroupText(group);
    button->setObjectName(QStringLiteral("eventGroup%1").arg(static_cast<int>(group)));
    button->setAccessibleName(tr("Only %1").arg(name));
    button->setToolTip(tr("Only %1").arg(name));
    button->setCheckable(true);
    button->setAutoRaise(true);
    button->setIconSize({16, 16});
    connect(button, &QToolButton::toggled, this, &EventFilterBar::takeGroups);
    m_groups[group] = button;
    row->addWidget(button);
  }
  row->addSpacing(6);
  m_device = named(new QComboBox(this), "eventDevice", tr("Device whose events are listed"));
  m_device->addItem(tr("All devices"));
  m_device->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  m_device->setMinimumContentsLength(14);
  row->addWidget(m_device);
  m_weight = named(new QComboBox(this), "eventWeight", tr("How grave the events are that are listed"));
  m_weight->addItems({tr("All"), tr("Warnings and faults"), tr("Faults alone")});
  row->addWidget(m_weight);
  m_words = named(new QLineEdit(this), "eventWords", tr("Words in the events that are listed"));
  m_words->setPlaceholderText(tr("Words"));
  m_words->setClearButtonEnabled(true);
  m_words->setMinimumWidth(80);
  row->addWidget(m_words, 1);

  connect(m_device, &QComboBox::activated, this, [this](int index) {
    m_filter->setDevice(index <= 0 ? DeviceKey{} : m_devices[static_cast<std::size_t>(index) - 1]);
  });
  connect(m_weight, &QComboBox::activated, this,
          [this](int index) { m_filter->setLeast(kEventWeights.at(static_cast<std::size_t>(index))); });
  connect(m_words, &QLineEdit::textChanged, m_filter, &EventFilter::setText);
  drawMarks();
}

void EventFilterBar::drawMarks() {
  for (const EventGroup group : kAllOf<EventGroup>)
    m_groups[group]->setIcon(eventMarkIcon(group, coloursOf(this)));
}

void EventFilterBar::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::StyleChange) drawMarks();
}

void EventFilterBar::takeGroups() {
  EnumSet<EventGroup> groups;
  for (const EventGroup group : kAllOf<EventGroup>) {
    if (m_groups[group]->isChecked()) groups.add(group);
  }
  m_filter->setGroups(groups);
}

void EventFilterBar::updateDevices() {
  const std::vector<DeviceKey> devices = m_events->devices();
  QStringList names{tr("All devices")};
  for (const DeviceKey& key : devices) names << m_events->nameOf(key);
  QStringList shown;
  for (int i = 0; i < m_device->count(); ++i) shown << m_device->itemText(i);
  if (devices == m_devices && names == shown) return;
  const int index = m_device->currentIndex();
  const DeviceKey chosen = index <= 0 ? DeviceKey{} : m_devices[static_cast<std::size_t>(index) - 1];
  const QSignalBlocker blocker(m_device);
  m_devices = devices;
  m_device->clear();
  m_device->addItems(names);
  const auto again = std::ranges::find(m_devices, chosen);
  m_device->setCurrentIndex(again == m_devices.end() ? 0 : static_cast<int>(again - m_devices.begin()) + 1);
  m_filter->setDevice(again == m_devices.end() ? DeviceKey{} : chosen);
}

void EventFilterBar::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  int words = kChoices;
  for (const EventGroup group : kAllOf<EventGroup>)
    words += fontMetrics().horizontalAdvance(eventGroupText(group)) + kAroundWords;
  const bool hasWords = width() >= words;
  const int target = targetHeight(this);
  for (const EventGroup group : kAllOf<EventGroup>) {
    QToolButton* button = m_groups[group];
    button->setMinimumSize(target, target);
    const QString text = hasWords ? eventGroupText(group) : QString();
    if (button->text() == text) continue;
    button->setText(text);
    button->setToolButtonStyle(hasWords ? Qt::ToolButtonTextBesideIcon : Qt::ToolButtonIconOnly);
  }
}

}  // namespace deckpipe
