// SPDX-License-Identifier: GPL-3.0-or-later
#include "paint/spoken.h"

#include <QAbstractButton>
#include <QAccessibleWidget>
#include <QCheckBox>
#include <QPushButton>
#include <QRadioButton>
#include <QToolButton>

namespace deckpipe {
namespace {

constexpr char kRole[] = "spokenRole", kValue[] = "spokenValue";

class AccessiblePainting : public QAccessibleWidget, public QAccessibleValueInterface {
 public:
  explicit AccessiblePainting(QWidget* widget)
      : QAccessibleWidget(widget, static_cast<QAccessible::Role>(widget->property(kRole).toInt())) {}

  void* interface_cast(QAccessible::InterfaceType type) override {
    if (type == QAccessible::ValueInterface && widget()->property(kValue).isValid())
      return static_cast<QAccessibleValueInterface*>(this);
    return QAccessibleWidget::interface_cast(type);
  }
  QString text(QAccessible::Text kind) const override {
    return kind == QAccessible::Value ? value().words : QAccessibleWidget::text(kind);
  }
  QVariant currentValue() const override { return value().now; }
  QVariant minimumValue() const override { return value().least; }
  QVariant maximumValue() const override { return value().most; }
  QVariant minimumStepSize() const override { return {}; }
  void setCurrentValue(const QVariant&) override {}  // its keys move it

 private:
  SpokenValue value() const { return widget()->property(kValue).value<SpokenValue>(); }
};

class AccessiblePaintedButton : public QAccessibleWidget {
 public:
  explicit AccessiblePaintedButton(QAbstractButton* button)
      : QAccessibleWidget(button, QAccessible::Button), m_button(button) {}

  QAccessible::State state() const override {
    QAccessible::State state = QAccessibleWidget::state();
    state.pressed = m_button->isDown();
    state.checkable = m_button->isCheckable();
    state.checked = m_button->isChecked();
    return state;
  }
  QStringList actionNames() const override {
    return QStringList{pressAction()} + QAccessibleWidget::actionNames();
  }
  void doAction(const QString& name) override {
    if (name == pressAction()) {
      m_button->click();
    } else {
      QAccessibleWidget::doAction(name);
    }
  }

 private:
  QAbstractButton* m_button;
};

template <typename... Known>
bool isAnyOf(const QObject* object) {
  return (... || (qobject_cast<const Known*>(object) != nullptr));
}

QAccessibleInterface* interfaceOf(const QString&, QObject* object) {
  auto* widget = qobject_cast<QWidget*>(object);
  if (widget == nullptr) return nullptr;
  if (widget->property(kRole).isValid()) return new AccessiblePainting(widget);
  auto* button = qobject_cast<QAbstractButton*>(object);
  if (button == nullptr || isAnyOf<QPushButton, QToolButton, QCheckBox, QRadioButton>(object)) return nullptr;
  return new AccessiblePaintedButton(button);
}

}  // namespace

void speakPaintedWidgets() {
  static const bool isInstalled = (QAccessible::installFactory(interfaceOf), true);
  Q_UNUSED(isInstalled);
}

void speakAs(QWidget& widget, QAccessible::Role role) {
  speakPaintedWidgets();
  widget.setProperty(kRole, static_cast<int>(role));
}

void sayValue(QWidget& widget, const SpokenValue& value, bool isNews) {
  if (widget.property(kValue).value<SpokenValue>() == value) return;
  widget.setProperty(kValue, QVariant::fromValue(value));
  widget.setAccessibleDescription(value.words);
  if (!isNews || !QAccessible::isActive()) return;
  QAccessibleValueChangeEvent changed(&widget, value.now);
  QAccessible::updateAccessibility(&changed);
}

}  // namespace deckpipe
