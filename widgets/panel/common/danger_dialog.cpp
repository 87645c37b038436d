// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/common/danger_dialog.h"

#include <QCheckBox>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLocale>

#include <cmath>
#include <utility>

#include "model/device_rows.h"
#include "model/page_parts.h"
#include "paint/app_style.h"
#include "paint/dial_readout.h"
#include "panel/common/build.h"
#include "panel/common/tick_box.h"
#include "text/device_text.h"
#include "text/service_text.h"
#include "text/time_text.h"

namespace deckpipe {
namespace {

constexpr int kTarget = 44, kWidth = 480, kWithdrawnLines = 2;

}  // namespace

DangerDialog::DangerDialog(QWidget* parent, const Question& question) : QDialog(parent) {
  setObjectName(QStringLiteral("dangerDialog"));
  setWindowTitle(question.title);
  setAttribute(Qt::WA_DeleteOnClose);
  auto* title = makeWords(this, "dangerTitle", question.title);
  title->setText(question.title);
  title->setFont(strongFont(title->font(), 1.25));
  auto* text = makeWords(this, "dangerText", tr("What it does"));
  text->setText(question.text);
  auto* buttons = new QDialogButtonBox(this);
  m_verb = new WarningButton(QLatin1Char('&') + question.verb,
                             this);  // Alt and its first letter, a deliberate act
  m_verb->setObjectName(QStringLiteral("dangerVerb"));
  buttons->addButton(m_verb, QDialogButtonBox::AcceptRole);
  m_no = buttons->addButton(question.otherwise.isEmpty() ? tr("Cancel") : question.otherwise,
                            QDialogButtonBox::RejectRole);
  m_no->setObjectName(QStringLiteral("dangerCancel"));
  for (QPushButton* button : std::initializer_list<QPushButton*>{m_verb, m_no}) {
    button->setMinimumHeight(kTarget);
    button->setAccessibleName(button == m_verb ? question.verb : button->text());
    button->setAutoDefault(true);  // Enter presses the one that has the focus
  }
  m_no->setDefault(true);
  m_no->setFocus();
  setAttribute(Qt::WA_KeyboardFocusChange);  // what Enter does is seen from the start
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  setAccessibleName(question.title);
  setAccessibleDescription(question.text);
  auto* layout = inColumn(this, {24, 24, 24, 16}, 12, {title});
  if (!question.whom.isEmpty()) {
    auto* whom = makeWords(this, "dangerWhom", tr("The device"), Ink::Secondary);
    whom->setText(question.whom);
    layout->addWidget(whom);
  }
  if (!question.facts.empty()) layout->addLayout(makeFacts(question.facts));
  layout->addWidget(text);
  if (!question.option.isEmpty()) {
    m_option = named(new QCheckBox(question.option, this), "dangerOption", question.option);
    m_option->setMinimumHeight(kTarget);
    m_option->setChecked(true);
    layout->addWidget(m_option);
  }
  if (question.canBeWithdrawn) {
    m_withdrawn = makeWords(this, "dangerWithdrawn", tr("Why it cannot be done any more"), Ink::Warning);
    m_withdrawn->setMinimumHeight(kWithdrawnLines * m_withdrawn->fontMetrics().lineSpacing());
    m_withdrawn->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    layout->addWidget(m_withdrawn);
  }
  layout->addWidget(buttons);
  setMinimumWidth(kWidth);
}

QLayout* DangerDialog::makeFacts(const std::vector<Fact>& facts) {
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(16);
  grid->setVerticalSpacing(4);
  grid->setColumnStretch(1, 2);
  grid->setColumnStretch(3, 3);
  for (const Fact& fact : facts) {
    const int row = static_cast<int>(m_factLabels.size());
    auto* name = makeWords(this, "dangerFactName", fact.name, Ink::Secondary);
    name->setText(fact.name);
    const FactLabels made{makeWords(this, "dangerFact", fact.name),
                          makeWords(this, "dangerFactAge", tr("Age: %1").arg(fact.name), Ink::Secondary),
                          makeWords(this, "dangerFactRemark", tr("Besides: %1").arg(fact.name))};
    made.value->setFont(strongFont(made.value->font(), 1.25));
    made.age->setMinimumWidth(widestAge(made.age->font()));
    for (QLabel* label : {name, made.value, made.age}) label->setWordWrap(false);
    grid->addWidget(name, row, 0);
    grid->addWidget(made.value, row, 1);
    grid->addWidget(made.age, row, 2);
    grid->addWidget(made.remark, row, 3);
    m_factLabels.push_back(made);
  }
  setFacts(facts);
  return grid;
}

void DangerDialog::setFacts(const std::vector<Fact>& facts) {
  if (facts == m_facts) return;
  m_facts = facts;
  for (std::size_t i = 0; i < std::min(facts.size(), m_factLabels.size()); ++i) {
    setText(*m_factLabels[i].value, facts[i].value);
    setText(*m_factLabels[i].age, facts[i].age);
    setText(*m_factLabels[i].remark, facts[i].remark);
  }
}

bool DangerDialog::isWithdrawn() const { return !m_verb->isEnabled(); }

void DangerDialog::withdraw(const QString& why) {
  if (isWithdrawn()) return;
  m_no->setDefault(true);
  m_no->setFocus();
  m_verb->setEnabled(false);
  if (m_withdrawn != nullptr) m_withdrawn->setText(why);
  setAccessibleDescription(why);
}

DangerDialog* DangerDialog::request(QWidget* parent, const Question& question,
                                    std::function<void(bool isTicked)> act) {
  auto* dialog = new DangerDialog(parent, question);
  connect(dialog, &QDialog::accepted, parent, [dialog, act = std::move(act)] {
    act(dialog->m_option != nullptr && dialog->m_option->isChecked());
  });
  dialog->open();
  return dialog;
}

namespace {

struct DeviceQuestionText {
  Q_DECLARE_TR_FUNCTIONS(DeviceQuestionText)
};

QString angleText(DialAxisKind kind, const DialAxis& axis) {
  if (axis.reading != PositionState::Ok) return DialText::reading(axis.reading);
  const QString number = QLocale().toString(std::abs(axis.degrees), 'f', 1);
  const bool isPlus = axis.degrees > 0;
  if (axis.degrees == 0) return DeviceQuestionText::tr("%1°").arg(number);
  if (kind == DialAxisKind::Rotation)
    return isPlus ? DeviceQuestionText::tr("%1° right").arg(number)
                  : DeviceQuestionText::tr("%1° left").arg(number);
  return isPlus ? DeviceQuestionText::tr("%1° up").arg(number)
                : DeviceQuestionText::tr("%1° down").arg(number);
}

DangerDialog::Fact factOf(DialAxisKind kind, const DialAxis& axis) {
  QStringList remarks;
  if (const QString stops = DialText::stops(kind, axis); !stops.isEmpty()) remarks << stops;
  if (axis.command)
    remarks << DeviceQuestionText::tr("%1 commands %2", "who, what")
                   .arg(axis.command->source, commandText(*axis.command, kind == DialAxisKind::Rotation));
  return {DialText::title(kind), angleText(kind, axis), ageText(axis.age, axis.isStale),
          remarks.join(QStringLiteral(" · "))};
}

// Two, or none of a device that has no axes.
std::vector<DangerDialog::Fact> factsOf(const State& state, const Device& device) {
  if (!device.position().isKnown()) return {};
  const DialValues dial = dialOf(state, device);
  return {factOf(DialAxisKind::Rotation, dial.rotation), factOf(DialAxisKind::Elevation, dial.elevation)};
}

// Why nothing of what was asked about a device at `address` can be done; empty if it can.
QString whyNot(const PanelView& view, const Device* device, Address address) {
  const ServiceStatus& services = *view.services;
  if (!services.linkUp) return refusalText(Refusal::NoLink);
  if (!view.isLive) return refusalText(Refusal::NotLive);
  if (services.locked || services.isEnding) return refusalText(Refusal::Locked);
  if (!services.canRequest()) return refusalText(Refusal::NoAddress);
  if (device == nullptr || device->address == kNullAddress) return refusalText(Refusal::NoDevice);
  if (device->address != address)
    return DeviceQuestionText::tr("The device is at address %1 now.").arg(addressText(device->address));
  const auto silent = ageAt(device->lastHeard, view.log.state->cursor().time);
  return silent && *silent > kHeardWithin ? refusalText(Refusal::NotHeard) : QString();
}

}  // namespace

void DeviceQuestion::ask(QWidget* panel, const PanelView& view, DangerDialog::Question question,
                         std::function<void(bool isTicked)> act) {
  const Device* device = findDevice(*view.log.state, view.device);
  m_device = view.device;
  m_address = device != nullptr ? device->address : kNullAddress;
  QStringList whom;
  if (device != nullptr && !device->pin.isNull()) whom << deviceTypeText(device->pin.deviceType());
  if (m_address != kNullAddress) whom << DeviceQuestionText::tr("address %1").arg(addressText(m_address));
  question.whom = whom.join(QStringLiteral(" · "));
  if (device != nullptr) question.facts = factsOf(*view.log.state, *device);
  question.canBeWithdrawn = true;
  m_dialog = DangerDialog::request(panel, question, std::move(act));
  setView(view);
}

void DeviceQuestion::setView(const PanelView& view) {
  if (m_dialog == nullptr || m_dialog->isWithdrawn() || view.log.state == nullptr) return;
  const Device* device = findDevice(*view.log.state, m_device);
  if (const QString why = whyNot(view, device, m_address); !why.isEmpty())
    return m_dialog->withdraw(DeviceQuestionText::tr("Withdrawn, nothing was sent: %1").arg(why));
  m_dialog->setFacts(factsOf(*view.log.state, *device));
}

}  // namespace deckpipe
