// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/poll/repeat_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "model/device_rows.h"
#include "paint/app_style.h"
#include "panel/common/label_text.h"
#include "panel/common/secondary_font.h"
#include "text/time_text.h"

namespace deckpipe {
namespace {

constexpr qsizetype kMaxLines = 4;

}  // namespace

RepeatBar::RepeatBar(QWidget* parent) : QWidget(parent), m_text(new QLabel(this)) {
  setObjectName(QStringLiteral("repeatBar"));
  m_text->setObjectName(QStringLiteral("repeatText"));
  m_text->setAccessibleName(tr("Polls that are repeated"));
  m_text->setWordWrap(true);
  m_text->setTextFormat(Qt::PlainText);
  m_text->setFont(secondaryFont(font()));
  setInk(*m_text, Ink::Secondary);
  auto* end = new QPushButton(tr("End all"), this);
  end->setObjectName(QStringLiteral("repeatEnd"));
  end->setAccessibleName(tr("End all repeated polls"));
  end->setToolTip(end->accessibleName());
  end->setAutoDefault(false);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(m_text, 1);
  row->addWidget(end);
  connect(end, &QPushButton::clicked, this, &RepeatBar::endRequested);
  hide();
}

void RepeatBar::setStatus(const ServiceStatus& services, const DeviceLabels& labels) {
  QStringList lines;
  for (const DeviceServices& device : services.devices) {
    if (device.longestPeriod() == 0ns) continue;
    const QString label = labels.of(device.device);
    lines += tr("%1: every %2")
                 .arg(label.isEmpty() ? keyText(device.device) : label, periodText(device.longestPeriod()));
  }
  m_text->setToolTip(lines.join(QLatin1Char('\n')));
  const qsizetype count = lines.size();
  if (count > kMaxLines) {
    lines = lines.mid(0, kMaxLines - 1);
    lines += tr("and %n more", nullptr, static_cast<int>(count - lines.size()));
  }
  lines.prepend(tr("Polls are repeated:"));
  setText(*m_text, lines.join(QLatin1Char('\n')));
  setVisible(count > 0);
}

}  // namespace deckpipe
