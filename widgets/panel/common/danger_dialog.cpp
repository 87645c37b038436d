// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/common/danger_dialog.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QPushButton>
#include "panel/common/build.h"

namespace deckpipe {
namespace {

constexpr int kTarget = 44, kWidth = 440;

}  // namespace

DangerDialog::DangerDialog(QWidget* parent, const Question& question) : QDialog(parent) {
  setObjectName(QStringLiteral("dangerDialog"));
  setWindowTitle(question.title);
  setAttribute(Qt::WA_DeleteOnClose);
  auto* title = new QLabel(question.title, this);
  title->setObjectName(QStringLiteral("dangerTitle"));
  QFont large = title->font();
  large.setPointSizeF(large.pointSizeF() * 1.25);
  large.setBold(true);
  title->setFont(large);
  title->setWordWrap(true);
  auto* text = new QLabel(question.text, this);
  text->setObjectName(QStringLiteral("dangerText"));
  text->setWordWrap(true);
  auto* buttons = new QDialogButtonBox(this);
  auto* verb = buttons->addButton(question.verb, QDialogButtonBox::AcceptRole);
  verb->setObjectName(QStringLiteral("dangerVerb"));
  auto* no = buttons->addButton(question.otherwise.isEmpty() ? tr("Cancel") : question.otherwise,
                                QDialogButtonBox::RejectRole);
  no->setObjectName(QStringLiteral("dangerCancel"));
  for (QPushButton* button : {verb, no}) {
    button->setMinimumHeight(kTarget);
    button->setAccessibleName(button->text());
  }
  verb->setAutoDefault(false);
  no->setDefault(true);
  no->setFocus();
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  setAccessibleName(question.title);
  setAccessibleDescription(question.text);
  auto* layout = inColumn(this, {24, 24, 24, 16}, 16, {title, text});
  if (!question.option.isEmpty()) {
    m_option = named(new QCheckBox(question.option, this), "dangerOption", question.option);
    m_option->setMinimumHeight(kTarget);
    m_option->setChecked(true);
    layout->addWidget(m_option);
  }
  layout->addWidget(buttons);
  setMinimumWidth(kWidth);
}

void DangerDialog::request(QWidget* parent, const Question& question,
                           std::function<void(bool isTicked)> act) {
  auto* dialog = new DangerDialog(parent, question);
  connect(dialog, &QDialog::accepted, parent, [dialog, act = std::move(act)] {
    act(dialog->m_option != nullptr && dialog->m_option->isChecked());
  });
  dialog->open();
}

}  // namespace deckpipe
