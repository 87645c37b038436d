// SPDX-License-Identifier: GPL-3.0-or-later
// A main window over a real session for tests: opened, shown, and given logs as files.
#pragma once

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAction>
#include <QFile>
#include <QLabel>
#include <QTemporaryDir>
#include <QTest>

#include "console/main_window.h"
#include "support/child.h"

namespace deckpipe::test {

inline constexpr int kPatience = 20'000;  // ms; only ever used up by a failure

inline const QByteArray kTruck =
    "(10.000000) can0 18EFFF80#FF83150206021A0B\n"
    "(10.100000) can0 18EFFF80#011D940371000041\n"
    "(10.200000) can0 18EFFF80#01000C0371000041\n";

class WindowTest : public testing::Test {
 protected:
  void SetUp() override {
    m_window.resize(1366, 720);
    m_window.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&m_window));
  }
  QString writeLog(const QByteArray& text, const QString& name = QStringLiteral("truck.log")) {
    const QString path = m_dir.filePath(name);
    QFile file(path);
    if (file.open(QIODevice::WriteOnly)) file.write(text);
    return path;
  }
  // It is seen at its end, where everything has happened.
  void openLog(const QByteArray& text) {
    const auto before = m_session.snapshot().view.document;
    m_session.openLog(writeLog(text));
    ASSERT_TRUE(QTest::qWaitFor(
        [&] {
          const Snapshot& s = m_session.snapshot();
          return s.view.document != before && s.source.progress == SourceStatus::Progress::Done;
        },
        kPatience));
    m_session.goToEnd();
    ASSERT_TRUE(QTest::qWaitFor(
        [&] {
          const LogView& view = m_session.snapshot().view;
          return view.state->cursor() == view.cursor && view.frameCount > 0;
        },
        kPatience));
  }
  template <typename T>
  T* only() const {
    return test::child<T>(m_window);
  }
  template <typename T>
  T* named(const char* name) const {
    return test::child<T>(m_window, name);
  }
  void trigger(const char* action) const { named<QAction>(action)->trigger(); }
  QString text(const char* label) const { return named<QLabel>(label)->text(); }

  QTemporaryDir m_dir;
  Session m_session;
  MainWindow m_window{m_session};
};

}  // namespace deckpipe::test
