// SPDX-License-Identifier: GPL-3.0-or-later
#include "link/virtual_bus.h"

#include <gtest/gtest.h>

#include <QSet>
#include <QTcpSocket>
#include <QTest>
#include <QUrl>
#include <memory>
#include <vector>

#include "support/patience.h"

namespace deckpipe {
namespace {

// A client that speaks the plugin's protocol by hand.
struct Client {
  explicit Client(const VirtualBus& bus) {
    const QUrl url(bus.interfaceName(0));
    socket.connectToHost(url.host(), static_cast<quint16>(url.port()));
  }
  void say(const QByteArray& lines) { socket.write(lines); }
  bool hears(const QByteArray& expected) {
    return QTest::qWaitFor(
               [&] {
                 heard += socket.readAll();
                 return heard.size() >= expected.size();
               },
               kPatience) &&
           heard == expected;
  }
  bool isLetGo() {
    return QTest::qWaitFor([&] { return socket.state() == QAbstractSocket::UnconnectedState; }, kPatience);
  }
  QTcpSocket socket;
  QByteArray heard;
};

struct VirtualBusTest : ::testing::Test {
  void SetUp() override { ASSERT_TRUE(bus.start()); }
  bool waitForClients(int channel, int count) {
    return QTest::qWaitFor([&] { return bus.clients(channel) == count; }, kPatience);
  }
  VirtualBus bus;
};

TEST_F(VirtualBusTest, EveryBusHasAPortOfItsOwn) {
  std::vector<std::unique_ptr<VirtualBus>> buses;
  QSet<QString> names;
  for (int i = 0; i < 50; ++i) {
    buses.push_back(std::make_unique<VirtualBus>());
    ASSERT_TRUE(buses.back()->start());
    names.insert(buses.back()->interfaceName(0));
  }
  EXPECT_EQ(names.size(), 50);
}

TEST_F(VirtualBusTest, HasNoNameUnlessStarted) {
  EXPECT_TRUE(VirtualBus().interfaceName(0).isEmpty());
  bus.stop();
  EXPECT_TRUE(bus.interfaceName(0).isEmpty());
}

TEST_F(VirtualBusTest, OthersGetTheFrameAndTheSenderItsEcho) {
  Client one(bus), two(bus);
  one.say("connect:can0\n");
  two.say("connect:can0\n");
  ASSERT_TRUE(waitForClients(0, 2));
  one.say("can0:291#X#0102\n");
  EXPECT_TRUE(two.hears("291#X#0102\n"));
  EXPECT_TRUE(one.hears("291#XL#0102\n"));
}

TEST_F(VirtualBusTest, AnEchoMarkOfTheSenderIsNotPassedOn) {
  Client one(bus), two(bus);
  one.say("connect:can0\n");
  two.say("connect:can0\n");
  ASSERT_TRUE(waitForClients(0, 2));
  one.say("can0:1#RL#\n");
  EXPECT_TRUE(two.hears("1#R#\n"));
}

TEST_F(VirtualBusTest, LinesMayComeInPiecesAndSeveralAtOnce) {
  Client one(bus), two(bus);
  two.say("connect:can1\n");
  one.say("connect:ca");
  ASSERT_TRUE(waitForClients(1, 1));
  one.say("n1\ncan1:1##\ncan1:2##\nca");
  EXPECT_TRUE(two.hears("1##\n2##\n"));
  one.say("n1:3##\n");
  EXPECT_TRUE(two.hears("1##\n2##\n3##\n"));
}

// Qt's client takes three parts for granted, so nothing else may reach it.
TEST_F(VirtualBusTest, WhatIsNoFrameIsRefusedAndCounted) {
  Client one(bus), two(bus);
  one.say("connect:can0\n");
  two.say("connect:can0\n");
  ASSERT_TRUE(waitForClients(0, 2));
  one.say("\nGET / HTTP/1.1\ncan0:1\ncan0:1#\ncan0:1#2#3#4\ncan7:1##\nconnect:can9\ncan0:5##\n");
  EXPECT_TRUE(two.hears("5##\n"));
  EXPECT_EQ(bus.refusedLines(), 7);
}

TEST_F(VirtualBusTest, AnEndlessLineIsLetGo) {
  Client one(bus);
  one.say(QByteArray(10'000, 'x'));
  EXPECT_TRUE(one.isLetGo());
}

TEST_F(VirtualBusTest, LeavingAndStoppingCloseTheConnection) {
  Client one(bus), two(bus);
  one.say("connect:can0\n");
  two.say("connect:can0\n");
  ASSERT_TRUE(waitForClients(0, 2));
  one.say("disconnect:can0\n");
  EXPECT_TRUE(one.isLetGo());
  ASSERT_TRUE(waitForClients(0, 1));
  bus.stop();
  EXPECT_TRUE(two.isLetGo());
  EXPECT_EQ(bus.clients(0), 0);
  EXPECT_TRUE(bus.start());
}

}  // namespace
}  // namespace deckpipe
