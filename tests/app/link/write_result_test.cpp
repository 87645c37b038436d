// SPDX-License-Identifier: GPL-3.0-or-later
// What a refused write means is told by the system's error number, whatever words the plugin finds for it. The plugin
// here is one of Qt's, linked into the program: its interface is named after the error of each write.
#include <gtest/gtest.h>

#include <QCanBusDevice>
#include <QCanBusFactory>
#include <QCanBusFrame>
#include <QTest>
#include <QtPlugin>
#include <cerrno>

#include "link/can_link.h"
#include "support/frames.h"
#include "support/patience.h"
#include "support/recording_listener.h"

namespace deckpipe {

class FailingDevice : public QCanBusDevice {
 public:
  explicit FailingDevice(int error) : m_error(error) {}
  bool writeFrame(const QCanBusFrame&) override {
    errno = m_error;
    setError(QStringLiteral("words of its own"), WriteError);
    return false;
  }
  QString interpretErrorFrame(const QCanBusFrame&) override { return {}; }

 protected:
  bool open() override {
    setState(ConnectedState);
    return true;
  }
  void close() override { setState(UnconnectedState); }

 private:
  int m_error;
};

class FailingPlugin : public QObject, public QCanBusFactory {
  Q_OBJECT
  Q_PLUGIN_METADATA(IID "org.qt-project.Qt.QCanBusFactory" FILE "failing_plugin.json")
  Q_INTERFACES(QCanBusFactory)

 public:
  QCanBusDevice* createDevice(const QString& interfaceName, QString*) const override {
    return new FailingDevice(interfaceName.toInt());
  }
  QList<QCanBusDeviceInfo> availableDevices(QString*) const override { return {}; }
};

namespace {

struct RefusedWrite {
  const char* name;
  int error;
  WriteResult result;
};
void PrintTo(const RefusedWrite& row, std::ostream* out) { *out << row.name; }

class WriteThatFails : public testing::TestWithParam<RefusedWrite> {};

TEST_P(WriteThatFails, IsToldByTheErrorNumber) {
  CanLink link({QStringLiteral("failing"), QString::number(GetParam().error), 250'000, {}});
  RecordingListener heard;
  link.open(heard);
  ASSERT_TRUE(QTest::qWaitFor([&] { return heard.state() == LinkState::Up; }, kPatience)) << heard.reason();
  EXPECT_EQ(link.write(test::frame("123", "00")), GetParam().result);
  EXPECT_EQ(link.status().reason, "words of its own");
}

INSTANTIATE_TEST_SUITE_P(Rows, WriteThatFails,
                         testing::Values(RefusedWrite{"NoRoom", ENOBUFS, WriteResult::QueueFull},
                                         RefusedWrite{"Again", EAGAIN, WriteResult::QueueFull},
                                         RefusedWrite{"Down", ENETDOWN, WriteResult::Failed},
                                         RefusedWrite{"NoNumber", 0, WriteResult::Failed}),
                         [](const auto& row) { return std::string(row.param.name); });

}  // namespace
}  // namespace deckpipe

Q_IMPORT_PLUGIN(FailingPlugin)
#include "write_result_test.moc"
