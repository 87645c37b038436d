// SPDX-License-Identifier: GPL-3.0-or-later
// The look of the application until the end of the scope; what is there changes over at once.
#pragma once

#include <QApplication>
#include <QStyleFactory>

#include "paint/app_style.h"

namespace deckpipe::test {

class Look {
 public:
  explicit Look(Theme theme, Density density = Density::Desk) : m_before(QApplication::font()) {
    QApplication::setStyle(new AppStyle(density, theme));
    QApplication::setFont(fontFor(density, m_before));
  }
  Look(const Look&) = delete;
  Look& operator=(const Look&) = delete;
  ~Look() {
    QApplication::setFont(m_before);
    QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    QApplication::setPalette(QPalette());
  }

 private:
  QFont m_before;
};

}  // namespace deckpipe::test
