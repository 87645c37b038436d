// SPDX-License-Identifier: GPL-3.0-or-later
// A panel that sends, over a log in which a monitor announced itself, with services that may send to it. The
// tests of such panels stand on it, change what they look at and call show().
#pragma once

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QApplication>
#include <QTest>

#include "control/intent.h"
#include "control/status.h"
#include "panel/common/panel_view.h"
#include "support/child.h"
#include "support/frames.h"

namespace deckpipe::test {

inline const DeviceKey kTarget = DeviceKey::of(*Pin::parse("1032AE100801035"));

template <typename Panel>
struct SendingPanelTest : ::testing::Test {
  SendingPanelTest() {
    services.locked = false;
    services.linkUp = true;
    services.claim.progress = ClaimStatus::Progress::Claimed;
    services.claim.address = Address{0xF9};
    DeviceServices& at = services.devices.emplace_back();
    at.device = kTarget;
    at.address = Address{0x80};
    QObject::connect(&panel, &Panel::intended, [this](const Intent& intent) { intents.push_back(intent); });
    add({frame("18EFFF80", "FF83150206021A0B", 0, 0)});
    panel.show();
  }
  void add(const std::vector<Frame>& frames) {
    ASSERT_TRUE(document->frames.append(frames));
    while (document->roles.build(1000)) {
    }
    while (document->exchanges.build(1000)) {
    }
    show();
  }
  void show() {
    view.document = document;
    view.frameCount = document->frames.count();
    view.cursor = {view.frameCount, document->frames.timeAt(view.frameCount - 1)};
    view.state = std::make_shared<State>(document->keyframes.at(view.cursor));
    showView();
  }
  // Of an earlier cursor, another device, other labels.
  void showView() {
    PanelView shown(view);
    shown.device = device;
    shown.name = deviceName;
    shown.labels = labels;
    shown.services = std::make_shared<const ServiceStatus>(services);
    shown.isLive = isLive;
    panel.setView(shown);
  }
  template <typename T>
  T* child(const char* name) {
    return test::child<T>(panel, name);
  }
  QAbstractButton* button(const char* name) { return child<QAbstractButton>(name); }
  void click(const char* name) { QTest::mouseClick(button(name), Qt::LeftButton); }
  static QWidget* dialog() { return QApplication::activeModalWidget(); }

  std::shared_ptr<LogDocument> document = std::make_shared<LogDocument>();
  LogView view;
  ServiceStatus services;
  DeviceKey device = kTarget;
  QString deviceName = QStringLiteral("Roof (1032AE100801035)");
  DeviceLabels labels;
  bool isLive = true;
  Panel panel;
  std::vector<Intent> intents;
};

}  // namespace deckpipe::test
