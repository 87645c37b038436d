// SPDX-License-Identifier: GPL-3.0-or-later
// What a person does with a whole log: saves it, marks places in it, finds it again.
#include <QFileDialog>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>

#include "app/console/window_test.h"
#include "console/kept_settings.h"
#include "console/log_filters.h"
#include "console/workspace.h"
#include "log/journal_file.h"
#include "log/journal_reader.h"
#include "model/event_model.h"
#include "panel/connect/connection_page.h"
#include "panel/devices/device_list_panel.h"
#include "panel/events/event_panel.h"
#include "panel/trace/trace_panel.h"

namespace deckpipe {
namespace {

using test::kPatience;
using test::kTruck;

class LogActions : public test::WindowTest {
 protected:
  void SetUp() override {
    QSettings().clear();
    WindowTest::SetUp();
  }
  QByteArray read(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }
  // At the cursor; until it is in its file, or is known not to be.
  void mark(const char* words) {
    m_session.mark(m_session.snapshot().view.cursor, QString::fromLatin1(words));
    ASSERT_TRUE(QTest::qWaitFor([&] { return !m_session.snapshot().source.isKeepingMarks; }, kPatience));
  }
  bool saveSays(const char* words) {
    return QTest::qWaitFor([&] { return text("saveText").contains(QLatin1String(words)); }, kPatience);
  }
};

TEST_F(LogActions, SaveTheWholeLogAsItWasRead) {
  openLog(kTruck);
  const QString path = m_dir.filePath(QStringLiteral("saved.log"));
  m_window.saveLog(path);
  ASSERT_TRUE(QTest::qWaitFor([&] { return text("saveText").startsWith(QStringLiteral("Saved 3 frames")); },
                              kPatience));
  EXPECT_EQ(read(path), QByteArray(kTruck).replace("(10", "(0000000010"));
  QTest::mouseClick(named<QPushButton>("saveButton"), Qt::LeftButton);
  EXPECT_FALSE(named<QWidget>("saveBar")->isVisible());
}

TEST_F(LogActions, ASecondSaveWaitsForTheFirst) {
  openLog(kTruck);
  const QString first = m_dir.filePath(QStringLiteral("first.log"));
  const QString second = m_dir.filePath(QStringLiteral("second.log"));
  m_window.saveLog(first);
  m_window.saveLog(second);
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return text("saveText").startsWith(QStringLiteral("Saved 3 frames to ") + second); }, kPatience))
      << qPrintable(text("saveText"));
  EXPECT_EQ(read(first), read(second));
  EXPECT_FALSE(read(first).isEmpty());
}

TEST_F(LogActions, QuittingAsksOnlyWhereWorkWouldBeLost) {
  openLog(kTruck);
  Snapshot unlocked = m_session.snapshot();
  auto services = std::make_shared<ServiceStatus>();
  services->locked = false;
  unlocked.services = services;
  m_window.setSnapshot(unlocked);
  const auto answer = [this](QMessageBox::ButtonRole role) {
    auto* question = named<QMessageBox>("quitQuestion");
    EXPECT_TRUE(question->text().contains(QStringLiteral("unlocked")));
    for (QAbstractButton* button : question->buttons())
      if (question->buttonRole(button) == role) button->click();
  };
  EXPECT_FALSE(m_window.close());
  answer(QMessageBox::RejectRole);
  EXPECT_TRUE(m_window.isVisible());
  ASSERT_TRUE(QTest::qWaitFor([&] { return m_window.findChild<QMessageBox*>() == nullptr; }, kPatience));
  m_window.setSnapshot(m_session.snapshot());
  EXPECT_TRUE(m_window.close()) << "a log at rest is no work";
  m_window.show();
  m_window.setSnapshot(unlocked);
  EXPECT_FALSE(m_window.close());
  answer(QMessageBox::DestructiveRole);
  EXPECT_FALSE(m_window.isVisible());
}

TEST_F(LogActions, AFileThatCannotBeReadLeavesTheOpenLogAndIsSaid) {
  openLog(kTruck);
  m_session.openLog(writeLog("no log\n", QStringLiteral("other.log")));
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return text("noticeText").contains(QStringLiteral("other.log cannot be read")); }, kPatience));
  EXPECT_EQ(m_session.snapshot().view.frameCount, 3u);
  EXPECT_TRUE(m_window.windowTitle().startsWith(QStringLiteral("truck.log")));
  QTest::mouseClick(named<QPushButton>("noticeClose"), Qt::LeftButton);
  EXPECT_EQ(text("noticeText"), QString()) << "it was read";
  EXPECT_FALSE(named<QPushButton>("noticeClose")->isVisible());
}

TEST_F(LogActions, SaveWhatIsSelectedInTheTraceOrPassesItsFilter) {
  openLog(kTruck);
  const QList<QByteArray> lines = QByteArray(kTruck).replace("(10", "(0000000010").split('\n');
  const QString path = m_dir.filePath(QStringLiteral("part.log"));
  const auto saveBy = [&](const char* action, const char* done) {
    QFile::remove(path);
    trigger(action);
    auto* dialog = named<QFileDialog>("fileDialog");
    Q_EMIT dialog->fileSelected(path);
    delete dialog;
    ASSERT_TRUE(QTest::qWaitFor([&] { return text("saveText").startsWith(QLatin1String(done)); }, kPatience))
        << qPrintable(text("saveText"));
  };
  auto* trace = only<TracePanel>();
  trace->setFilter(QStringLiteral("name~position"));
  // What tells who is at address 80 comes first.
  const auto added = [&](int line) {
    return lines[line].left(lines[line].indexOf(')')) + lines[0].mid(lines[0].indexOf(')'));
  };
  saveBy("saveShownAction", "Saved 2 frames");
  EXPECT_EQ(read(path), added(1) + '\n' + lines[1] + '\n' + lines[2] + '\n');
  EXPECT_TRUE(text("saveText").contains(QStringLiteral("were added to them")))
      << qPrintable(text("saveText"));
  EXPECT_TRUE(read(path + QStringLiteral(".deckpipe-notes")).contains("filtered text=\"name~position\""));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !trace->model()->isFiltering(); }, kPatience));
  QTest::keyClick(trace->view(), Qt::Key_End);
  saveBy("saveSelectionAction", "Saved 1 frame");
  EXPECT_EQ(read(path), added(2) + '\n' + lines[2] + '\n');
  trace->setFilter({});
  QTest::keyClick(trace->view(), Qt::Key_Home);
  QTest::keyClick(trace->view(), Qt::Key_Down, Qt::ShiftModifier);
  saveBy("saveSelectionAction", "Saved 2 frames");
  EXPECT_EQ(read(path), lines[0] + '\n' + lines[1] + '\n');
  EXPECT_FALSE(QFile::exists(path + QStringLiteral(".deckpipe-notes"))) << "nothing was added";
}

TEST_F(LogActions, MarksAndLabelsComeBackWithASavedLogAndTheirOwnerKeepsHis) {
  openLog(kTruck);
  const Pin pin = *Pin::parse("1032AE100801035");
  SettingsLabels storage;
  DeviceLabels own;
  m_session.seekFrames(2);
  m_session.mark(m_session.snapshot().view.cursor, QStringLiteral("valve opened"));
  Q_EMIT only<DeviceListPanel>()->labelEdited(pin, QStringLiteral("front bumper"));
  const QString path = m_dir.filePath(QStringLiteral("mine.log"));
  m_window.saveLog(path);
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return text("saveText").contains(QStringLiteral("mine.log.deckpipe-notes")); }, kPatience));
  // Another person's computer.
  Q_EMIT only<DeviceListPanel>()->labelEdited(pin, {});
  const auto labelShown = [&] { return only<Workspace>()->labels().of(pin).toStdString(); };
  EXPECT_EQ(labelShown(), "");
  m_session.openLog(path);
  ASSERT_TRUE(QTest::qWaitFor([&] { return labelShown() == "front bumper"; }, kPatience));
  EXPECT_EQ(storage.read(), own) << "seen, not remembered";
  const auto notes = m_session.snapshot().view.document->notes.all();
  EXPECT_TRUE(std::ranges::any_of(notes, [](const Note& note) {
    return note.frame == 2 && note.value == NoteValue(note::Mark{"valve opened"});
  }));
  Q_EMIT only<DeviceListPanel>()->labelEdited(pin, QStringLiteral("my own"));
  EXPECT_EQ(labelShown(), "my own");
  Q_EMIT only<DeviceListPanel>()->labelEdited(pin, {});
  EXPECT_EQ(labelShown(), "front bumper");
  m_session.openLog(writeLog(kTruck, QStringLiteral("other.log")));
  EXPECT_TRUE(QTest::qWaitFor([&] { return labelShown().empty(); }, kPatience)) << "no other log's";
}

TEST_F(LogActions, ALabelThatIsGivenDuringARecordingIsNotedInIt) {
  const Pin pin = *Pin::parse("1032AE100801035");
  Q_EMIT only<DeviceListPanel>()->labelEdited(pin, QStringLiteral("before"));
  m_session.openDemo();
  const auto noted = [&] {
    QStringList texts;
    if (const auto& document = m_session.snapshot().view.document) {
      for (const Note& note : document->notes.all())
        if (const auto* label = std::get_if<note::Label>(&note.value))
          texts += QString::fromStdString(label->text.str());
    }
    return texts;
  };
  ASSERT_TRUE(QTest::qWaitFor([&] { return !noted().isEmpty(); }, kPatience));
  Q_EMIT only<DeviceListPanel>()->labelEdited(pin, QStringLiteral("front bumper"));
  EXPECT_EQ(noted(), (QStringList{QStringLiteral("before"), QStringLiteral("front bumper")}));
  Q_EMIT only<DeviceListPanel>()->labelEdited(pin, {});
  EXPECT_EQ(noted().size(), 3);
  EXPECT_TRUE(only<Workspace>()->labels().of(pin).isEmpty()) << "the log's own has gone as well";
}

TEST_F(LogActions, ASidecarThatDoesNotFitIsSaidWithItsLine) {
  const QString path = writeLog(kTruck);
  QFile sidecar(path + QStringLiteral(".deckpipe-notes"));
  ASSERT_TRUE(sidecar.open(QIODevice::WriteOnly));
  sidecar.write("Deckpipe notes 1\nframes 3\n");
  sidecar.close();
  m_session.openLog(path);
  ASSERT_TRUE(QTest::qWaitFor([&] { return text("noticeText").contains(QStringLiteral("are left out")); },
                              kPatience));
  EXPECT_TRUE(text("noticeText").contains(QStringLiteral("truck.log.deckpipe-notes, line 3")))
      << qPrintable(text("noticeText"));
  EXPECT_EQ(m_session.snapshot().view.frameCount, 3u);
}

TEST_F(LogActions, OfferToSaveAPartOnlyWhereThereIsOne) {
  openLog(kTruck);
  const auto isOffered = [this](const char* action) {
    Q_EMIT only<QMenuBar>()->actions().first()->menu()->aboutToShow();
    return named<QAction>(action)->isEnabled();
  };
  EXPECT_FALSE(isOffered("saveSelectionAction"));
  EXPECT_FALSE(isOffered("saveShownAction"));
  only<TracePanel>()->setFilter(QStringLiteral("sa=80"));
  only<TracePanel>()->setCurrentFrame(1);
  EXPECT_TRUE(isOffered("saveSelectionAction"));
  EXPECT_TRUE(isOffered("saveShownAction"));
}

TEST_F(LogActions, SayWhyALogCannotBeSaved) {
  openLog(kTruck);
  m_window.saveLog(m_dir.filePath(QStringLiteral("absent/saved.log")));
  ASSERT_TRUE(QTest::qWaitFor([&] { return text("saveText").contains(QStringLiteral("cannot be saved")); },
                              kPatience));
  const MadeJournalFile growing = createJournalFile(m_dir.filePath(QStringLiteral("growing")).toStdString());
  ASSERT_TRUE(growing);
  m_window.saveLog(QString::fromStdString(growing.value()->path()));
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return text("saveText").contains(QStringLiteral("a recording that goes on")); }, kPatience));
}

TEST_F(LogActions, KeepAMarkWithItsWordsAtTheCursor) {
  openLog(kTruck);
  m_session.seekFrames(2);
  QTest::keyClick(&m_window, Qt::Key_M, Qt::ControlModifier);
  auto* words = named<QLineEdit>("markText");
  ASSERT_TRUE(words->isVisible());
  QTest::keyClicks(words, QStringLiteral("valve opened"));
  QTest::keyClick(words, Qt::Key_Return);
  EXPECT_FALSE(words->isVisible());
  const auto notes = m_session.snapshot().view.document->notes.all();
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0].value, NoteValue(note::Mark{"valve opened"}));
  EXPECT_EQ(notes[0].frame, 2u);
  EXPECT_EQ(notes[0].time, Instant{10'100'000'000});
  EXPECT_EQ(only<EventPanel>()->model()->rowCount(), 1);
}

TEST_F(LogActions, GoFromEventToEventByKeys) {
  openLog(
      "(10.000000) can0 18EFFF80#83C051\n(20.000000) can0 18EFFF80#834051\n(21.000000) can0 18EFFF80#83C051\n"
      "(22.000000) can0 18EFFF80#83C051\n");
  // The silence before 20 s, its end, disabled, enabled.
  ASSERT_TRUE(QTest::qWaitFor([&] { return only<EventPanel>()->model()->rowCount() == 4; }, kPatience));
  const auto cursor = [&] { return m_session.snapshot().view.cursor.time; };
  QTest::keyClick(&m_window, Qt::Key_F8, Qt::ShiftModifier);
  EXPECT_EQ(cursor(), Instant{21'000'000'000});
  QTest::keyClick(&m_window, Qt::Key_F8, Qt::ShiftModifier);
  EXPECT_EQ(cursor(), Instant{20'000'000'000});
  QTest::keyClick(&m_window, Qt::Key_F9);
  EXPECT_EQ(cursor(), Instant{15'000'000'000});
  QTest::keyClick(&m_window, Qt::Key_F8);
  EXPECT_EQ(cursor(), Instant{20'000'000'000});
}

TEST_F(LogActions, AskOnEveryWayOutBeforeMarksAreLostThatNoFileTakes) {
  ASSERT_TRUE(QDir().mkdir(m_dir.filePath(QStringLiteral("truck.log.deckpipe-notes"))));
  openLog(kTruck);
  EXPECT_TRUE(
      text("noticeText").contains(QStringLiteral("truck.log.deckpipe-notes): Deckpipe's file of notes")))
      << qPrintable(text("noticeText"));
  m_session.mark(m_session.snapshot().view.cursor, QStringLiteral("valve opened"));
  EXPECT_TRUE(m_session.snapshot().source.unkeptMarks);
  const QString other = writeLog(kTruck, QStringLiteral("other.log"));
  const auto drop = [&] {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(other)});
    QDragEnterEvent enter(QPoint(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&m_window, &enter);
    QDropEvent event(QPointF(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&m_window, &event);
  };
  auto* page = only<ConnectionPage>();
  auto* bar = only<NoticeBar>();
  const auto answer = [this](const char* name, QMessageBox::ButtonRole role) {
    auto* question = named<QMessageBox>(name);
    ASSERT_TRUE(question);
    EXPECT_TRUE(question->text().contains(QStringLiteral("Marks"))) << qPrintable(question->text());
    for (QAbstractButton* button : question->buttons())
      if (question->buttonRole(button) == role) button->click();
    ASSERT_TRUE(QTest::qWaitFor([&] { return m_window.findChild<QMessageBox*>() == nullptr; }, kPatience));
  };
  for (const auto& [name, act] : std::initializer_list<std::pair<const char*, std::function<void()>>>{
           {"close", [&] { trigger("closeAction"); }},
           {"another log", [&] { Q_EMIT page->logRequested(other); }},
           {"a dropped log", drop},
           {"the demo", [&] { Q_EMIT page->demoRequested(); }},
           {"a link", [&] { Q_EMIT page->connectRequested(QStringLiteral("none"), QStringLiteral("x"), 0); }},
           {"connect again", [&] { Q_EMIT bar->actionRequested(Notice::Action::Reconnect); }},
           {"add up times", [&] { Q_EMIT bar->actionRequested(Notice::Action::AddUpTimes); }}}) {
    SCOPED_TRACE(name);
    const auto open = m_session.snapshot().view.document;
    act();
    answer("leaveQuestion", QMessageBox::RejectRole);
    EXPECT_EQ(m_session.snapshot().view.document, open);
  }
  EXPECT_FALSE(m_window.close()) << "quitting asks as well";
  answer("quitQuestion", QMessageBox::RejectRole);
  trigger("closeAction");
  answer("leaveQuestion", QMessageBox::DestructiveRole);
  EXPECT_FALSE(m_session.snapshot().view.document);
}

TEST_F(LogActions, MarksThatWereSavedElsewhereAreNotSaidToBeLost) {
  QFile sidecar(m_dir.filePath(QStringLiteral("truck.log.deckpipe-notes")));
  ASSERT_TRUE(sidecar.open(QIODevice::WriteOnly));
  sidecar.write("of somebody else\n");
  sidecar.close();
  openLog(kTruck);
  mark("valve opened");
  EXPECT_TRUE(text("noticeText").contains(QStringLiteral("in memory alone")));
  m_window.saveLog(m_dir.filePath(QStringLiteral("mine.log")));
  ASSERT_TRUE(saveSays("mine.log.deckpipe-notes"));
  EXPECT_FALSE(text("noticeText").contains(QStringLiteral("in memory alone")))
      << qPrintable(text("noticeText"));
  EXPECT_TRUE(m_window.close()) << "nothing is lost";
}

TEST_F(LogActions, MarksThatAnotherWindowMadeAreNotReplacedBySavingOverTheLog) {
  openLog(kTruck);
  mark("ours");
  const QString path = m_dir.filePath(QStringLiteral("truck.log"));
  const QString sidecar = path + QStringLiteral(".deckpipe-notes");
  {
    Session other;
    other.openLog(path);
    ASSERT_TRUE(QTest::qWaitFor(
        [&] { return other.snapshot().source.progress == SourceStatus::Progress::Done; }, kPatience));
    other.mark(other.snapshot().view.cursor, QStringLiteral("theirs"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return !other.snapshot().source.isKeepingMarks; }, kPatience));
  }
  const QByteArray both = read(sidecar);
  ASSERT_TRUE(both.contains("ours") && both.contains("theirs"));
  m_window.saveLog(path);
  ASSERT_TRUE(saveSays("truck.log is left as it is"));
  EXPECT_TRUE(saveSays("Save under another name"));
  EXPECT_EQ(read(sidecar), both);
  EXPECT_EQ(read(path), kTruck);
}

TEST_F(LogActions, ALogThatWasSavedOverItselfStillKeepsItsMarks) {
  openLog(kTruck);
  mark("before");
  m_window.saveLog(m_dir.filePath(QStringLiteral("truck.log")));
  ASSERT_TRUE(saveSays("truck.log.deckpipe-notes"));
  mark("after");
  EXPECT_FALSE(m_session.snapshot().source.unkeptMarks);
  const QByteArray kept = read(m_dir.filePath(QStringLiteral("truck.log.deckpipe-notes")));
  EXPECT_TRUE(kept.contains("before") && kept.contains("after")) << kept.constData();
}

TEST_F(LogActions, LeavingAndQuittingWaitForMarksThatAreBeingWritten) {
  openLog(kTruck);
  Snapshot keeping = m_session.snapshot();
  keeping.source.isKeepingMarks = true;
  m_window.setSnapshot(keeping);
  EXPECT_FALSE(m_window.close());
  EXPECT_TRUE(m_window.isVisible());
  EXPECT_FALSE(m_window.findChild<QMessageBox*>()) << "nothing is lost yet";
  m_window.setSnapshot(m_session.snapshot());
  EXPECT_FALSE(m_window.isVisible()) << "they are in the file";
  m_window.show();
  m_window.setSnapshot(keeping);
  trigger("closeAction");
  EXPECT_TRUE(m_session.snapshot().view.document);
  keeping.source.isKeepingMarks = false;
  keeping.source.unkeptMarks = UnkeptMarks{UnkeptMarks::Why::NoAnswer};
  m_window.setSnapshot(keeping);
  EXPECT_TRUE(m_session.snapshot().view.document);
  EXPECT_TRUE(named<QMessageBox>("leaveQuestion")->text().contains(QStringLiteral("does not answer")));
}

TEST_F(LogActions, AskBeforeALinkIsLeftThatHoldsFramesOfOurs) {
  openLog(kTruck);
  Snapshot waiting = m_session.snapshot();
  auto services = std::make_shared<ServiceStatus>();
  services->unconfirmed = 2;
  waiting.services = services;
  const auto isSaid = [this](const char* name) {
    const auto* question = m_window.findChild<QMessageBox*>(QLatin1String(name));
    return question != nullptr &&
           question->text().contains(QStringLiteral("2 frames are not on the bus yet"));
  };
  m_window.setSnapshot(waiting);
  trigger("closeAction");
  EXPECT_TRUE(m_session.snapshot().view.document) << "not before the answer";
  EXPECT_TRUE(isSaid("leaveQuestion"));
  m_window.setSnapshot(waiting);
  EXPECT_FALSE(m_window.close());
  EXPECT_TRUE(isSaid("quitQuestion"));
}

TEST_F(LogActions, AskBeforeALinkIsConnectedAgainThatHoldsFramesOfOurs) {
  Snapshot waiting = m_session.snapshot();
  waiting.view.document = std::make_shared<LogDocument>();
  waiting.source.kind = SourceStatus::Kind::Link;
  waiting.source.progress = SourceStatus::Progress::Failed;
  waiting.source.error = StoreFull{};
  auto services = std::make_shared<ServiceStatus>();
  services->unconfirmed = 2;
  waiting.services = services;
  m_window.setSnapshot(waiting);
  named<QAbstractButton>("noticeAction")->click();
  EXPECT_TRUE(m_window.findChild<QMessageBox*>(QStringLiteral("leaveQuestion")));
  EXPECT_FALSE(m_session.snapshot().view.document);
}

TEST_F(LogActions, KeepNoMarkAfterEscape) {
  openLog(kTruck);
  trigger("markAction");
  QTest::keyClick(named<QLineEdit>("markText"), Qt::Key_Escape);
  EXPECT_FALSE(named<QLineEdit>("markText")->isVisible());
  EXPECT_EQ(m_session.snapshot().view.document->notes.count(), 0u);
}

TEST_F(LogActions, OpenADroppedFileAndRememberIt) {
  const QString path = writeLog(kTruck);
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(path)});
  QDragEnterEvent enter(QPoint(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(&m_window, &enter);
  EXPECT_TRUE(enter.isAccepted());
  QDropEvent drop(QPointF(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(&m_window, &drop);
  EXPECT_TRUE(QTest::qWaitFor([&] { return m_session.snapshot().view.frameCount == 3; }, kPatience));
  EXPECT_EQ(recentLogs(), QStringList{path});
}

TEST_F(LogActions, OnlyWhatCouldBeReadIsListedAmongTheLogsThatWereOpened) {
  auto* page = only<ConnectionPage>();
  Q_EMIT page->logRequested(m_dir.filePath(QStringLiteral("absent.log")));
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return m_session.snapshot().source.progress == SourceStatus::Progress::Failed; }, kPatience));
  EXPECT_EQ(recentLogs(), QStringList());
  const QString good = writeLog(kTruck);
  Q_EMIT page->logRequested(good);
  ASSERT_TRUE(QTest::qWaitFor([&] { return m_session.snapshot().view.frameCount == 3; }, kPatience));
  Q_EMIT page->logRequested(writeLog("no log\n", QStringLiteral("other.log")));
  ASSERT_TRUE(QTest::qWaitFor([&] { return m_session.snapshot().notOpened.has_value(); }, kPatience));
  EXPECT_EQ(recentLogs(), QStringList{good});
}

TEST_F(LogActions, ListTheNewestLogFirstAndForgetThem) {
  rememberLog(QStringLiteral("/a.log"));
  rememberLog(QStringLiteral("/b.log"));
  rememberLog(QStringLiteral("/a.log"));
  EXPECT_EQ(recentLogs(), (QStringList{QStringLiteral("/a.log"), QStringLiteral("/b.log")}));
  trigger("closeAction");
  m_window.hide();
  m_window.show();
  EXPECT_EQ(m_window.findChildren<QPushButton*>(QStringLiteral("recentLog")).size(), 2);
  QTest::mouseClick(named<QPushButton>("forgetLogs"), Qt::LeftButton);
  EXPECT_TRUE(recentLogs().isEmpty());
}

TEST_F(LogActions, GoBackToTheConnectionPageWhereNothingCouldBeOpened) {
  m_session.openLog(m_dir.filePath(QStringLiteral("absent.log")));
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return m_session.snapshot().source.progress == SourceStatus::Progress::Failed; }, kPatience));
  EXPECT_TRUE(named<QWidget>("startPage")->isVisible());
  EXPECT_TRUE(text("noticeText").contains(QStringLiteral("absent.log cannot be read")))
      << qPrintable(text("noticeText"));
}

TEST_F(LogActions, DialogsOfferWhatTheTableOfFormatsHas) {
  for (const char* action : {"openLogAction", "saveLogAction"}) {
    openLog(kTruck);
    trigger(action);
    auto* dialog = named<QFileDialog>("fileDialog");
    ASSERT_NE(dialog, nullptr);
    const QString filters = dialog->nameFilters().join(QLatin1Char('\n'));
    for (const LogFormat& format : logFormats()) {
      if (dialog->acceptMode() == QFileDialog::AcceptSave && format.makeWriter == nullptr) continue;
      const std::string filter = std::string(format.name) + " (" + std::string(format.patterns) + ")";
      EXPECT_TRUE(filters.contains(QString::fromStdString(filter))) << action << qPrintable(filters);
    }
    EXPECT_TRUE(filters.endsWith(QStringLiteral("All files (*)")));
    if (dialog->acceptMode() == QFileDialog::AcceptSave) {
      EXPECT_TRUE(dialog->nameFilters().first().startsWith(QStringLiteral("candump"))) << "for all programs";
      EXPECT_EQ(dialog->defaultSuffix(), QStringLiteral("log"));
      EXPECT_TRUE(dialog->selectedFiles().value(0).endsWith(QStringLiteral(".log")));
      Q_EMIT dialog->filterSelected(filterOf(kJournalFormat));
      EXPECT_TRUE(dialog->selectedFiles().value(0).endsWith(QStringLiteral(".deckpipe")));
    }
    delete dialog;
  }
}

TEST_F(LogActions, TimesThatAreDifferencesAreAddedUpWhenAskedFor) {
  m_session.openLog(
      writeLog("(000.000000) can0 18EFFF80#FF83150206021A0B\n(000.100000) can0 18EFFF80#FF83150206021A0B\n"
               "(000.100000) can0 18EFFF80#FF83150206021A0B\n(000.050000) can0 18EFFF80#FF83150206021A0B\n"
               "(000.100000) can0 18EFFF80#FF83150206021A0B\n"));
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return text("noticeText").contains(QStringLiteral("look like differences")); }, kPatience));
  QTest::mouseClick(named<QPushButton>("noticeAction"), Qt::LeftButton);
  ASSERT_TRUE(QTest::qWaitFor([&] { return m_session.snapshot().view.end == Instant{} + 350ms; }, kPatience));
  EXPECT_TRUE(QTest::qWaitFor([&] { return text("noticeText").isEmpty(); }, kPatience))
      << qPrintable(text("noticeText"));
}

TEST_F(LogActions, WhatIsNoLogIsSaidWithTheFormatsThatAre) {
  m_session.openLog(writeLog("no log\n"));
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return text("noticeText").contains(QStringLiteral("truck.log cannot be read")); }, kPatience));
  EXPECT_TRUE(text("noticeText").endsWith(QStringLiteral("Deckpipe reads: Deckpipe recording, candump.")))
      << qPrintable(text("noticeText"));
}

}  // namespace
}  // namespace deckpipe
