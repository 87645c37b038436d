// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/poll/repeat_bar.h"

#include <QPushButton>

#include "model/device_rows.h"
#include "paint/app_style.h"
#include "panel/common/build.h"
#include "text/time_text.h"

namespace deckpipe {
namespace {

constexpr qsizetype kMaxLines = 4;

}  // namespace

RepeatBar::RepeatBar(QWidget* parent)
    : QWidget(parent), m_text(makeWords(this, "repeatText", tr("Polls that are repeated"), Ink::Secondary)) {
  setObjectName(QStringLiteral("repeatBar"));
  m_text->setFont(secondaryFont(font()));
  auto* end = makeButton(this, "repeatEnd", tr("End all"), tr("End all repeated polls"));
  end->setToolTip(end->accessibleName());
  inRow(this, {{m_text, 1}, end});
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
