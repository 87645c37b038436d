// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/common/simulator_panel.h"

#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QStackedLayout>

#include "paint/app_style.h"
#include "panel/common/build.h"
#include "panel/common/labels.h"
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
      m_empty(makeMessage(this, "noSimulator", tr("Why there is nothing to set"))) {
  named(this, "simulatorPanel", tr("Simulated truck"));
  m_empty->setText(tr("No simulated truck is running."));
  m_empty->setAutoFillBackground(false);
  m_pages->addWidget(m_empty);
  m_pages->addWidget(makeControls());
  setFocusProxy(m_devices);
}

QPushButton* SimulatorPanel::makeAction(const char* name, const QString& text,
                                        decltype(SimulatorIntent::what) what) {
  QPushButton* button = makeButton(this, name, text);
  button->setMinimumHeight(kGloveTarget);
  connect(button, &QPushButton::clicked, this, [this, what] { intent(what); });
  return button;
}

QWidget* SimulatorPanel::makeControls() {
  auto* page = new QWidget(this);
  m_remark = makeWords(page, "", {}, Ink::Secondary);
  m_remark->setText(tr("What is set here goes wrong on the simulated truck alone."));
  m_remark->setFont(secondaryFont(font()));
  m_devices = named(new QComboBox(page), "simulatorDevices", tr("Simulated device"));
  m_devices->setMinimumHeight(kGloveTarget);
  m_devices->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  m_devices->setMinimumContentsLength(12);
  connect(m_devices, &QComboBox::currentIndexChanged, this, &SimulatorPanel::showDevice);
  m_sign = new GlyphLabel(page);
  m_state = makeWords(page, "simulatorState", tr("State of the simulated device"));
  m_powerOff = makeAction("simulatorPowerOff", tr("Power off"), SimulatorButton::PowerOff);
  m_powerOn = makeAction("simulatorPowerOn", tr("Power on"), SimulatorButton::PowerOn);
  m_reset = makeAction("simulatorReset", tr("Reset"), SimulatorButton::Reset);
  QWidget* faults = makeFaults();
  m_allWell = makeAction("simulatorAllWell", tr("All is well again"), SimulatorAllWell{});
  inColumn(page, {8, 8, 8, 8}, 8,
           {m_remark,
            m_devices,
            inRow({m_sign, {m_state, 1}}),
            inRow({m_powerOff, m_powerOn, m_reset}),
            {faults, 1},
            m_allWell});
  return page;
}

QWidget* SimulatorPanel::makeFaults() {
  auto* list = new QWidget;
  auto* layout = inColumn(list, {8, 8, 8, 8}, 0, {});
  QString group;
  for (const SimulatedFault fault : kAllOf<SimulatedFault>) {
    for (const Group& g : kGroups) {
      if (g.first != fault) continue;
      group = tr(g.title);
      auto* title = new QLabel(group, list);
      title->setFont(strongFont(title->font()));
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
  m_scroll = named(new QScrollArea(this), "simulatorFaults", tr("What goes wrong"));
  m_scroll->setWidgetResizable(true);
  m_scroll->setWidget(list);
  m_scroll->setFocusPolicy(Qt::NoFocus);
  // It counts in the width that the panel likes: whatever the font and the language, no line is cut off.
  m_scroll->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
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
