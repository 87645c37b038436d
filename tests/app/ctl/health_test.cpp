// SPDX-License-Identifier: GPL-3.0-or-later
// How devices are, as `deckpipectl info --devices` says it of a log.
#include <QJsonArray>

#include "run_ctl.h"

namespace {

// The devices of a log in candump's format: PIN or address, and health.
QStringList healthOf(const QByteArray& log) {
  QProcess process;
  process.start(QStringLiteral(DECKPIPECTL), deckpipe::test::words("info --devices --json -"));
  process.write(log);
  process.closeWriteChannel();
  EXPECT_TRUE(process.waitForFinished(60'000));
  const QJsonObject report = QJsonDocument::fromJson(deckpipe::test::outcomeOf(process).out).object();
  QStringList lines;
  for (const QJsonValue& device : report[QStringLiteral("devices")].toArray()) {
    lines << QStringLiteral("%1 %2 %3")
                 .arg(device[QStringLiteral("pin")].toString(), device[QStringLiteral("channel")].toString(),
                      device[QStringLiteral("health")].toString());
  }
  return lines;
}

const QByteArray kAnnounced = "(1700000000.0) can0 18EFFF80#FF83150206021A0B\n";
const QByteArray kStill = "(1700000000.1) can0 18EFFF80#011D940371000041\n";
const QByteArray kStatus = kStill + "(1700000000.1) can0 18EFFF80#83C051\n";
const QByteArray kAnswered = "(1700000000.2) can0 18EF80F9#02\n(1700000000.2) can0 18EFF980#02000000000000\n";

struct LogCase {
  const char* name;
  QByteArray log;
  QStringList devices;
};
class HealthOfALog : public testing::TestWithParam<LogCase> {};

TEST_P(HealthOfALog, IsTheKeyOfTheWorstCause) { EXPECT_EQ(healthOf(GetParam().log), GetParam().devices); }
INSTANTIATE_TEST_SUITE_P(
    Info, HealthOfALog,
    testing::Values(
        LogCase{
            "NeverAsked", kAnnounced + kStatus, {QStringLiteral("1032AE100801035 can0 faults_never_asked")}},
        LogCase{"Fine", kAnnounced + kStatus + kAnswered, {QStringLiteral("1032AE100801035 can0 fine")}},
        LogCase{"WhetherItIsEnabledWasNeverHeard",
                kAnnounced + kStill + kAnswered,
                {QStringLiteral("1032AE100801035 can0 status_never_heard")}},
        LogCase{"Disabled",
                kAnnounced + kStill + "(1700000000.1) can0 18EFFF80#834000\n" + kAnswered,
                {QStringLiteral("1032AE100801035 can0 disabled")}},
        LogCase{"Silent",
                kAnnounced + kStatus + kAnswered + "(1700000040.0) can0 18FEF100#FFFFFFFFFFFFFFFF\n",
                {QStringLiteral("1032AE100801035 can0 silent")}},
        LogCase{"OnTheFifthInterface",
                "(1.000000) can0 18FEF100#FF\n(1.000001) can1 18FEF101#FF\n(1.000002) can2 18FEF102#FF\n"
                "(1.000003) can3 18FEF103#FF\n(1.000005) can4 18EFFF80#FF83150206021A0B\n",
                {QStringLiteral("1032AE100801035 can4 faults_never_asked")}},
        LogCase{"TwoAtOneAddress",
                "(1700000000.000000) can0 18EEFF80#0B1AC22800420090\n"
                "(1700000000.001000) can0 18EFFF80#FF83150206021A0B\n"
                "(1700000000.500000) can0 18EEFF80#0C1AC22800420090\n"
                "(1700000000.501000) can0 18EFFF80#FF83150206021A0C\n"
                "(1700000000.600000) can0 18EFFF80#011D9412C4000041\n"
                "(1700000000.650000) can0 18EFFF80#0112C10644000041\n"
                "(1700000000.700000) can0 18EFFF80#011D9412C4000041\n"
                "(1700000000.750000) can0 18EFFF80#0112C10644000041\n"
                "(1700000000.800000) can0 18EFFF80#011D9412C4000041\n"
                "(1700000000.850000) can0 18EFFF80#0112C10644000041\n"
                "(1700000000.900000) can0 18EFFF80#011D9412C4000041\n"
                "(1700000000.950000) can0 18EFFF80#0112C10644000041\n",
                {QStringLiteral("1032AE100801035 can0 two_at_one_address"),
                 QStringLiteral("1032AE100801036 can0 two_at_one_address")}}),
    [](const auto& row) { return std::string(row.param.name); });

TEST(AnswerOfALog, IsSaidWithItsAgeAndWhyItIsOld) {
  QProcess process;
  process.start(QStringLiteral(DECKPIPECTL), deckpipe::test::words("info --devices -"));
  process.write(kAnnounced + kStatus + kAnswered + "(1700000093.2) can0 18FEF100#FFFFFFFFFFFFFFFF\n");
  process.closeWriteChannel();
  EXPECT_TRUE(process.waitForFinished(60'000));
  const QString out = QString::fromUtf8(deckpipe::test::outcomeOf(process).out);
  EXPECT_TRUE(out.contains(QStringLiteral("no faults, asked 93 s ago, silent\n"))) << out.toStdString();
}

TEST(AnswerOfALog, HasAKeyForWhyItIsOld) {
  QProcess process;
  process.start(QStringLiteral(DECKPIPECTL), deckpipe::test::words("info --devices --json -"));
  process.write(kAnnounced + kStatus + kAnswered + "(1700000093.2) can0 18FEF100#FFFFFFFFFFFFFFFF\n");
  process.closeWriteChannel();
  EXPECT_TRUE(process.waitForFinished(60'000));
  const QByteArray out = deckpipe::test::outcomeOf(process).out;
  EXPECT_TRUE(out.contains("\"faults_old\":\"silence\"")) << out.toStdString();
}

TEST(AnswerOfALog, HasNoAgeInALogWithoutTimes) {
  const QByteArray log =
      "can0  18EFFF80   [8]  FF 83 15 02 06 02 1A 0B\n"
      "can0  18EF80F9   [1]  02\n"
      "can0  18EFF980   [7]  02 00 00 00 00 00 00\n";
  const auto infoOf = [&log](const char* arguments) {
    QProcess process;
    process.start(QStringLiteral(DECKPIPECTL), deckpipe::test::words(arguments));
    process.write(log);
    process.closeWriteChannel();
    EXPECT_TRUE(process.waitForFinished(60'000));
    return deckpipe::test::outcomeOf(process).out;
  };
  const QByteArray text = infoOf("info --devices -");
  EXPECT_TRUE(text.contains("no faults, ")) << text.toStdString();
  EXPECT_FALSE(text.contains(" ago")) << text.toStdString();
  const QJsonObject report = QJsonDocument::fromJson(infoOf("info --devices --json -")).object();
  const QJsonObject device = report[QStringLiteral("devices")][0].toObject();
  EXPECT_TRUE(device.contains(QStringLiteral("faults_age")));
  EXPECT_TRUE(device[QStringLiteral("faults_age")].isNull());
}

}  // namespace
