// SPDX-License-Identifier: GPL-3.0-or-later
// What was recorded and never saved is offered at the start, and the page of recordings does what it says.
#include <QDir>
#include <QFileDialog>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>

#include "app/console/window_test.h"
#include "console/recordings_list.h"
#include "session/recorder.h"
#include "support/file_size_limit.h"
#include "support/frames.h"

namespace deckpipe {
namespace {

using test::kPatience;

struct RecordingsPageTest : testing::Test {
  void SetUp() override { QSettings().clear(); }

  // A recording that was closed, without anybody saving it.
  QString record(bool isSimulated = false) {
    const auto log = std::make_shared<LogDocument>();
    log->frames.channel("can0");
    for (const Frame& frame :
         {test::frame("18EFFF80", "FF83150206021A0B"), test::frame("18EFFF80", "011D940371000041")})
      EXPECT_TRUE(log->frames.append({&frame, 1}, Arrival{.now = Instant{1'000'000'000}}));
    Recorder recorder(log, recordingIn(folder), isSimulated);
    recorder.end();
    EXPECT_TRUE(waitFor([&] { return recorder.hasEnded(); }));
    return QString::fromStdString(recorder.status().path);
  }
  void start() {
    session = std::make_unique<Session>();
    session->setRecordingFolder(folder);
    window = std::make_unique<MainWindow>(*session);
    window->resize(1366, 720);
    window->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get()));
  }
  template <typename Condition>
  static bool waitFor(Condition condition) {
    return QTest::qWaitFor(condition, kPatience);
  }
  template <typename T>
  T* named(const char* name) const {
    return test::child<T>(*window, name);
  }
  QString notice() const { return named<QLabel>("noticeText")->text(); }
  int rows() const { return named<QListWidget>("recordingsList")->count(); }
  void showPage() {
    named<QAction>("recordingsAction")->trigger();
    ASSERT_TRUE(named<QWidget>("recordingsPage")->isVisible());
  }
  void click(const char* button) { QTest::mouseClick(named<QPushButton>(button), Qt::LeftButton); }

  QTemporaryDir dir;
  QString folder = dir.filePath(QStringLiteral("recordings"));
  std::unique_ptr<Session> session;
  std::unique_ptr<MainWindow> window;
};

TEST_F(RecordingsPageTest, TheStartOffersWhatWasNotSavedByTimeAndPin) {
  record();
  start();
  ASSERT_TRUE(waitFor([&] { return notice().startsWith(QStringLiteral("A recording of ")); }));
  EXPECT_TRUE(notice().contains(QStringLiteral("was not saved: 2 frames, 1032AE100801035.")))
      << notice().toStdString();
  click("noticeAction");
  EXPECT_TRUE(named<QWidget>("recordingsPage")->isVisible());
  EXPECT_TRUE(notice().isEmpty());
  ASSERT_TRUE(waitFor([&] { return rows() == 1; }));
  click("recordingOpen");
  EXPECT_TRUE(waitFor([&] {
    return session->snapshot().source.progress == SourceStatus::Progress::Done &&
           session->snapshot().view.frameCount == 2;
  }));
  EXPECT_FALSE(named<QWidget>("recordingsPage")->isVisible()) << "the log is shown";
}

TEST_F(RecordingsPageTest, TheOfferOfTheStartCanBeClosed) {
  record();
  start();
  ASSERT_TRUE(waitFor([&] { return notice().startsWith(QStringLiteral("A recording of ")); }));
  click("noticeClose");
  EXPECT_EQ(notice(), QString());
}

TEST(NoticeOfUnsaved, NamesUpToThreeAndCountsTheOthers) {
  Recording recording;
  recording.isReadable = true;
  recording.frames = 2;
  recording.pins = {QStringLiteral("1032AE100801035")};
  std::vector<Recording> recordings(5, recording);
  recordings[2].pins = {QStringLiteral("1032AE100801036")};
  const QString text = unsavedNotice(recordings).text;
  EXPECT_EQ(text.count(QStringLiteral("2 frames, 1032AE100801035.")), 2) << text.toStdString();
  EXPECT_EQ(text.count(QStringLiteral("2 frames, 1032AE100801036.")), 1) << text.toStdString();
  EXPECT_TRUE(text.endsWith(QStringLiteral("2 earlier ones were not saved either."))) << text.toStdString();
}

TEST_F(RecordingsPageTest, NothingIsOfferedOfASimulatedTruckOrOfNone) {
  start();
  showPage();
  EXPECT_TRUE(waitFor([&] {
    return named<QLabel>("recordingsIntro")->text().startsWith(QStringLiteral("Nothing was recorded yet."));
  }));
  EXPECT_FALSE(named<QPushButton>("recordingOpen")->isEnabled());
  EXPECT_FALSE(named<QPushButton>("recordingDelete")->isEnabled());
  record(true);
  EXPECT_TRUE(unsavedNotice(recordingsIn(folder)).text.isEmpty());
}

TEST_F(RecordingsPageTest, ACopyMarksTheRecordingAsSaved) {
  const QString path = record();
  start();
  showPage();
  ASSERT_TRUE(waitFor([&] { return rows() == 1; }));
  click("recordingSave");
  auto* dialog = named<QFileDialog>("fileDialog");
  const QString copy = dir.filePath(QStringLiteral("mine.deckpipe"));
  Q_EMIT dialog->fileSelected(copy);
  delete dialog;
  ASSERT_TRUE(waitFor([&] {
    return named<QListWidget>("recordingsList")->item(0)->text().contains(QStringLiteral(" – saved"));
  }));
  EXPECT_EQ(named<QLabel>("recordingsOutcome")->text(), QStringLiteral("Saved ") + copy);
  EXPECT_EQ(readRecording(copy).frames, 2u);
  EXPECT_TRUE(readRecording(path).isSaved);
}

TEST_F(RecordingsPageTest, ACopyThatADiskDoesNotTakeWholeIsSaidWithTheFileAndTheReason) {
  const QString path = record();
  start();
  showPage();
  ASSERT_TRUE(waitFor([&] { return rows() == 1; }));
  click("recordingSave");
  auto* dialog = named<QFileDialog>("fileDialog");
  const QString copy = dir.filePath(QStringLiteral("mine.deckpipe"));
  {
    const test::FileSizeLimit limit(100);
    ASSERT_GT(QFileInfo(path).size(), 100);
    Q_EMIT dialog->fileSelected(copy);
    delete dialog;
    ASSERT_TRUE(waitFor([&] { return !named<QLabel>("recordingsOutcome")->text().isEmpty(); }));
  }
  EXPECT_EQ(named<QLabel>("recordingsOutcome")->text(),
            copy + QStringLiteral(" cannot be saved: File too large"));
  EXPECT_FALSE(QFile::exists(copy));
  EXPECT_FALSE(readRecording(path).isSaved);
}

TEST_F(RecordingsPageTest, ACopyOntoARecordingThatGoesOnIsRefused) {
  record();
  start();
  showPage();
  ASSERT_TRUE(waitFor([&] { return rows() == 1; }));
  const MadeJournalFile growing = createJournalFile(dir.filePath(QStringLiteral("other")).toStdString());
  ASSERT_TRUE(growing);
  click("recordingSave");
  auto* dialog = named<QFileDialog>("fileDialog");
  Q_EMIT dialog->fileSelected(QString::fromStdString(growing.value()->path()));
  delete dialog;
  EXPECT_TRUE(waitFor([&] {
    return named<QLabel>("recordingsOutcome")->text().contains(QStringLiteral("a recording that goes on"));
  }));
  EXPECT_FALSE(growing.value()->check()) << "it has its name";
}

TEST_F(RecordingsPageTest, ACopyOntoTheRecordingItselfIsRefusedAndSavesNothing) {
  const QString path = record();
  start();
  showPage();
  ASSERT_TRUE(waitFor([&] { return rows() == 1; }));
  click("recordingSave");
  auto* dialog = named<QFileDialog>("fileDialog");
  Q_EMIT dialog->fileSelected(path);
  delete dialog;
  ASSERT_TRUE(waitFor([&] {
    return named<QLabel>("recordingsOutcome")->text().contains(QStringLiteral("cannot be saved"));
  }));
  EXPECT_EQ(readRecording(path).frames, 2u);
  EXPECT_FALSE(readRecording(path).isSaved);
}

TEST_F(RecordingsPageTest, DeletingAsksFirst) {
  const QString path = record();
  start();
  showPage();
  ASSERT_TRUE(waitFor([&] { return rows() == 1; }));
  click("recordingDelete");
  auto* question = named<QMessageBox>("deleteQuestion");
  EXPECT_TRUE(QFile::exists(path));
  question->reject();
  EXPECT_TRUE(QFile::exists(path));
  ASSERT_TRUE(waitFor([&] { return window->findChild<QMessageBox*>() == nullptr; }));
  click("recordingDelete");
  question = named<QMessageBox>("deleteQuestion");
  for (QAbstractButton* button : question->buttons())
    if (question->buttonRole(button) == QMessageBox::DestructiveRole) button->click();
  ASSERT_TRUE(waitFor([&] { return rows() == 0; }));
  EXPECT_FALSE(QFile::exists(path));
}

TEST_F(RecordingsPageTest, TheFirstLookDeletesSavedOnesBeyondTheLimits) {
  const QString saved = record(), unsaved = record();
  ASSERT_FALSE(markJournalSaved(saved.toStdString()));
  QSettings().setValue(QStringLiteral("recordings/mostMegabytes"), 0);
  start();
  ASSERT_TRUE(waitFor([&] { return !QFile::exists(saved); }));
  EXPECT_TRUE(waitFor([&] { return notice().contains(QStringLiteral("was not saved")); }));
  EXPECT_TRUE(QFile::exists(unsaved));
}

TEST_F(RecordingsPageTest, SavingALogWhoseNotesCannotBeSavedDoesNotMarkItsRecording) {
  const QString path = record();
  start();
  session->openLog(path);
  ASSERT_TRUE(waitFor([&] { return session->snapshot().source.progress == SourceStatus::Progress::Done; }));
  session->mark(session->snapshot().view.cursor, QStringLiteral("water on"));
  const QString mine = dir.filePath(QStringLiteral("mine.log"));
  ASSERT_TRUE(QDir().mkdir(mine + QStringLiteral(".deckpipe-notes")));
  const auto said = [&] { return named<QLabel>("saveText")->text(); };
  window->saveLog(mine);
  ASSERT_TRUE(waitFor([&] { return said().startsWith(QStringLiteral("Saved")); }));
  EXPECT_TRUE(said().contains(QStringLiteral("its marks, notes and labels cannot be saved")))
      << qPrintable(said());
  EXPECT_FALSE(readRecording(path).isSaved) << "the copy is no substitute";
  ASSERT_TRUE(QDir().rmdir(mine + QStringLiteral(".deckpipe-notes")));
  window->saveLog(mine);
  ASSERT_TRUE(waitFor([&] { return said().contains(QStringLiteral("mine.log.deckpipe-notes")); }));
  EXPECT_TRUE(waitFor([&] { return readRecording(path).isSaved; }));
}

TEST_F(RecordingsPageTest, OpeningTheOneThatIsInViewLeavesItAlone) {
  start();
  session->openDemo();
  ASSERT_TRUE(waitFor([&] { return session->snapshot().source.isRecorded(); }));
  const auto before = session->snapshot().view.document;
  showPage();
  ASSERT_TRUE(waitFor([&] { return rows() == 1 && named<QPushButton>("recordingOpen")->isEnabled(); }));
  click("recordingOpen");
  EXPECT_FALSE(named<QWidget>("recordingsPage")->isVisible());
  EXPECT_TRUE(notice().contains(QStringLiteral("is the recording that is in view here")))
      << qPrintable(notice());
  EXPECT_EQ(session->snapshot().view.document, before);
  const QString path = QString::fromStdString(session->snapshot().source.recording->path);
  window->saveLog(path);
  ASSERT_TRUE(
      waitFor([&] { return named<QLabel>("saveText")->text().contains(QStringLiteral("cannot be saved")); }));
  EXPECT_TRUE(readRecording(path).isGrowing);
}

TEST_F(RecordingsPageTest, SavingTheOpenLogMarksItsRecording) {
  const QString path = record();
  start();
  session->openLog(path);
  ASSERT_TRUE(waitFor([&] {
    return session->snapshot().source.progress == SourceStatus::Progress::Done &&
           session->snapshot().view.frameCount == 2;
  }));
  window->saveLog(dir.filePath(QStringLiteral("mine.log")));
  EXPECT_TRUE(waitFor([&] { return readRecording(path).isSaved; }));
}

}  // namespace
}  // namespace deckpipe
