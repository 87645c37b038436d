// SPDX-License-Identifier: GPL-3.0-or-later
// The line over a group of lamps or facts: what it is, a remark, and at the right how old it is.
#pragma once

#include <QString>
#include <QWidget>

#include "base/age.h"

namespace deckpipe {

class SectionTitle : public QWidget {
  Q_OBJECT

 public:
  explicit SectionTitle(QWidget* parent = nullptr);

  void setTitle(const QString& title, const QString& remark = {});
  // That nothing was heard is said, too, unless this is never called.
  void setAge(const Age& age, bool isStale);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void describe();

  QString m_title, m_remark, m_age;
  bool m_isStale = false;
};

}  // namespace deckpipe
