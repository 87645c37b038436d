// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/common/danger_dialog.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QGridLayout>

#include "paint/app_style.h"
#include "panel/common/build.h"
#include "panel/common/warning_button.h"

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
  m_verb = new WarningButton(question.verb, this);
  m_verb->setObjectName(QStringLiteral("dangerVerb"));
  buttons->addButton(m_verb, QDialogButtonBox::AcceptRole);
  m_no = buttons->addButton(question.otherwise.isEmpty() ? tr("Cancel") : question.otherwise,
                            QDialogButtonBox::RejectRole);
  m_no->setObjectName(QStringLiteral("dangerCancel"));
  for (QPushButton* button : std::initializer_list<QPushButton*>{m_verb, m_no}) {
    button->setMinimumHeight(kTarget);
    button->setAccessibleName(button->text());
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

}  // namespace deckpipe
