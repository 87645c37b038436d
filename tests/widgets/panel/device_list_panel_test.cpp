// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/devices/device_list_panel.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QSignalSpy>
#include <QTest>
#include <QTreeView>

#include "model/device_model.h"
#include "support/child.h"
#include "support/look.h"
#include "widgets/panel/panel_scenes.h"

namespace deckpipe {
namespace {

using namespace test;

class DeviceListPanelTest : public testing::Test {
 protected:
  void SetUp() override {
    m_panel.resize(332, 600);
    m_panel.show();
    m_list = test::child<QTreeView>(m_panel, "deviceList");
    QObject::connect(&m_panel, &DeviceListPanel::deviceSelected,
                     [this](const DeviceKey& key) { m_view.device = key; });
  }
  void show() {
    m_view.log = m_bus.view();
    m_panel.setView(m_view);
    QCoreApplication::processEvents();
  }
  QPoint middleOf(const QString& device) const {
    const QAbstractItemModel* model = m_list->model();
    for (int row = 0; row < model->rowCount(); ++row) {
      const QModelIndex index = model->index(row, 0);
      // Below the heading that the first row of a group carries.
      if (index.data().toString() == device) return m_list->visualRect(index).bottomLeft() + QPoint(20, -20);
    }
    ADD_FAILURE() << device.toStdString();
    return {};
  }
  void click(const QString& device) {
    QTest::mouseClick(m_list->viewport(), Qt::LeftButton, {}, middleOf(device));
  }
  QString selectedText() const {
    const QModelIndexList rows = m_list->selectionModel()->selectedRows();
    return rows.isEmpty() ? QString() : rows.front().data().toString();
  }

  Heard m_bus;
  PanelView m_view;
  DeviceListPanel m_panel;
  QTreeView* m_list = nullptr;
  QSignalSpy m_chosen{&m_panel, &DeviceListPanel::deviceSelected};
};

TEST_F(DeviceListPanelTest, SaysWhatIsNotListed) {
  m_bus.monitor();
  show();
  auto* untracked = test::child<QLabel>(m_panel, "untrackedDevices");
  EXPECT_FALSE(untracked->isVisible());
  for (int i = 0; i < 90; ++i) {
    char id[16];
    std::snprintf(id, sizeof id, "18EFFF%02X", 0x81u + static_cast<unsigned>(i));
    m_bus.hear(id, kPosition);
  }
  show();
  EXPECT_TRUE(untracked->isVisible());
  EXPECT_TRUE(untracked->text().contains(QStringLiteral("beyond the first 80")))
      << untracked->text().toStdString();
}

TEST_F(DeviceListPanelTest, SaysWhatIsMissing) {
  const auto* empty = test::child<QLabel>(m_panel, "noDevices");
  EXPECT_TRUE(empty->isVisible());
  show();
  EXPECT_TRUE(empty->text().startsWith(QStringLiteral("No device heard yet.")))
      << empty->text().toStdString();
  m_bus.hear("7DF", "0201");
  show();
  EXPECT_EQ(empty->text(), QStringLiteral("One frame heard, not from a known device."));
  neighbours(m_bus);
  show();
  EXPECT_FALSE(empty->isVisible());
  EXPECT_TRUE(m_list->isVisible());
}

TEST_F(DeviceListPanelTest, ChoosesByMouse) {
  neighbours(m_bus.monitor());
  show();
  EXPECT_TRUE(m_chosen.isEmpty());
  click(QString::fromLatin1(kPinA));
  ASSERT_EQ(m_chosen.size(), 1);
  EXPECT_EQ(m_chosen[0][0].value<DeviceKey>(), keyOfA());
  click(QStringLiteral("Node 24"));
  ASSERT_EQ(m_chosen.size(), 2);
  EXPECT_EQ(m_view.device, DeviceKey::at(Channel{0}, NodeId{0x24}));
}

TEST_F(DeviceListPanelTest, ChoosesByKeyboardAndNotByFocus) {
  neighbours(m_bus.monitor());
  show();
  m_list->setFocus();
  QCoreApplication::processEvents();
  EXPECT_TRUE(m_chosen.isEmpty()) << "to have the focus is not to be chosen";
  QTest::keyClick(m_list, Qt::Key_Down);
  ASSERT_EQ(m_chosen.size(), 1);
  QTest::keyClick(m_list, Qt::Key_End);
  ASSERT_EQ(m_chosen.size(), 2);
  EXPECT_EQ(selectedText(), QStringLiteral("Address F9"));
}

TEST_F(DeviceListPanelTest, KeepsTheSelectionThroughAddressChangesAndUpdates) {
  neighbours(m_bus.monitor());
  show();
  click(QString::fromLatin1(kPinA));
  m_bus.pass(2s).hear("18EFFF84", kAnnouncesA).hear("18EFFF80", kAnnouncesB);
  show();
  EXPECT_EQ(selectedText(), QString::fromLatin1(kPinA));
  m_bus.hear("18EEFF84", kLowerForeignName).hear("18EFFF70", "0100");
  show();
  EXPECT_EQ(selectedText(), QString::fromLatin1(kPinA));
  EXPECT_EQ(m_chosen.size(), 1);
}

TEST_F(DeviceListPanelTest, FollowsADeviceThatSaysItsPin) {
  m_bus.hear("18EFFF90", kPosition).hear("18EFFF80", kPosition);
  show();
  click(QStringLiteral("No PIN, address 80"));
  m_bus.hear("18EFFF80", kAnnouncesA);
  show();
  ASSERT_EQ(m_chosen.size(), 2);
  EXPECT_EQ(m_chosen[1][0].value<DeviceKey>(), keyOfA());
  EXPECT_EQ(selectedText(), QString::fromLatin1(kPinA));
}

TEST_F(DeviceListPanelTest, ChoosesNobodyElseWhereTheDeviceIsNotHeardYet) {
  Heard early;
  early.hear("18EFFF90", kPosition);
  m_bus.hear("18EFFF90", kPosition).monitor();
  show();
  click(QString::fromLatin1(kPinA));
  m_view.log = early.view();
  m_panel.setView(m_view);
  EXPECT_EQ(selectedText(), QString());
  EXPECT_EQ(m_view.device, keyOfA());
  show();
  EXPECT_EQ(selectedText(), QString::fromLatin1(kPinA));
  EXPECT_EQ(m_chosen.size(), 1);
}

TEST_F(DeviceListPanelTest, SortsByItsHeaderAndBack) {
  m_bus.hear("18EFFF95", kPosition).hear("18EFFF93", kPosition).hear("18EFFF94", kPosition);
  show();
  auto* header = test::child<QHeaderView>(*m_list, "deviceListHeader");
  EXPECT_GE(header->height(), 32);
  const auto order = [&] {
    QStringList text;
    for (int row = 0; row < 3; ++row)
      text << m_list->model()->index(row, DeviceModel::AddressColumn).data().toString();
    return text.join(QLatin1Char(' '));
  };
  const auto clickHeader = [&] {
    const int x = header->sectionViewportPosition(DeviceModel::AddressColumn) + 20;
    QTest::mouseClick(header->viewport(), Qt::LeftButton, {}, QPoint(x, 16));
  };
  EXPECT_EQ(order(), QStringLiteral("95 93 94"));
  clickHeader();
  EXPECT_EQ(order(), QStringLiteral("93 94 95"));
  clickHeader();
  EXPECT_EQ(order(), QStringLiteral("95 94 93"));
  clickHeader();
  EXPECT_EQ(order(), QStringLiteral("95 93 94"));
}

TEST_F(DeviceListPanelTest, HasRowsForGlovesAndNamesForReaders) {
  neighbours(m_bus.monitor());
  show();
  const QAbstractItemModel* model = m_list->model();
  for (int row = 0; row < model->rowCount(); ++row)
    EXPECT_GE(m_list->visualRect(model->index(row, 0)).height(), 44) << row;
  EXPECT_EQ(model->index(0, 0).data(Qt::AccessibleTextRole).toString(),
            QStringLiteral("1032AE100801035, 6032 Universal II, Monitors"));
  for (const QWidget* w : m_panel.findChildren<QWidget*>()) {
    if (w->metaObject()->className() == QByteArray("QWidget") ||
        w->objectName().startsWith(QStringLiteral("qt_")) || w->inherits("QScrollBar"))
      continue;
    EXPECT_FALSE(w->objectName().isEmpty()) << w->metaObject()->className();
  }
  EXPECT_FALSE(m_list->accessibleName().isEmpty());
}

// A PIN is never cut, in either density, and nothing else needs more than the width that there is.
TEST_F(DeviceListPanelTest, NeedsNoMoreThanItsWidth) {
  neighbours(m_bus.monitor());
  for (const Density density : {Density::Desk, Density::Field}) {
    const test::Look look(Theme::Light, density);
    show();
    for (const int more : {0, 60, 240}) {
      m_panel.resize(m_panel.minimumSizeHint().width() + more, 600);
      QCoreApplication::processEvents();
      const auto* header = test::child<QHeaderView>(*m_list, "deviceListHeader");
      EXPECT_LE(header->length(), m_list->viewport()->width());
      const int pin = m_list->fontMetrics().horizontalAdvance(QString::fromLatin1(kPinA)) + 16;
      EXPECT_GE(header->sectionSize(DeviceModel::DeviceColumn), pin) << m_panel.width();
      EXPECT_FALSE(header->isSectionHidden(DeviceModel::AddressColumn));
      EXPECT_FALSE(header->isSectionHidden(DeviceModel::HealthColumn));
    }
    EXPECT_LE(m_panel.minimumSizeHint().width(), 360) << "beside a dial at 1024 pixels";
  }
}

TEST_F(DeviceListPanelTest, FiltersByTypingAndShowsAllAgainOnEscape) {
  neighbours(m_bus.monitor());
  show();
  click(QString::fromLatin1(kPinA));
  const int all = m_list->model()->rowCount();
  auto* filter = test::child<QLineEdit>(m_panel, "deviceFilter");
  EXPECT_GE(filter->height(), 32);
  m_panel.activateWindow();
  m_list->setFocus();
  QTest::keyClick(m_list, Qt::Key_F, Qt::ControlModifier);
  EXPECT_TRUE(filter->hasFocus());
  QTest::keyClicks(filter, QStringLiteral("forestry"));
  EXPECT_EQ(m_list->model()->rowCount(), 1);
  EXPECT_EQ(selectedText(), QString());
  EXPECT_EQ(m_view.device, keyOfA()) << "filtered away, it stays chosen";
  EXPECT_EQ(m_chosen.size(), 1);
  QTest::keyClicks(filter, QStringLiteral(" of nowhere"));
  const auto* empty = test::child<QLabel>(m_panel, "noDevices");
  EXPECT_TRUE(empty->isVisible());
  EXPECT_EQ(empty->text(), QStringLiteral("No device matches “forestry of nowhere”."));
  show();
  EXPECT_TRUE(empty->isVisible()) << "a tick changes nothing";
  QTest::keyClick(filter, Qt::Key_Escape);
  EXPECT_EQ(m_list->model()->rowCount(), all);
  EXPECT_TRUE(m_list->hasFocus());
  EXPECT_EQ(selectedText(), QString::fromLatin1(kPinA));
}

TEST_F(DeviceListPanelTest, EditsALabelInPlaceByKeyboard) {
  neighbours(m_bus.monitor());
  show();
  QSignalSpy edited(&m_panel, &DeviceListPanel::labelEdited);
  click(QString::fromLatin1(kPinA));
  QTest::keyClick(m_list, Qt::Key_F2);
  auto* editor = test::child<QLineEdit>(*m_list, "labelEditor");
  EXPECT_EQ(editor->accessibleName(), QStringLiteral("Label of 1032AE100801035"));
  EXPECT_GE(editor->height(), 32);
  EXPECT_GE(editor->width(), 120);
  QTest::keyClicks(editor, QStringLiteral("Roof"));
  m_bus.pass(1s);
  show();
  EXPECT_EQ(editor->text(), QStringLiteral("Roof")) << "values run on while a person types";
  QTest::keyClick(editor, Qt::Key_Return);
  QCoreApplication::processEvents();  // the delegate commits from its queue
  ASSERT_EQ(edited.size(), 1);
  EXPECT_EQ(edited[0][0].value<Pin>(), keyOfA().pin);
  EXPECT_EQ(edited[0][1].toString(), QStringLiteral("Roof"));
  m_view.labels.set(keyOfA().pin, QStringLiteral("Roof"));
  show();
  EXPECT_EQ(selectedText(), QStringLiteral("Roof"));
  EXPECT_EQ(m_chosen.size(), 1);
}

TEST_F(DeviceListPanelTest, EditsNoLabelOfWhatHasNoPin) {
  neighbours(m_bus.monitor());
  show();
  click(QStringLiteral("Node 24"));
  QTest::keyClick(m_list, Qt::Key_F2);
  EXPECT_EQ(m_list->findChild<QLineEdit*>(QStringLiteral("labelEditor")), nullptr);
}

// A row that gets the focus asks for its first cell alone.
TEST_F(DeviceListPanelTest, PaintsTheWordsOfTheHealthIntoEveryCellThatTheyReach) {
  neighbours(m_bus.monitor());
  m_panel.resize(240, 600);
  show();
  m_list->setFocus();
  click(QString::fromLatin1(kPinA));
  QWidget* rows = m_list->viewport();
  const QModelIndex device = m_list->selectionModel()->selectedRows(DeviceModel::DeviceColumn).front();
  const QRect cell = m_list->visualRect(device);
  const auto painted = [&](const QRegion& region) {
    QImage image(rows->size(), QImage::Format_RGB32);
    rows->render(&image, region.boundingRect().topLeft(), region);
    return image.copy(cell);
  };
  EXPECT_EQ(painted(cell), painted(rows->rect()));
}

TEST_F(DeviceListPanelTest, SortsAndCopiesFromItsMenu) {
  m_bus.hear("18EFFF95", kPosition).hear("18EFFF93", kPosition).monitor();
  show();
  click(QString::fromLatin1(kPinA));
  Q_EMIT m_list->customContextMenuRequested(QPoint(10, 10));
  auto* menu = test::child<QMenu>(m_panel, "deviceMenu");
  EXPECT_TRUE(menu->isVisible());
  for (QAction* action : menu->actions()) {
    if (action->objectName() == QStringLiteral("copyDeviceAction")) action->trigger();
  }
  EXPECT_EQ(QApplication::clipboard()->text(), QString::fromLatin1(kPinA));
  const auto* sorts = test::child<QMenu>(m_panel, "deviceSortMenu");
  const auto first = [&] { return m_list->model()->index(0, DeviceModel::AddressColumn).data().toString(); };
  QAction* byAddress = sorts->actions()[1 + DeviceModel::AddressColumn];
  EXPECT_EQ(byAddress->text(), QStringLiteral("Addr."));
  byAddress->trigger();
  EXPECT_EQ(first(), QStringLiteral("80"));
  byAddress->trigger();
  EXPECT_EQ(first(), QStringLiteral("95")) << "again: the other way round";
  menu->close();
}

}  // namespace
}  // namespace deckpipe
