// SPDX-License-Identifier: GPL-3.0-or-later
// The line over a group of lamps or facts: what it is, a remark, and at the right how old it is.
#pragma once

#include <QString>
#include <QWidget>
#include <optional>

#include "base/time.h"

namespace deckpipe {

class SectionTitle : public QWidget {
  Q_OBJECT

 public:
  explicit SectionTitle(QWidget* parent = nullptr);

  void setTitle(const QString& title, const QString& remark = {});
  // Nothing: the message never came, which is said, unless the section has no age at all.
  void setAge(std::optional<Duration> age, bool isStale);

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
