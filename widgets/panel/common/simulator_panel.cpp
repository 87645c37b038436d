// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/common/simulator_panel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QStackedLayout>
#include <QVBoxLayout>

#include "paint/app_style.h"
#include "panel/common/glyph_label.h"
#include "panel/common/label_text.h"
#include "panel/common/secondary_font.h"
#include "panel/common/tick_box.h"
#include "text/device_text.h"

namespace deckpipe {
namespace {

constexpr int kGloveTarget = 44;  // pixels high, also for gloves

struct Group {
  const char* title;
  SimulatedFault first;  // up to the next group's
};
constexpr Group kGroups[] = {
    {QT_TRANSLATE_NOOP("deckpipe::SimulatorPanel", "Device"), SimulatedFault::Silent},
    {QT_TRANSLATE_NOOP("deckpipe::SimulatorPanel", "Fault status"), SimulatedFault::InternalFuse},
    {QT_TRANSLATE_NOOP("deckpipe::SimulatorPanel", "Answers to polls and commands"),
     SimulatedFault::AnswersLost},
    {QT_TRANSLATE_NOOP("deckpipe::SimulatorPanel", "Data pipe"), SimulatedFault::AcksLost},
};

struct FaultText {
  const char* name;
  const char* text;
  int first = 0, second = 0;  // numbers in it
};
constexpr int milliseconds(Duration d) { return static_cast<int>(d / 1ms); }
constexpr EnumTable<SimulatedFault, FaultText> kFaults{{
    {SimulatedFault::Silent, {"silent", QT_TRANSLATE_NOOP("deckpipe::SimulatorPanel", "Sends nothing")}},
    {SimulatedFault::AddressTaken,
     {"addressTaken", QT_TRANSLATE_NOOP("deckpipe::SimulatorPanel", "Another controller takes its address")}},
    {SimulatedFault::ReturnsElsewhere,
     {"returnsElsewhere", QT_TRANSLATE_NOOP("deckpipe::SimulatorPanel", "Comes back at another address")}},
    {SimulatedFault::EnableOff,
     {"enableOff", QT_TRANSLATE_NOOP("deckpipe::SimulatorPanel", "Not enabled: nothing moves")}},
    {SimulatedFault::RotationSensorError,
     {"rotationSensorError", QT_TRANSLATE_NOOP("deckpipe::SimulatorPanel", "Rotation sensor error")}},
    {SimulatedFault::NotFitted,
     {"notFitted", QT_TRANSLATE_NOOP("deckpipe::SimulatorPanel", "No position feedback")}},
    {SimulatedFault::ResetNever,
     {"resetNever", QT_TRANSLATE_NOOP("deckpipe::SimulatorPanel", "Does not come back from a reset")}},
    {SimulatedFault::InternalFuse,
     {"internalFuse", QT_TRANSLATE_NOOP("deckpipe::SimulatorPanel", "Internal fuse")}},
    {SimulatedFault::MotorAxis1,
     {"motorAxis1", QT_TRANSLATE_NOOP("deckpipe::SimulatorPanel", "Motor of axis 1, which stands still")}},
    {SimulatedFault::OlderFaults,
     {"olderFaults", QT_TRANSLATE_NOOP("deckpipe::SimulatorPanel", "Bits 17–20 and 22, of older manuals")}},
    {SimulatedFault::OlderFirmware,
     {"olderFirmware", QT_TRANSLATE_NOOP("deckpipe::SimulatorPanel", "5 bytes, as older firmware answers")}},
    {SimulatedFault::AnswersLost,
     {"answersLost", QT_TRANSLATE_NOOP("deckpipe::SimulatorPanel", "%1 of %2 lost"),
      SimulatorNumbers::kAnswersLost, SimulatorNumbers::kAnswersOf}},
    {SimulatedFault::AnswersLate,
     {"answersLate", QT_TRANSLATE_NOOP("deckpipe::SimulatorPanel", "%1 ms late"),
      milliseconds(SimulatorNumbers::kAnswersLate)}},
    {SimulatedFault::AnswersTwice,
     {"answersTwice", QT_TRANSLATE_NOOP("deckpipe::SimulatorPanel", "Sent twice")}},
    {SimulatedFault::AnswersWrongLength,
     {"answersWrongLength", QT_TRANSLATE_NOOP("deckpipe::SimulatorPanel", "A byte short")}},
    {SimulatedFault::AnswersWrongSource,
     {"answersWrongSource", QT_TRANSLATE_NOOP("deckpipe::SimulatorPanel", "From the next address")}},
    {SimulatedFault::AcksLost,
     {"acksLost", QT_TRANSLATE_NOOP("deckpipe::SimulatorPanel", "1 of %1 acknowledgements lost"),
      SimulatorNumbers::kPipeLostOneOf}},
    {SimulatedFault::AcksLate,
     {"acksLate", QT_TRANSLATE_NOOP("deckpipe::SimulatorPanel", "Acknowledgements %1 ms late"),
      milliseconds(SimulatorNumbers::kAcksLate)}},
    {SimulatedFault::AcksTwice,
     {"acksTwice", QT_TRANSLATE_NOOP("deckpipe::SimulatorPanel", "Acknowledgements sent twice")}},
    {SimulatedFault::PacketsLost,
     {"packetsLost", QT_TRANSLATE_NOOP("deckpipe::SimulatorPanel", "1 of %1 packets of its own lost"),
      SimulatorNumbers::kPipeLostOneOf}},
    {SimulatedFault::VanishesInTransfer,
     {"vanishesInTransfer",
      QT_TRANSLATE_NOOP("deckpipe::SimulatorPanel", "No power after %1 packets, for %2 s"),
      SimulatorNumbers::kVanishesAfter, milliseconds(SimulatorNumbers::kVanishesFor) / 1000}},
}};

}  // namespace

SimulatorPanel::SimulatorPanel(QWidget* parent)
    : QWidget(parent),
      m_pages(new QStackedLayout(this)),
      m_empty(new QLabel(tr("No simulated truck is running."), this)) {
  setObjectName(QStringLiteral("simulatorPanel"));
  setAccessibleName(tr("Simulated truck"));
  m_empty->setObjectName(QStringLiteral("noSimulator"));
  m_empty->setAccessibleName(tr("Why there is nothing to set"));
  m_empty->setAlignment(Qt::AlignCenter);
  m_empty->setWordWrap(true);
  m_empty->setMargin(24);
  setInk(*m_empty, Ink::Secondary);
  m_pages->addWidget(m_empty);
  m_pages->addWidget(makeControls());
  setFocusProxy(m_devices);
}

QPushButton* SimulatorPanel::makeButton(const char* name, const QString& text, QVBoxLayout* layout) {
  auto* button = new QPushButton(text, this);
  button->setObjectName(QString::fromLatin1(name));
  button->setAccessibleName(text);
  button->setMinimumHeight(kGloveTarget);
  button->setAutoDefault(false);
  if (layout != nullptr) layout->addWidget(button);
  return button;
}

QWidget* SimulatorPanel::makeControls() {
  auto* page = new QWidget(this);
  auto* layout = new QVBoxLayout(page);
  layout->setContentsMargins(8, 8, 8, 8);
  layout->setSpacing(8);
  m_remark = new QLabel(tr("What is set here goes wrong on the simulated truck alone."), page);
  m_remark->setWordWrap(true);
  m_remark->setFont(secondaryFont(font()));
  setInk(*m_remark, Ink::Secondary);
  m_devices = new QComboBox(page);
  m_devices->setObjectName(QStringLiteral("simulatorDevices"));
  m_devices->setAccessibleName(tr("Simulated device"));
  m_devices->setMinimumHeight(kGloveTarget);
  m_devices->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  m_devices->setMinimumContentsLength(12);
  m_sign = new GlyphLabel(page);
  m_state = new QLabel(page);
  m_state->setObjectName(QStringLiteral("simulatorState"));
  m_state->setAccessibleName(tr("State of the simulated device"));
  m_state->setWordWrap(true);
  m_powerOff = makeButton("simulatorPowerOff", tr("Power off"), nullptr);
  m_powerOn = makeButton("simulatorPowerOn", tr("Power on"), nullptr);
  m_reset = makeButton("simulatorReset", tr("Reset"), nullptr);

  auto* state = new QHBoxLayout;
  state->addWidget(m_sign);
  state->addWidget(m_state, 1);
  auto* buttons = new QHBoxLayout;
  for (QPushButton* button : {m_powerOff, m_powerOn, m_reset}) buttons->addWidget(button);
  layout->addWidget(m_remark);
  layout->addWidget(m_devices);
  layout->addLayout(state);
  layout->addLayout(buttons);
  layout->addWidget(makeFaults(), 1);
  m_allWell = makeButton("simulatorAllWell", tr("All is well again"), layout);

  connect(m_devices, &QComboBox::currentIndexChanged, this, &SimulatorPanel::showDevice);
  connect(m_powerOff, &QPushButton::clicked, this, [this] { intent(SimulatorButton::PowerOff); });
  connect(m_powerOn, &QPushButton::clicked, this, [this] { intent(SimulatorButton::PowerOn); });
  connect(m_reset, &QPushButton::clicked, this, [this] { intent(SimulatorButton::Reset); });
  connect(m_allWell, &QPushButton::clicked, this, [this] { intent(SimulatorAllWell{}); });
  return page;
}

QWidget* SimulatorPanel::makeFaults() {
  auto* list = new QWidget;
  auto* layout = new QVBoxLayout(list);
  layout->setContentsMargins(8, 8, 8, 8);
  layout->setSpacing(0);
  QString group;
  for (const SimulatedFault fault : kAllOf<SimulatedFault>) {
    for (const Group& g : kGroups) {
      if (g.first != fault) continue;
      group = tr(g.title);
      auto* title = new QLabel(group, list);
      QFont bold = title->font();
      bold.setWeight(QFont::DemiBold);
      title->setFont(bold);
      title->setContentsMargins(0, fault == SimulatedFault{} ? 0 : 12, 0, 4);
      layout->addWidget(title);
    }
    auto* box = new TickBox(faultText(fault), list);
    box->setObjectName(QStringLiteral("simulatorFault_") + QLatin1String(kFaults[fault].name));
    box->setAccessibleName(tr("%1: %2").arg(group, box->text()));
    connect(box, &TickBox::clicked, this, [this, fault](bool on) {
      intent(SimulatorSwitch{fault, on});
      showDevice();
    });
    layout->addWidget(box);
    m_faults[fault] = box;
  }
  layout->addStretch(1);
  m_scroll = new QScrollArea(this);
  m_scroll->setObjectName(QStringLiteral("simulatorFaults"));
  m_scroll->setAccessibleName(tr("What goes wrong"));
  m_scroll->setWidgetResizable(true);
  m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  m_scroll->setWidget(list);
  m_scroll->setFocusPolicy(Qt::NoFocus);
  // Whatever the font and the language, no line is cut off.
  m_scroll->setMinimumWidth(list->sizeHint().width() + m_scroll->verticalScrollBar()->sizeHint().width() +
                            2 * m_scroll->frameWidth());
  list->setBackgroundRole(QPalette::Base);
  list->setAutoFillBackground(true);
  return m_scroll;
}

QString SimulatorPanel::faultText(SimulatedFault fault) {
  const FaultText& text = kFaults[fault];
  if (text.first == 0) return tr(text.text);
  const QString withFirst = tr(text.text).arg(text.first);
  return text.second == 0 ? withFirst : withFirst.arg(text.second);
}

const SimulatedDevice* SimulatorPanel::device() const {
  const auto index = static_cast<std::size_t>(m_devices->currentIndex());
  return index < m_status.devices.size() ? &m_status.devices[index] : nullptr;
}

void SimulatorPanel::intent(decltype(SimulatorIntent::what) what) {
  if (device() != nullptr)
    Q_EMIT simulatorIntended({static_cast<std::size_t>(m_devices->currentIndex()), what});
}

void SimulatorPanel::setStatus(const SimulatorStatus& status) {
  m_status = status;
  listDevices();
  m_pages->setCurrentIndex(m_status.devices.empty() ? 0 : 1);
  showDevice();
}

void SimulatorPanel::listDevices() {
  const QSignalBlocker blocker(m_devices);
  const int count = static_cast<int>(m_status.devices.size());
  while (m_devices->count() > count) m_devices->removeItem(m_devices->count() - 1);
  for (int i = 0; i < count; ++i) {
    const SimulatedDevice& d = m_status.devices[static_cast<std::size_t>(i)];
    const QString text = d.pin.isNull()
                             ? tr("%1 without a PIN").arg(d.model)
                             : tr("%1, %2").arg(deviceTypeText(d.pin.deviceType()), pinText(d.pin));
    if (i >= m_devices->count()) {
      m_devices->addItem(text);
    } else if (m_devices->itemText(i) != text) {
      m_devices->setItemText(i, text);
    }
  }
}

void SimulatorPanel::showDevice() {
  const SimulatedDevice* d = device();
  if (d == nullptr) return;
  showState(*d);
  m_powerOff->setEnabled(d->isPowered);
  m_powerOn->setEnabled(!d->isPowered);
  m_reset->setEnabled(d->isPowered);
  m_allWell->setEnabled(!d->faults.isNone());
  for (const SimulatedFault fault : kAllOf<SimulatedFault>) {
    m_faults[fault]->setChecked(d->faults.has(fault));
    m_faults[fault]->setVisible(d->possible.has(fault));
  }
}

void SimulatorPanel::showState(const SimulatedDevice& d) {
  if (!d.isPowered) {
    setText(*m_state, tr("No power"));
    m_sign->setGlyph(Glyph::Off, Ink::Stale);
  } else if (d.address == kNullAddress) {
    setText(*m_state, tr("Powered, without an address"));
    m_sign->setGlyph(Glyph::Warning, Ink::Warning);
  } else {
    setText(*m_state, tr("On the bus at %1").arg(addressText(d.address)));
    m_sign->setGlyph(Glyph::On, Ink::Fine);
  }
}

}  // namespace deckpipe
