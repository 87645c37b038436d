// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/device_model.h"

#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QSignalSpy>

#include "model/device_rows.h"
#include "widgets/model/heard.h"

namespace deckpipe {
namespace {

using namespace test;
using Model = DeviceModel;

class DeviceTable : public testing::Test {
 protected:
  void show() { m_model.setView(m_bus.view()); }
  QString text(int row, int column) const {
    return m_model.index(row, column).data(Qt::DisplayRole).toString();
  }
  std::string all(int row) const {
    std::string line;
    for (int column = 0; column < Model::ColumnCount; ++column) {
      if (column != 0) line += " | ";
      line += text(row, column).toStdString();
    }
    return line;
  }
  QString tooltip(int row) const { return m_model.index(row, 0).data(Qt::ToolTipRole).toString(); }

  Heard m_bus;
  Model m_model;
  QAbstractItemModelTester m_tester{&m_model, QAbstractItemModelTester::FailureReportingMode::Fatal};
};

TEST_F(DeviceTable, ShowsAMonitorWithEverything) {
  m_bus.monitor();
  show();
  ASSERT_EQ(m_model.rowCount(), 1);
  EXPECT_EQ(all(0), "1032AE100801035 | 6032 Universal II | 80 | < 1 s | not asked | 0/s | 5");
  EXPECT_EQ(m_model.index(0, 0).data(Model::GroupTextRole).toString(), QStringLiteral("Monitors"));
}

TEST_F(DeviceTable, ShowsEveryKindOfDeviceInItsGroup) {
  struct Row {
    const char* what;
    const char* id;
    std::string data;
    const char* device;
    const char* type;
    const char* group;
  };
  const Row rows[] = {
      {"monitor without PIN", "18EFFF90", kPosition, "No PIN, address 90", "Monitor, type not known",
       "Monitors"},
      {"riser", "18EFFF91", announcementOf("1033AB000000001"), "1033AB000000001", "6033 Mini Universal",
       "Other Akron devices"},
      {"joystick", "18EFFF92", announcementOf("1035AB000000002"), "1035AB000000002", "6035 Joystick",
       "Controls"},
      {"unknown type", "18EFFF93", announcementOf("1099AB000000003"), "1099AB000000003", "type 1099",
       "Other Akron devices"},
      {"I/O module", "18EFFFF0", "8501", "No PIN, address F0", "6039 CAN I/O module", "Other Akron devices"},
      {"node", "724", "05", "Node 24", "Type not known", "CANopen nodes"},
      {"gateway", "770", "05", "Node 70", "6051 CAN Gateway, by its default node", "CANopen nodes"},
      {"joystick source", "0CFDD633", kRestingStick, "Address 33", "Joystick source", "Controls"},
      {"foreign", "18EEFF21", "01002001000000FF", "Address 21",
       "Other maker, code 9; usually body controller", "Other nodes"},
      {"Akron by NAME", "18EEFF94", kNameOfA, "No PIN, address 94", "Akron device, not announced",
       "Other Akron devices"},
      {"without NAME", "18FF0005", "00", "Address 05", "No NAME heard", "Other nodes"},
  };
  for (const Row& row : rows) m_bus.hear(row.id, row.data);
  show();
  ASSERT_EQ(m_model.rowCount(), static_cast<int>(std::size(rows)));
  for (const Row& row : rows) {
    int at = -1;
    for (int i = 0; i < m_model.rowCount(); ++i) {
      if (text(i, Model::DeviceColumn).toStdString() == row.device) at = i;
    }
    ASSERT_GE(at, 0) << row.what;
    EXPECT_EQ(text(at, Model::TypeColumn).toStdString(), row.type) << row.what;
    EXPECT_EQ(m_model.index(at, 0).data(Model::GroupTextRole).toString().toStdString(), row.group)
        << row.what;
  }
}

// The rules are tested in core; here are their words.
struct HealthCase {
  const char* name;
  std::function<void(Heard&)> story;
  const char* words;
  const char* reason;  // the first sentence
};
class HealthInWords : public testing::TestWithParam<HealthCase> {};

TEST_P(HealthInWords, SaysTheWorstFirst) {
  Heard bus;
  GetParam().story(bus);
  const State& state = bus.state();
  const std::vector<DeviceRow> rows = deviceRows(state);
  ASSERT_FALSE(rows.empty());
  const Health& health = rows.front().health;
  EXPECT_EQ(healthWords(health).join(QStringLiteral(", ")).toStdString(), GetParam().words);
  EXPECT_EQ(healthWord(health), healthWords(health).front());
  EXPECT_EQ(healthSentences(health, state.cursor().time).value(0).toStdString(), GetParam().reason);
}
INSTANTIATE_TEST_SUITE_P(
    OfDevices, HealthInWords,
    testing::Values(
        HealthCase{"NeverAsked", [](Heard& b) { b.monitor(); }, "not asked", "Its faults were never asked."},
        HealthCase{"Fine", [](Heard& b) { b.monitor().faults("02000000000000"); }, "fine", ""},
        HealthCase{"FaultsByName", [](Heard& b) { b.monitor().faults("0200200002000B"); }, "fault",
                   "It answered: Motor of axis 1, Internal fuse, Error 11: rotation sensor error."},
        HealthCase{"ErrorCode", [](Heard& b) { b.monitor().faults("02000000000007"); }, "error 7",
                   "It answered: Error 7."},
        HealthCase{"OperationalErrorWithItsCode",
                   [](Heard& b) { b.monitor("011D940371000045").faults("02000000000007"); }, "error 7",
                   "It answered: Error 7."},
        HealthCase{"OperationalErrorWithoutCode", [](Heard& b) { b.monitor("011D940371000045"); },
                   "operational error, not asked", "It reports an operational error: ask for its faults."},
        HealthCase{"SensorErrorOfBothAxes", [](Heard& b) { b.monitor("01FFF4FFF4000000").faults(); },
                   "sensor error", "Sensor error: rotation, elevation."},
        HealthCase{"SensorErrorOfOneAxis", [](Heard& b) { b.monitor("01FFF40371000041").faults(); },
                   "sensor error", "Sensor error: rotation."},
        HealthCase{"Disabled", [](Heard& b) { b.monitor().faults().hear("18EFFF80", "834051"); }, "disabled",
                   "Enable is off: it cannot move."},
        HealthCase{"Late", [](Heard& b) { b.monitor().faults().pass(1s).hear("18EFFF80", kOutputs); }, "late",
                   "Late: Position / limit status, Rotation soft limits, Elevation soft limits."},
        HealthCase{"Silent", [](Heard& b) { b.monitor().pass(40s); }, "silent, not asked",
                   "Its periodic messages stopped 40 s ago."},
        HealthCase{"AnswerBeforeASilence", [](Heard& b) { b.monitor().faults().pass(93s).statuses(); },
                   "old answer", "No faults, asked 93 s ago, silent since."},
        HealthCase{"AnswerBeforeARestart",
                   [](Heard& b) {
                     b.monitor().faults("02002000000000").pass(2s).hear("18EFFF80", kAnnouncesA);
                     b.monitor();
                   },
                   "old answer", "Internal fuse, asked 2.0 s ago, restarted since."},
        HealthCase{"NoAnswer", [](Heard& b) { b.monitor().hear("18EF80F9", "02").pass(2s).statuses(); },
                   "no answer", "Asked for its faults 2.0 s ago, and no answer came."},
        HealthCase{"Idle", [](Heard& b) { b.hear("18EEFF21", kHigherForeignName).pass(1h); }, "idle",
                   "Last heard 1 h 00 min ago; no periodic message is expected of it."},
        HealthCase{"TwoAtOneAddress",
                   [](Heard& b) {
                     b.note({.value = note::LinkUp{}}).monitor().faults();
                     for (int i = 0; i < 9; ++i)
                       b.pass(50ms).hear("18EFFF80", i % 2 == 0 ? "0112C10644000041" : kPosition);
                     b.statuses();
                   },
                   "two at one address", "Two devices at one address: both send from 80 hex."},
        HealthCase{"TwoAtOneAddressOrALogThatHoldsItTwice",
                   [](Heard& b) {
                     b.monitor().faults();
                     for (int i = 0; i < 50; ++i) b.pass(50ms).statuses();
                   },
                   "two at one address",
                   "Two devices at one address: both send from 80 hex, or the log holds its frames twice."}),
    [](const auto& row) { return std::string(row.param.name); });

TEST(HealthSentences, SayOfASilentDeviceOnceThatItIsSilent) {
  Heard bus;
  bus.monitor().faults().pass(93s);
  const State& state = bus.state();
  EXPECT_EQ(healthSentences(deviceRows(state).front().health, state.cursor().time),
            (QStringList{QStringLiteral("Its periodic messages stopped 93 s ago."),
                         QStringLiteral("No faults, asked 93 s ago.")}));
}

TEST_F(DeviceTable, TellsEveryReasonWithoutAMouse) {
  m_bus.monitor("01FFF4FFF4000000").hear("18EFFF80", "834051");
  show();
  const QModelIndex health = m_model.index(0, Model::HealthColumn);
  EXPECT_EQ(
      health.data(Model::HealthWordsRole).toStringList(),
      (QStringList{QStringLiteral("sensor error"), QStringLiteral("disabled"), QStringLiteral("not asked")}));
  EXPECT_EQ(
      health.data(Qt::AccessibleTextRole).toString(),
      QStringLiteral("sensor error Sensor error: rotation, elevation. Enable is off: it cannot move. Its "
                     "faults were never asked."));
}

TEST_F(DeviceTable, SaysWhatIsNotListed) {
  EXPECT_EQ(untrackedText(m_bus.state()), QString());
  m_bus.hear("18EFFF80", kAnnouncesA, 4);
  show();
  EXPECT_EQ(text(0, Model::DeviceColumn), QString::fromLatin1(kPinA)) << "on the fifth channel";
  m_bus.hear("18EFFF80", kPosition, kMaxChannels).hear("18EFFF80", kPosition, kMaxChannels);
  EXPECT_EQ(untrackedText(m_bus.state()),
            QStringLiteral("2 frames on channels beyond the first 16: their devices are not listed"));
}

TEST_F(DeviceTable, KeepsTheRowWhenTheAddressChanges) {
  m_bus.monitor().hear("18EFFF90", kPosition);
  show();
  const QPersistentModelIndex row = m_model.index(0, 0);
  QSignalSpy inserted(&m_model, &Model::rowsInserted), removed(&m_model, &Model::rowsRemoved);
  m_bus.pass(2s).hear("18EFFF81", kAnnouncesA);
  show();
  EXPECT_TRUE(inserted.isEmpty());
  EXPECT_TRUE(removed.isEmpty());
  EXPECT_EQ(row.row(), 0);
  EXPECT_EQ(text(0, Model::AddressColumn), QStringLiteral("81"));
  EXPECT_TRUE(
      tooltip(0).contains(QStringLiteral("Address: 81 hex for 0.0 s\nBefore: 80 hex until 0.0 s ago")))
      << tooltip(0).toStdString();
}

TEST_F(DeviceTable, ShowsNoRowsOfAddressesThatADeviceLeft) {
  for (const char* id : {"18EFFF80", "18EFFF81", "18EFFF82", "18EFFF83", "18EFFF84", "18EFFF85"})
    m_bus.pass(1s).hear(id, kAnnouncesA);
  show();
  EXPECT_EQ(m_model.rowCount(), 1);
  m_bus.hear("18FF0081", "00");
  show();
  EXPECT_EQ(m_model.rowCount(), 2) << "somebody else is there now";
}

TEST_F(DeviceTable, SaysThatAnAddressWasLost) {
  m_bus.monitor().hear("18EEFF80", kLowerForeignName).pass(5s);
  show();
  ASSERT_EQ(m_model.rowCount(), 2);
  EXPECT_EQ(text(0, Model::AddressColumn), QStringLiteral("lost"));
  EXPECT_TRUE(tooltip(0).contains(QStringLiteral("lost 4.7 s ago, it was 80 hex")))
      << tooltip(0).toStdString();
  EXPECT_EQ(m_model.index(0, Model::AddressColumn).data(Qt::AccessibleTextRole).toString(),
            QStringLiteral("address lost"));
  EXPECT_EQ(text(1, Model::DeviceColumn), QStringLiteral("Address 80"));
  EXPECT_TRUE(tooltip(1).contains(QStringLiteral("0 won, 1 lost"))) << tooltip(1).toStdString();
}

TEST_F(DeviceTable, GivesAnAddressItsPinInPlace) {
  m_bus.hear("18EFFF80", kPosition).hear("18EFFF90", kPosition);
  show();
  QSignalSpy changed(&m_model, &Model::keyChanged), removed(&m_model, &Model::rowsRemoved);
  m_bus.hear("18EFFF80", kAnnouncesA);
  show();
  ASSERT_EQ(changed.size(), 1);
  EXPECT_EQ(changed[0][0].value<DeviceKey>(), DeviceKey::at(Channel{0}, Address{0x80}));
  EXPECT_EQ(changed[0][1].value<DeviceKey>(), keyOfA());
  EXPECT_TRUE(removed.isEmpty());
  EXPECT_EQ(m_model.rowOf(keyOfA()), 0);
}

TEST_F(DeviceTable, GivesANodeThatHadOnlyANameItsPinInPlace) {
  m_bus.hear("18EFFF90", kPosition).hear("18EEFF80", kNameOfA);
  show();
  QSignalSpy changed(&m_model, &Model::keyChanged), removed(&m_model, &Model::rowsRemoved);
  m_bus.hear("18EFFF80", kAnnouncesA);
  show();
  EXPECT_EQ(changed.size(), 1);
  EXPECT_TRUE(removed.isEmpty());
  EXPECT_EQ(m_model.rowCount(), 2);
}

TEST_F(DeviceTable, SaysWhoWasAtAnAddressBeforeTheLinkWasDown) {
  const auto note = [this](const NoteValue& value) { m_bus.note({.time = m_bus.now(), .value = value}); };
  note(note::LinkUp{});
  m_bus.monitor();
  show();
  QSignalSpy changed(&m_model, &Model::keyChanged), removed(&m_model, &Model::rowsRemoved);
  note(note::LinkDown{});
  m_bus.pass(90s);
  note(note::LinkUp{});
  m_bus.pass(5s);
  show();
  EXPECT_EQ(all(0), "was 1032AE100801035 | Monitor, type not known | 80 | 95 s | idle | 0/s | 5");
  ASSERT_EQ(changed.size(), 1);
  EXPECT_EQ(changed[0][0].value<DeviceKey>(), keyOfA());
  EXPECT_EQ(changed[0][1].value<DeviceKey>(), DeviceKey::at(Channel{0}, Address{0x80}));
  EXPECT_TRUE(tooltip(0).contains(QStringLiteral("PIN: was 1032AE100801035, before the link went down")))
      << tooltip(0).toStdString();
  EXPECT_TRUE(tooltip(0).contains(QStringLiteral("Before the link went down:\nNAME ")));
  EXPECT_TRUE(tooltip(0).contains(
      QStringLiteral("Not heard since the link came back 5.0 s ago; it may not be on this bus.")))
      << tooltip(0).toStdString();
  DeviceLabels labels;
  labels.set(*Pin::parse(kPinA), QStringLiteral("Roof"));
  m_model.setLabels(labels);
  EXPECT_TRUE(m_model.index(0, 0).data(Model::DetailRole).toString().startsWith(QStringLiteral("was Roof")));
  m_bus.hear("18EFFF80", kAnnouncesA);
  show();
  EXPECT_EQ(text(0, Model::DeviceColumn), QStringLiteral("Roof"));
  EXPECT_EQ(changed.size(), 2);
  EXPECT_TRUE(removed.isEmpty());
}

TEST_F(DeviceTable, ListsAJoystickWhoseMessagesHaveAWrongLength) {
  m_bus.hear("0CFDD633", "01000100");
  show();
  ASSERT_EQ(m_model.rowCount(), 1);
  EXPECT_EQ(all(0), "Address 33 | Joystick source | 33 | < 1 s | wrong length | 0/s | 1");
  EXPECT_EQ(m_model.index(0, 0).data(Model::GroupTextRole).toString(), QStringLiteral("Controls"));
}

TEST_F(DeviceTable, TellsOnlyWhatChanged) {
  m_bus.monitor();
  show();
  QSignalSpy changed(&m_model, &Model::dataChanged);
  show();
  EXPECT_TRUE(changed.isEmpty()) << "nothing happened";
  m_bus.pass(20ms);
  show();
  EXPECT_TRUE(changed.isEmpty()) << "an age that reads the same";
  m_bus.hear("18EFFF80", kOutputs);
  show();
  ASSERT_EQ(changed.size(), 1);
  EXPECT_EQ(changed[0][0].toModelIndex().column(), Model::FramesColumn);
}

TEST_F(DeviceTable, LetsAgesRunWithTheCursor) {
  m_bus.monitor().pass(1500ms);
  show();
  EXPECT_EQ(text(0, Model::AgeColumn), QStringLiteral("1.5 s"));
  m_bus.pass(1h);
  show();
  EXPECT_EQ(text(0, Model::AgeColumn), QStringLiteral("1 h 00 min"));
}

// Backwards too: rows come and go as the cursor moves, always as a model may.
TEST_F(DeviceTable, FollowsTheCursorBothWays) {
  Heard early;
  early.hear("18EFFF80", kPosition);
  m_bus.monitor().hear("18EEFF21", kHigherForeignName).hear("724", "05").hear("18EFFF90", kPosition);
  for (const bool late : {true, false, true, true, false}) {
    m_model.setView(late ? m_bus.view() : early.view());
    EXPECT_EQ(m_model.rowCount(), late ? 4 : 1);
    for (int row = 0; row < m_model.rowCount(); ++row) {
      EXPECT_EQ(m_model.keyAt(row),
                deviceRows(late ? m_bus.state() : early.state())[static_cast<std::size_t>(row)].key);
    }
  }
  m_model.setView({});
  EXPECT_EQ(m_model.rowCount(), 0);
}

TEST_F(DeviceTable, SaysWhatIsMissingWhereItIsEmpty) {
  EXPECT_TRUE(m_model.emptyText().startsWith(QStringLiteral("Nothing is open.")));
  show();
  EXPECT_TRUE(m_model.emptyText().startsWith(QStringLiteral("No device heard yet.")));
  m_bus.hear("7DF", "0201");
  m_bus.hear("7DF", "0201");
  show();
  EXPECT_EQ(m_model.rowCount(), 0);
  EXPECT_EQ(m_model.emptyText(), QStringLiteral("2 frames heard, none from a known device."));
}

TEST_F(DeviceTable, NamesTheChannelWhereThereAreSeveral) {
  m_bus.monitor();
  show();
  EXPECT_FALSE(tooltip(0).contains(QStringLiteral("can0")));
  m_bus.document().frames.channel("can1");
  show();
  EXPECT_TRUE(tooltip(0).contains(QStringLiteral("Channel: can0")));
}

TEST_F(DeviceTable, TellsTheNameInWords) {
  m_bus.monitor();
  show();
  for (const char* line : {"Maker: Akron Brass", "Function: 66", "Claim: claimed just now"})
    EXPECT_TRUE(tooltip(0).contains(QString::fromLatin1(line))) << tooltip(0).toStdString();
}

TEST_F(DeviceTable, CountsFramesASecond) {
  for (int i = 0; i < 20; ++i) m_bus.hear("18EFFF80", kPosition).pass(100ms);
  show();
  EXPECT_EQ(text(0, Model::RateColumn), QStringLiteral("10/s"));
  m_bus.pass(2s);
  show();
  EXPECT_EQ(text(0, Model::RateColumn), QStringLiteral("0/s"));
}

TEST_F(DeviceTable, PutsAPersonsLabelBeforeThePin) {
  m_bus.monitor();
  show();
  const auto detail = [&] { return m_model.index(0, 0).data(Model::DetailRole).toString(); };
  EXPECT_EQ(detail(), QStringLiteral("6032 Universal II"));
  DeviceLabels labels;
  labels.set(keyOfA().pin, QStringLiteral("Roof"));
  m_model.setLabels(labels);
  EXPECT_EQ(text(0, Model::DeviceColumn), QStringLiteral("Roof"));
  EXPECT_EQ(detail(), QStringLiteral("1032AE100801035 · 6032 Universal II"));
  EXPECT_TRUE(tooltip(0).startsWith(QStringLiteral("Roof (1032AE100801035) – 6032")));
  EXPECT_EQ(m_model.index(0, 0).data(Qt::AccessibleTextRole).toString(),
            QStringLiteral("Roof (1032AE100801035), 6032 Universal II, Monitors"));
}

TEST_F(DeviceTable, LetsALabelBeEditedWhereThereIsAPin) {
  m_bus.monitor().hear("724", "05");
  show();
  QSignalSpy edited(&m_model, &Model::labelEdited);
  EXPECT_TRUE((m_model.flags(m_model.index(0, 0)) & Qt::ItemIsEditable) != 0);
  EXPECT_FALSE((m_model.flags(m_model.index(0, Model::AgeColumn)) & Qt::ItemIsEditable) != 0);
  EXPECT_FALSE((m_model.flags(m_model.index(1, 0)) & Qt::ItemIsEditable) != 0) << "a node has no PIN";
  EXPECT_FALSE(m_model.setData(m_model.index(1, 0), QStringLiteral("x")));
  EXPECT_TRUE(m_model.setData(m_model.index(0, 0), QStringLiteral("Roof")));
  ASSERT_EQ(edited.size(), 1);
  EXPECT_EQ(edited[0][0].value<Pin>(), keyOfA().pin);
  EXPECT_EQ(text(0, 0), QString::fromLatin1(kPinA)) << "whoever keeps the labels gives them";
}

TEST_F(DeviceTable, TellsOnePinOnTwoChannelsApart) {
  m_bus.document().frames.channel("can1");
  m_bus.hear("18EFFF80", kAnnouncesA).hear("18EFFF90", kAnnouncesA, 1);
  show();
  ASSERT_EQ(m_model.rowCount(), 2);
  EXPECT_EQ(m_model.index(0, 0).data(Model::DetailRole).toString(),
            QStringLiteral("6032 Universal II · can0"));
  EXPECT_EQ(m_model.index(1, 0).data(Model::DetailRole).toString(),
            QStringLiteral("6032 Universal II · can1"));
  EXPECT_NE(m_model.keyAt(0), m_model.keyAt(1));
  EXPECT_EQ(text(1, Model::AddressColumn), QStringLiteral("90"));
}

TEST(DeviceLabelsTest, KeepOneLineAPin) {
  DeviceLabels labels;
  const Pin pin = keyOfA().pin;
  EXPECT_EQ(labels.of(pin), QString());
  EXPECT_TRUE(labels.set(pin, QStringLiteral("  Roof\n monitor ")));
  EXPECT_EQ(labels.of(pin), QStringLiteral("Roof monitor"));
  EXPECT_FALSE(labels.set(pin, QStringLiteral("Roof monitor"))) << "nothing changed";
  EXPECT_TRUE(labels.set(pin, QString(200, QLatin1Char('x'))));
  EXPECT_EQ(labels.of(pin).size(), DeviceLabels::kLongest);
  EXPECT_TRUE(labels.set(pin, QStringLiteral(" ")));
  EXPECT_TRUE(labels.all().isEmpty());
  EXPECT_FALSE(labels.set(Pin{}, QStringLiteral("x")));
}

class DeviceOrderTest : public DeviceTable {
 protected:
  void SetUp() override {
    m_order.setSourceModel(&m_model);
    m_bus.hear("18EEFF21", kHigherForeignName)
        .hear("724", "05")
        .hear("18EFFF92", kPosition)
        .pass(5s)
        .hear("18EFFF91", kPosition)
        .hear("0CFDD633", kRestingStick);
    show();
  }
  std::string order() const {
    std::string text;
    for (int row = 0; row < m_order.rowCount(); ++row)
      text += m_order.index(row, Model::AddressColumn).data().toString().toStdString() + ' ';
    return text;
  }
  DeviceOrder m_order;
  QAbstractItemModelTester m_orderTester{&m_order, QAbstractItemModelTester::FailureReportingMode::Fatal};
};

TEST_F(DeviceOrderTest, StandsInGroupsByFirstAppearance) {
  EXPECT_EQ(order(), "92 91 33 24 21 ");
  EXPECT_TRUE(m_order.startsGroup(0));
  EXPECT_FALSE(m_order.startsGroup(1));
  EXPECT_TRUE(m_order.startsGroup(2));
}

TEST_F(DeviceOrderTest, SortsWithinGroupsBothWays) {
  m_order.orderBy(Model::AddressColumn, Qt::AscendingOrder);
  EXPECT_EQ(order(), "91 92 33 24 21 ");
  m_order.orderBy(Model::AddressColumn, Qt::DescendingOrder);
  EXPECT_EQ(order(), "92 91 33 24 21 ");
  m_order.orderBy(Model::AgeColumn, Qt::AscendingOrder);
  EXPECT_EQ(order(), "91 92 33 24 21 ");
  m_order.orderBy(-1, Qt::AscendingOrder);
  EXPECT_EQ(order(), "92 91 33 24 21 ");
}

TEST_F(DeviceOrderTest, DoesNotMoveDevicesThatAreWellWhileTimePasses) {
  m_order.orderBy(Model::AgeColumn, Qt::AscendingOrder);
  m_bus.hear("18EFFF92", kPosition);
  show();
  const std::string before = order();
  for (int i = 0; i < 20; ++i) {
    m_bus.pass(50ms).hear(i % 2 == 0 ? "18EFFF91" : "18EFFF92", kPosition).hear("0CFDD633", kRestingStick);
    show();
    EXPECT_EQ(order(), before);
  }
}

TEST_F(DeviceOrderTest, ShowsOnlyWhatHasEveryWordOfTheFilter) {
  m_order.setFilter(QStringLiteral("MONITORS  91"));
  EXPECT_EQ(order(), "91 ");
  m_order.setFilter(QStringLiteral("node"));
  EXPECT_EQ(order(), "24 21 ");
  m_bus.hear("725", "05");
  show();
  EXPECT_EQ(order(), "24 25 21 ") << "newcomers are filtered too";
  m_order.setFilter(QStringLiteral("no such thing"));
  EXPECT_EQ(order(), "");
  m_order.setFilter({});
  EXPECT_EQ(order(), "92 91 33 24 25 21 ");
}

TEST_F(DeviceOrderTest, FindsADeviceByItsLabel) {
  m_bus.monitor();
  show();
  DeviceLabels labels;
  labels.set(keyOfA().pin, QStringLiteral("Roof"));
  m_order.setFilter(QStringLiteral("roof"));
  EXPECT_EQ(order(), "");
  m_model.setLabels(labels);
  EXPECT_EQ(order(), "80 ");
  m_order.setFilter(QStringLiteral("1032ae"));
  EXPECT_EQ(order(), "80 ") << "and still by its PIN";
}

TEST_F(DeviceOrderTest, PutsANewcomerIntoItsGroup) {
  m_bus.hear("18EFFF80", kPosition);
  show();
  EXPECT_EQ(order(), "92 91 80 33 24 21 ");
  // It turns out to be a joystick that answers like a monitor would not.
  m_bus.hear("18EFFF93", announcementOf("1035AB000000002"));
  show();
  EXPECT_EQ(order(), "92 91 80 93 33 24 21 ");
}

}  // namespace
}  // namespace deckpipe
