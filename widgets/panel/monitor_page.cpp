// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/monitor_page.h"

#include <QGridLayout>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>

#include "paint/dial.h"
#include "panel/dial_adapter.h"
#include "panel/fact_list.h"
#include "panel/label_ink.h"
#include "panel/lamp_grid.h"
#include "panel/page_header.h"
#include "panel/stick_box.h"
#include "panel/stops_grid.h"

namespace deckpipe {
namespace {

constexpr int kMargin = 16;
constexpr int kLeastDial = 296;  // still read at arm's length
constexpr int kBelowDial = 168;  // outputs in four columns
constexpr int kFactWidth = 300;
constexpr int kNarrow = 760;  // below this, one column

// Lamps that say why a monitor moves or does not stand beside its dial, a joystick's beside its stick.
bool standsBeside(const PageLampGroup& group) {
  return group.key == QLatin1String("status") || group.key == QLatin1String("permissive") ||
         group.key == QLatin1String("switches");
}

}  // namespace

MonitorPage::MonitorPage(QWidget* parent)
    : QWidget(parent),
      m_colours(coloursOf(Theme::Light)),
      m_header(new PageHeader(this)),
      m_message(new QLabel(this)),
      m_scroll(new QScrollArea(this)),
      m_dial(new Dial),
      m_stick(new StickBox),
      m_stops(new StopsGrid) {
  setObjectName(QStringLiteral("monitorPage"));
  setAccessibleName(tr("Device page"));
  m_message->setObjectName(QStringLiteral("pageMessage"));
  m_message->setAlignment(Qt::AlignCenter);
  m_message->setWordWrap(true);
  m_message->setMargin(24);
  m_message->setAutoFillBackground(true);
  m_message->setBackgroundRole(QPalette::Base);
  m_scroll->setObjectName(QStringLiteral("pageScroll"));
  m_scroll->setAccessibleName(tr("Values of the device"));
  m_scroll->setWidgetResizable(true);
  m_scroll->setFrameShape(QFrame::NoFrame);
  m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);

  auto* content = new QWidget;
  content->setObjectName(QStringLiteral("pageContent"));
  content->setAutoFillBackground(true);
  content->setBackgroundRole(QPalette::Base);
  auto* all = new QVBoxLayout(content);
  all->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
  all->setSpacing(kMargin);
  m_top = new QBoxLayout(QBoxLayout::LeftToRight);
  m_top->setSpacing(24);
  m_side = new QVBoxLayout;
  m_side->setSpacing(kMargin);
  m_side->addWidget(m_stops);
  m_side->addStretch(1);
  m_top->addWidget(m_dial, 5);
  m_top->addWidget(m_stick, 0, Qt::AlignTop);
  m_top->addLayout(m_side, 4);
  m_below = new QVBoxLayout;
  m_below->setSpacing(kMargin);
  m_factGrid = new QGridLayout;
  m_factGrid->setHorizontalSpacing(32);
  m_factGrid->setVerticalSpacing(kMargin);
  all->addLayout(m_top);
  all->addLayout(m_below);
  all->addLayout(m_factGrid);
  all->addStretch(1);
  m_scroll->setWidget(content);

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(m_header);
  layout->addWidget(m_message, 1);
  layout->addWidget(m_scroll, 1);
  setColours(m_colours);
  showValues();
}

void MonitorPage::setDevice(const DeviceKey& key) {
  if (key == m_key) return;
  m_key = key;
  refresh();
  m_scroll->ensureVisible(0, 0);
}

void MonitorPage::setView(const LogView& view) {
  m_view = view;
  refresh();
}

void MonitorPage::refresh() {
  MonitorPageValues values = monitorPageOf(m_view, m_key);
  // Without a device the message depends on who else is there.
  if (values == m_values && values.isFound) return;
  m_values = std::move(values);
  showValues();
}

void MonitorPage::showValues() {
  const bool isFound = m_values.isFound;
  m_header->setVisible(isFound);
  m_scroll->setVisible(isFound);
  m_message->setVisible(!isFound);
  if (!isFound) {
    m_message->setText(missingText());
    return;
  }
  m_header->setPage(m_values);
  m_dial->setVisible(m_values.dial.has_value());
  if (m_values.dial) m_dial->setValues(dialValuesOf(*m_values.dial));
  m_stick->setVisible(m_values.stick.has_value());
  if (m_values.stick) m_stick->setStick(*m_values.stick);
  m_stops->setVisible(!m_values.stops.axes.empty());
  m_stops->setStops(m_values.stops);
  showLamps();
  showFacts();
  layOut();
}

QString MonitorPage::missingText() const {
  if (!m_key.isNull()) return tr("%1 was not heard up to this place of the log.").arg(keyText(m_key));
  const bool isAnyone = m_view.state != nullptr && !deviceRows(*m_view.state).empty();
  return isAnyone ? tr("Choose a device on the left.") : tr("Devices are shown here once they are heard.");
}

void MonitorPage::showLamps() {
  const bool hasTop = m_values.dial || m_values.stick;
  while (m_lamps.size() < m_values.lamps.size()) {
    m_lamps.push_back(new LampGrid(m_scroll->widget()));
    m_lamps.back()->setColours(m_colours);
    m_below->addWidget(m_lamps.back());
  }
  for (std::size_t i = 0; i < m_lamps.size(); ++i) {
    LampGrid* grid = m_lamps[i];
    const bool isUsed = i < m_values.lamps.size();
    if (isUsed) {
      const PageLampGroup& group = m_values.lamps[i];
      const bool beside = hasTop && standsBeside(group);
      const bool isThere = (m_side->indexOf(grid) >= 0) == beside;
      if (!isThere) {
        m_side->removeWidget(grid);
        m_below->removeWidget(grid);
        if (beside) {
          m_side->insertWidget(m_side->count() - 1, grid);  // before the stretch
        } else {
          m_below->addWidget(grid);
        }
      }
      grid->setGroup(group);
    }
    grid->setVisible(isUsed);
  }
}

void MonitorPage::showFacts() {
  while (m_facts.size() < m_values.facts.size()) {
    m_facts.push_back(new FactList(m_scroll->widget()));
    m_facts.back()->setColours(m_colours);
    m_factColumns = 0;  // they are to be placed
  }
  for (std::size_t i = 0; i < m_facts.size(); ++i) {
    const bool isUsed = i < m_values.facts.size();
    if (isUsed) m_facts[i]->setGroup(m_values.facts[i]);
    m_facts[i]->setVisible(isUsed);
  }
}

// As high as what stands beside it, or as what the outputs leave, within what still looks like one
// instrument.
int MonitorPage::dialHeight() const {
  const int inner = width() - 2 * kMargin;
  const bool isWide = width() >= kNarrow;
  const int dialWidth = isWide ? inner * 5 / 9 : inner;
  const int beside = isWide ? m_side->heightForWidth((inner - m_top->spacing()) * 4 / 9) : 0;
  const int left = height() - m_header->sizeHint().height() - 2 * kMargin - kBelowDial;
  return std::clamp(std::max(left, beside), kLeastDial, std::max(kLeastDial, dialWidth * 11 / 16));
}

void MonitorPage::layOut() {
  m_dial->setFixedHeight(dialHeight());
  const auto direction = width() < kNarrow ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight;
  if (m_top->direction() != direction) m_top->setDirection(direction);
  layOutFacts();
}

void MonitorPage::layOutFacts() {
  const int count = static_cast<int>(m_values.facts.size());
  const int fitting = std::max(1, (width() - 2 * kMargin) / kFactWidth);
  // Four groups in two rows of two, not in three and one.
  const int rows = (count + fitting - 1) / fitting;
  const int columns = std::max(1, rows == 0 ? 1 : (count + rows - 1) / rows);
  if (columns == m_factColumns) return;
  m_factColumns = columns;
  for (FactList* facts : m_facts) m_factGrid->removeWidget(facts);
  for (int i = 0; i < static_cast<int>(m_facts.size()); ++i)
    m_factGrid->addWidget(m_facts[static_cast<std::size_t>(i)], i / columns, i % columns, Qt::AlignTop);
  for (int c = 0; c < m_factGrid->columnCount(); ++c) m_factGrid->setColumnStretch(c, c < columns ? 1 : 0);
}

void MonitorPage::resizeEvent(QResizeEvent*) { layOut(); }

void MonitorPage::setColours(const Colours& colours) {
  m_colours = colours;
  setPalette(qtPalette(colours));
  setInk(*m_message, colours.textSecondary);
  m_header->setColours(colours);
  m_dial->setColours(colours);
  m_stick->setColours(colours);
  m_stops->setColours(colours);
  for (LampGrid* lamps : m_lamps) lamps->setColours(colours);
  for (FactList* facts : m_facts) facts->setColours(colours);
}

void MonitorPage::setAnimated(bool animated) { m_dial->setAnimated(animated); }

}  // namespace deckpipe
