// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/common/twin_panel.h"

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
  TwinFault first;  // up to the next group's
};
constexpr Group kGroups[] = {
    {QT_TRANSLATE_NOOP("deckpipe::TwinPanel", "Device"), TwinFault::Silent},
    {QT_TRANSLATE_NOOP("deckpipe::TwinPanel", "Fault status"), TwinFault::InternalFuse},
    {QT_TRANSLATE_NOOP("deckpipe::TwinPanel", "Answers to polls and commands"), TwinFault::AnswersLost},
    {QT_TRANSLATE_NOOP("deckpipe::TwinPanel", "Data pipe"), TwinFault::AcksLost},
};

struct FaultText {
  const char* name;
  const char* text;
  int first = 0, second = 0;  // numbers in it
};
constexpr int milliseconds(Duration d) { return static_cast<int>(d / 1ms); }
constexpr EnumTable<TwinFault, FaultText> kFaults{{
    {TwinFault::Silent, {"silent", QT_TRANSLATE_NOOP("deckpipe::TwinPanel", "Sends nothing")}},
    {TwinFault::AddressTaken,
     {"addressTaken", QT_TRANSLATE_NOOP("deckpipe::TwinPanel", "Another controller takes its address")}},
    {TwinFault::ReturnsElsewhere,
     {"returnsElsewhere", QT_TRANSLATE_NOOP("deckpipe::TwinPanel", "Comes back at another address")}},
    {TwinFault::EnableOff,
     {"enableOff", QT_TRANSLATE_NOOP("deckpipe::TwinPanel", "Not enabled: nothing moves")}},
    {TwinFault::RotationSensorError,
     {"rotationSensorError", QT_TRANSLATE_NOOP("deckpipe::TwinPanel", "Rotation sensor error")}},
    {TwinFault::NotFitted, {"notFitted", QT_TRANSLATE_NOOP("deckpipe::TwinPanel", "No position feedback")}},
    {TwinFault::ResetNever,
     {"resetNever", QT_TRANSLATE_NOOP("deckpipe::TwinPanel", "Does not come back from a reset")}},
    {TwinFault::InternalFuse, {"internalFuse", QT_TRANSLATE_NOOP("deckpipe::TwinPanel", "Internal fuse")}},
    {TwinFault::MotorAxis1,
     {"motorAxis1", QT_TRANSLATE_NOOP("deckpipe::TwinPanel", "Motor of axis 1, which stands still")}},
    {TwinFault::OlderFaults,
     {"olderFaults", QT_TRANSLATE_NOOP("deckpipe::TwinPanel", "Bits 17–20 and 22, of older manuals")}},
    {TwinFault::OlderFirmware,
     {"olderFirmware", QT_TRANSLATE_NOOP("deckpipe::TwinPanel", "5 bytes, as older firmware answers")}},
    {TwinFault::AnswersLost,
     {"answersLost", QT_TRANSLATE_NOOP("deckpipe::TwinPanel", "%1 of %2 lost"), TwinNumbers::kAnswersLost,
      TwinNumbers::kAnswersOf}},
    {TwinFault::AnswersLate,
     {"answersLate", QT_TRANSLATE_NOOP("deckpipe::TwinPanel", "%1 ms late"),
      milliseconds(TwinNumbers::kAnswersLate)}},
    {TwinFault::AnswersTwice, {"answersTwice", QT_TRANSLATE_NOOP("deckpipe::TwinPanel", "Sent twice")}},
    {TwinFault::AnswersWrongLength,
     {"answersWrongLength", QT_TRANSLATE_NOOP("deckpipe::TwinPanel", "A byte short")}},
    {TwinFault::AnswersWrongSource,
     {"answersWrongSource", QT_TRANSLATE_NOOP("deckpipe::TwinPanel", "From the next address")}},
    {TwinFault::AcksLost,
     {"acksLost", QT_TRANSLATE_NOOP("deckpipe::TwinPanel", "1 of %1 acknowledgements lost"),
      TwinNumbers::kPipeLostOneOf}},
    {TwinFault::AcksLate,
     {"acksLate", QT_TRANSLATE_NOOP("deckpipe::TwinPanel", "Acknowledgements %1 ms late"),
      milliseconds(TwinNumbers::kAcksLate)}},
    {TwinFault::AcksTwice,
     {"acksTwice", QT_TRANSLATE_NOOP("deckpipe::TwinPanel", "Acknowledgements sent twice")}},
    {TwinFault::PacketsLost,
     {"packetsLost", QT_TRANSLATE_NOOP("deckpipe::TwinPanel", "1 of %1 packets of its own lost"),
      TwinNumbers::kPipeLostOneOf}},
    {TwinFault::VanishesInTransfer,
     {"vanishesInTransfer", QT_TRANSLATE_NOOP("deckpipe::TwinPanel", "No power after %1 packets, for %2 s"),
      TwinNumbers::kVanishesAfter, milliseconds(TwinNumbers::kVanishesFor) / 1000}},
}};

}  // namespace

TwinPanel::TwinPanel(QWidget* parent)
    : QWidget(parent),
      m_pages(new QStackedLayout(this)),
      m_empty(new QLabel(tr("No simulated truck is running."), this)) {
  setObjectName(QStringLiteral("twinPanel"));
  setAccessibleName(tr("Simulated truck"));
  m_empty->setObjectName(QStringLiteral("noTwin"));
  m_empty->setAccessibleName(tr("Why there is nothing to set"));
  m_empty->setAlignment(Qt::AlignCenter);
  m_empty->setWordWrap(true);
  m_empty->setMargin(24);
  setInk(*m_empty, Ink::Secondary);
  m_pages->addWidget(m_empty);
  m_pages->addWidget(makeControls());
  setFocusProxy(m_devices);
}

QPushButton* TwinPanel::makeButton(const char* name, const QString& text, QVBoxLayout* layout) {
  auto* button = new QPushButton(text, this);
  button->setObjectName(QString::fromLatin1(name));
  button->setAccessibleName(text);
  button->setMinimumHeight(kGloveTarget);
  button->setAutoDefault(false);
  if (layout != nullptr) layout->addWidget(button);
  return button;
}

QWidget* TwinPanel::makeControls() {
  auto* page = new QWidget(this);
  auto* layout = new QVBoxLayout(page);
  layout->setContentsMargins(8, 8, 8, 8);
  layout->setSpacing(8);
  m_remark = new QLabel(tr("What is set here goes wrong on the simulated truck alone."), page);
  m_remark->setWordWrap(true);
  m_remark->setFont(secondaryFont(font()));
  setInk(*m_remark, Ink::Secondary);
  m_devices = new QComboBox(page);
  m_devices->setObjectName(QStringLiteral("twinDevices"));
  m_devices->setAccessibleName(tr("Simulated device"));
  m_devices->setMinimumHeight(kGloveTarget);
  m_devices->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  m_devices->setMinimumContentsLength(12);
  m_sign = new GlyphLabel(page);
  m_state = new QLabel(page);
  m_state->setObjectName(QStringLiteral("twinState"));
  m_state->setAccessibleName(tr("State of the simulated device"));
  m_state->setWordWrap(true);
  m_powerOff = makeButton("twinPowerOff", tr("Power off"), nullptr);
  m_powerOn = makeButton("twinPowerOn", tr("Power on"), nullptr);
  m_reset = makeButton("twinReset", tr("Reset"), nullptr);

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
  m_allWell = makeButton("twinAllWell", tr("All is well again"), layout);

  connect(m_devices, &QComboBox::currentIndexChanged, this, &TwinPanel::showDevice);
  connect(m_powerOff, &QPushButton::clicked, this, [this] { intent(TwinButton::PowerOff); });
  connect(m_powerOn, &QPushButton::clicked, this, [this] { intent(TwinButton::PowerOn); });
  connect(m_reset, &QPushButton::clicked, this, [this] { intent(TwinButton::Reset); });
  connect(m_allWell, &QPushButton::clicked, this, [this] { intent(TwinAllWell{}); });
  return page;
}

QWidget* TwinPanel::makeFaults() {
  auto* list = new QWidget;
  auto* layout = new QVBoxLayout(list);
  layout->setContentsMargins(8, 8, 8, 8);
  layout->setSpacing(0);
  QString group;
  for (const TwinFault fault : kAllOf<TwinFault>) {
    for (const Group& g : kGroups) {
      if (g.first != fault) continue;
      group = tr(g.title);
      auto* title = new QLabel(group, list);
      QFont bold = title->font();
      bold.setWeight(QFont::DemiBold);
      title->setFont(bold);
      title->setContentsMargins(0, fault == TwinFault{} ? 0 : 12, 0, 4);
      layout->addWidget(title);
    }
    auto* box = new TickBox(faultText(fault), list);
    box->setObjectName(QStringLiteral("twinFault_") + QLatin1String(kFaults[fault].name));
    box->setAccessibleName(tr("%1: %2").arg(group, box->text()));
    connect(box, &TickBox::clicked, this, [this, fault](bool on) {
      intent(TwinSwitch{fault, on});
      showDevice();
    });
    layout->addWidget(box);
    m_faults[fault] = box;
  }
  layout->addStretch(1);
  m_scroll = new QScrollArea(this);
  m_scroll->setObjectName(QStringLiteral("twinFaults"));
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

QString TwinPanel::faultText(TwinFault fault) {
  const FaultText& text = kFaults[fault];
  if (text.first == 0) return tr(text.text);
  const QString withFirst = tr(text.text).arg(text.first);
  return text.second == 0 ? withFirst : withFirst.arg(text.second);
}

const TwinDevice* TwinPanel::device() const {
  const auto index = static_cast<std::size_t>(m_devices->currentIndex());
  return index < m_status.devices.size() ? &m_status.devices[index] : nullptr;
}

void TwinPanel::intent(decltype(TwinIntent::what) what) {
  if (device() != nullptr) Q_EMIT twinIntended({static_cast<std::size_t>(m_devices->currentIndex()), what});
}

void TwinPanel::setStatus(const TwinStatus& status) {
  m_status = status;
  listDevices();
  m_pages->setCurrentIndex(m_status.devices.empty() ? 0 : 1);
  showDevice();
}

void TwinPanel::listDevices() {
  const QSignalBlocker blocker(m_devices);
  const int count = static_cast<int>(m_status.devices.size());
  while (m_devices->count() > count) m_devices->removeItem(m_devices->count() - 1);
  for (int i = 0; i < count; ++i) {
    const TwinDevice& d = m_status.devices[static_cast<std::size_t>(i)];
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

void TwinPanel::showDevice() {
  const TwinDevice* d = device();
  if (d == nullptr) return;
  showState(*d);
  m_powerOff->setEnabled(d->isPowered);
  m_powerOn->setEnabled(!d->isPowered);
  m_reset->setEnabled(d->isPowered);
  m_allWell->setEnabled(!d->faults.isNone());
  for (const TwinFault fault : kAllOf<TwinFault>) {
    m_faults[fault]->setChecked(d->faults.has(fault));
    m_faults[fault]->setVisible(d->possible.has(fault));
  }
}

void TwinPanel::showState(const TwinDevice& d) {
  if (!d.isPowered) {
    setText(*m_state, tr("No power"));
    m_sign->setGlyph(Glyph::Off, Ink::Stale);
  } else if (d.address == kNullAddress) {
    setText(*m_state, tr("Powered, without an address"));
    m_sign->setGlyph(Glyph::Attend, Ink::Attend);
  } else {
    setText(*m_state, tr("On the bus at %1").arg(addressText(d.address)));
    m_sign->setGlyph(Glyph::On, Ink::Fine);
  }
}

}  // namespace deckpipe
