// SPDX-License-Identifier: GPL-3.0-or-later
#include "main_window.h"

#include <QActionGroup>
#include <QApplication>
#include <QDateTime>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFontDatabase>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMenuBar>
#include <QMimeData>
#include <QScreen>
#include <QSettings>
#include <QStackedWidget>
#include <QWhatsThis>
#include <utility>

#include "connection.h"
#include "foot_lines.h"
#include "kept_settings.h"
#include "log_filters.h"
#include "mark_bar.h"
#include "model/frame_test.h"
#include "notice_of.h"
#include "paint/spoken.h"
#include "pane_cycle.h"
#include "panel/common/about_page.h"
#include "panel/common/build.h"
#include "panel/common/settings_page.h"
#include "panel/connect/connection_page.h"
#include "panel/connect/recordings_page.h"
#include "panel/play/transport_bar.h"
#include "panel/trace/trace_panel.h"
#include "protocol/name.h"
#include "recordings_list.h"
#include "room_plan.h"
#include "save_bar.h"
#include "sending_actions.h"
#include "status_strip.h"
#include "status_text.h"
#include "workspace.h"

namespace deckpipe {
namespace {

const QString kThemeKey = QStringLiteral("window/theme");
const QString kDensityKey = QStringLiteral("window/density");

LabelsByPin byPin(const DeviceLabels& labels) {
  LabelsByPin found;
  for (auto label = labels.all().cbegin(); label != labels.all().cend(); ++label) {
    if (const auto pin = Pin::parse(label.key().toStdString()))
      found.emplace(*pin, label.value().toStdString());
  }
  return found;
}

}  // namespace

MainWindow::MainWindow(Session& session, QWidget* parent)
    : QMainWindow(parent),
      m_session(session),
      m_menus(new QMenuBar(this)),
      m_status(new StatusStrip(this)),
      m_notice(new NoticeBar(this)),
      m_pages(new QStackedWidget(this)),
      m_connection(new Connection(m_pages)),
      m_workspace(new Workspace(m_labels, m_pages)),
      m_settings(new SettingsPage(m_pages)),
      m_markBar(new MarkBar(this)),
      m_saveBar(new SaveBar(session.sidecars(), this)),
      m_transport(new TransportBar(this)) {
  speakPaintedWidgets();
  setObjectName(QStringLiteral("mainWindow"));
  setAcceptDrops(true);
  m_pages->addWidget(m_connection->page());
  m_pages->addWidget(m_workspace);
  m_pages->addWidget(m_settings);
  m_settings->setPath(QSettings().fileName());
  auto* about = new AboutPage({QStringLiteral(DECKPIPE_VERSION), QSettings().fileName(),
                               QString::fromStdString(StoreLimits{}.spillFolder)},
                              m_pages);
  m_about = about;
  m_pages->addWidget(about);
  m_recordings = new RecordingsList(m_session.recordingFolder(), this);
  m_pages->addWidget(m_recordings->page());
  for (const ExtraPage* page : std::initializer_list<ExtraPage*>{m_settings, about, m_recordings->page()})
    connect(page, &ExtraPage::closeRequested, this, [this] { showExtra(nullptr); });
  auto* top = new QWidget(this);
  inRow(top, {0, 0, 0, 0}, 8, {m_menus, {m_notice, 1}});
  setMenuWidget(top);
  auto* central = new QWidget(this);
  inColumn(central, {0, 0, 0, 0}, 0, {m_status, {m_pages, 1}, m_transport});
  auto* lines = new FootLines(m_pages);
  lines->add(m_markBar);
  lines->add(m_saveBar);
  setCentralWidget(central);
  m_sending = new SendingActions(m_session, this);
  const ClaimSettings claim = claimSettings();
  m_session.setClaim(claim);
  m_settings->setIdentity(claim.preferred.value, static_cast<int>(claim.identityNumber),
                          int{kLargestIdentity});
  if (const auto refused = dropRefusedAddress()) {
    m_settings->refuseAddress(refused->value);
    m_addressNotice = refusedAddressNotice(*refused, claim.preferred);
  }
  makeMenus();
  connect(&m_session, &Session::changed, this, &MainWindow::showSnapshot);
  connectPanels();
  connectRecordings();
  setLook(m_theme, m_density);
  resize(kUsualWindow);
  showSnapshot();
}

MainWindow::~MainWindow() = default;

QList<QWidget*> MainWindow::panes() const {
  if (m_pages->currentWidget() != m_workspace) return {m_pages->currentWidget(), m_status};
  return m_workspace->panes() << m_transport << m_status;
}

void MainWindow::connectPanels() {
  const ConnectionPage* page = m_connection->page();
  connect(page, &ConnectionPage::browseRequested, this, &MainWindow::openLogByHand);
  connect(page, &ConnectionPage::logRequested, this, &MainWindow::openLog);
  connect(page, &ConnectionPage::demoRequested, this, &MainWindow::openDemo);
  connect(m_connection, &Connection::linkRequested, this, &MainWindow::openLink);
  connect(m_settings, &SettingsPage::themeChosen, this, &MainWindow::setTheme);
  connect(m_settings, &SettingsPage::densityChosen, this, &MainWindow::setDensity);
  connect(m_settings, &SettingsPage::identityChosen, this, [this](int address, int identity) {
    const ClaimSettings chosen{static_cast<std::uint32_t>(identity),
                               Address{static_cast<std::uint8_t>(address)}};
    keepClaimSettings(chosen);
    m_session.setClaim(chosen);
  });
  connect(m_settings, &SettingsPage::resetLayoutRequested, m_workspace, &Workspace::resetLayout);
  connect(m_settings, &SettingsPage::forgetLogsRequested, this, [] { forgetLogs(); });
  connect(m_notice, &NoticeBar::actionRequested, this, &MainWindow::follow);
  connect(m_notice, &NoticeBar::closeRequested, this, [this] {
    for (Notice* kept : {&m_addressNotice, &m_unsavedNotice}) {
      if (*kept == m_notice->notice()) *kept = {};
    }
    m_session.dismiss();
  });
  connect(m_markBar, &MarkBar::marked, &m_session, &Session::mark);
  connect(m_saveBar, &SaveBar::saved, this, [](const QString& path) { rememberLog(path); });
  connect(m_saveBar, &SaveBar::savedWhole, &m_session, &Session::setSaved);
  connect(m_workspace, &Workspace::frameRequested, this,
          [this](std::uint64_t frame) { m_session.seekFrames(frame + 1); });
  connect(m_workspace, &Workspace::seekRequested, &m_session, &Session::seek);
  connect(m_workspace, &Workspace::viewShown, this, &MainWindow::offerActions);
  connect(m_workspace, &Workspace::labelsChanged, m_transport, &TransportBar::setLabels);
  m_transport->setLabels(m_workspace->labels());
  connect(m_workspace, &Workspace::labelsEdited, this,
          [this](const DeviceLabels& labels) { m_session.setLabels(byPin(labels)); });
  m_session.setLabels(byPin(m_labels.read()));
  connect(m_status, &StatusStrip::lockToggled, m_sending, &SendingActions::toggleLock);
  connect(m_workspace, &Workspace::intended, m_sending, &SendingActions::intent);
  connect(m_workspace, &Workspace::unlockRequested, m_sending, [this] { m_sending->askToUnlock(); });
  connect(m_workspace, &Workspace::unlockForRequested, m_sending, &SendingActions::askToUnlock);
  connect(m_workspace, &Workspace::simulatorIntended, &m_session, &Session::intendForSimulator);
  connect(&m_session, &Session::simulatorChanged, m_workspace, &Workspace::setSimulator);
  connect(m_transport, &TransportBar::playRequested, &m_session, &Session::play);
  connect(m_transport, &TransportBar::pauseRequested, &m_session, &Session::pause);
  connect(m_transport, &TransportBar::seekRequested, &m_session, &Session::seek);
  connect(m_transport, &TransportBar::stepRequested, &m_session, &Session::step);
  connect(m_transport, &TransportBar::rowStepRequested, m_workspace->trace(), &TracePanel::stepCursor);
  connect(m_transport, &TransportBar::spanRequested, m_workspace->trace(), &TracePanel::setFilter);
  connect(m_transport, &TransportBar::saveRequested, this,
          [this](std::uint64_t begin, std::uint64_t end) { savePartByHand(begin, end, {}); });
  connect(m_workspace->trace(), &TracePanel::saveRequested, this, &MainWindow::savePartByHand);
  connect(m_workspace->trace(), &TracePanel::filteredChanged, m_transport, &TransportBar::setFiltered);
  connect(m_transport, &TransportBar::endRequested, &m_session, &Session::goToEnd);
  connect(m_transport, &TransportBar::framesRequested, &m_session, &Session::seekFrames);
  connect(m_transport, &TransportBar::speedRequested, &m_session, &Session::setSpeed);
  connect(m_transport, &TransportBar::silencesRequested, &m_session, &Session::setSkipsSilences);
  connect(m_transport, &TransportBar::loopRequested, this, [this](std::optional<TimelineSpan> span) {
    m_session.setLoop(span ? std::optional(LoopSpan{span->begin, span->end}) : std::nullopt);
  });
}

void MainWindow::showSnapshot() {
  setSnapshot(m_session.snapshot());
  rememberWhatWasRead();
}

void MainWindow::rememberWhatWasRead() {
  const SourceStatus& source = m_snapshot.source;
  const auto& document = m_snapshot.view.document;
  const bool isUp =
      source.kind == SourceStatus::Kind::Link && source.progress == SourceStatus::Progress::Running;
  if (isUp && !source.simulated && m_remembered.lock() != document) {
    m_remembered = document;
    rememberLink({source.plugin, source.interfaceName, source.bitRate, QDateTime::currentDateTime()});
  }
  if (source.kind != SourceStatus::Kind::File || m_remembered.lock() == document) return;
  if (m_snapshot.view.frameCount == 0 && source.progress != SourceStatus::Progress::Done) return;
  m_remembered = document;
  rememberLog(source.name);
}

void MainWindow::setSnapshot(const Snapshot& snapshot) {
  m_snapshot = snapshot;
  const LogView& view = snapshot.view;
  // Whoever opened something wants to see it.
  if (std::exchange(m_shown, view.document.get()) != view.document.get()) m_extra = nullptr;
  m_status->setSnapshot(snapshot);
  m_sending->setSnapshot(snapshot);
  const Notice notice = noticeOf(snapshot, m_status->rates());
  const Notice& kept = m_addressNotice.text.isEmpty() ? m_unsavedNotice : m_addressNotice;
  m_notice->setNotice(notice.text.isEmpty() ? kept : notice);
  showPage();
  const bool isFile = snapshot.source.kind == SourceStatus::Kind::File;
  setWindowTitle(view.document == nullptr ? tr("Deckpipe")
                                          : tr("%1 – Deckpipe").arg(sourceTitle(snapshot.source)));
  setWindowFilePath(isFile ? snapshot.source.name : QString());
  m_workspace->setSnapshot(snapshot);
  const bool isLive = snapshot.source.kind == SourceStatus::Kind::Link;
  m_transport->setView(view, {.isPlaying = (view.atEnd && isLive) || snapshot.playing,
                              .speed = snapshot.speed,
                              .isLive = isLive,
                              .isLooping = snapshot.isLooping,
                              .skipsSilences = snapshot.skipsSilences,
                              .skipped = snapshot.skipped});
  if (m_onceMarksAreKept && !snapshot.source.isKeepingMarks) std::exchange(m_onceMarksAreKept, {})();
}

void MainWindow::showPage() {
  // What could not be opened leaves nothing to look at: the page on which to try again is more use.
  const bool hasFrames = m_snapshot.view.frameCount > 0;
  const bool isOpen = m_snapshot.view.document != nullptr &&
                      (hasFrames || m_snapshot.source.progress != SourceStatus::Progress::Failed);
  QWidget* page = isOpen ? static_cast<QWidget*>(m_workspace) : m_connection->page();
  if (m_extra != nullptr) page = m_extra;
  m_transport->setVisible(isOpen);
  m_replay->setEnabled(isOpen && hasFrames);
  if (!isOpen) m_markBar->hide();
  const bool isOther = page != m_pages->currentWidget();
  m_pages->setCurrentWidget(page);
  offerActions();
  if (isOther) focusNextPane({panes().first()}, false);
}

// Every pane that finds something by Ctrl+F takes the key before this. From anywhere else it looks in the trace.
void MainWindow::keyPressEvent(QKeyEvent* event) {
  if (event->matches(QKeySequence::Find)) return m_findAction->trigger();
  QMainWindow::keyPressEvent(event);
}

void MainWindow::showExtra(QWidget* page) {
  m_extra = page;
  if (page == m_settings) {  // it says so itself
    m_addressNotice = {};
    showSnapshot();
  }
  showPage();
}

// Dialogs for files are asynchronous: the bus goes on behind them.
QFileDialog* MainWindow::fileDialog(const QString& title, const QStringList& filters) {
  auto* dialog = new QFileDialog(this, title);
  dialog->setObjectName(QStringLiteral("fileDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setNameFilters(filters);
  if (const QStringList recent = recentLogs(); !recent.isEmpty())
    dialog->setDirectory(QFileInfo(recent.first()).absolutePath());
  return dialog;
}

void MainWindow::openLogByHand() {
  QFileDialog* dialog = fileDialog(tr("Open a log"), filtersForOpening());
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, &MainWindow::openLog);
  dialog->open();
}

QFileDialog* MainWindow::saveDialog(const QString& title) {
  const QStringList filters = filtersForSaving();
  QFileDialog* dialog = fileDialog(title, filters);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  // The name that stands in the dialog takes the suffix too: the suffix says the format.
  const auto takeSuffix = [dialog](const QString& filter) {
    const QString before = dialog->defaultSuffix(), suffix = suffixOf(filter);
    if (suffix.isEmpty()) return;
    dialog->setDefaultSuffix(suffix);
    const QFileInfo named(dialog->selectedFiles().value(0));
    if (!before.isEmpty() && named.suffix() == before)
      dialog->selectFile(named.completeBaseName() + QLatin1Char('.') + suffix);
  };
  connect(dialog, &QFileDialog::filterSelected, dialog, takeSuffix);
  takeSuffix(filters.first());
  dialog->selectFile(QDateTime::currentDateTime().toString(QStringLiteral("'deckpipe' yyyy-MM-dd HHmm")) +
                     QLatin1Char('.') + dialog->defaultSuffix());
  return dialog;
}

void MainWindow::saveLogByHand() {
  QFileDialog* dialog = saveDialog(tr("Save the log"));
  connect(dialog, &QFileDialog::fileSelected, this, &MainWindow::saveLog);
  dialog->open();
}

// What was asked for, of the log that was open then, whatever is shown by the time a name is chosen.
void MainWindow::savePartByHand(std::uint64_t begin, std::uint64_t end, const TraceFilter& filter) {
  const auto document = m_snapshot.view.document;
  if (document == nullptr) return;
  QFileDialog* dialog = saveDialog(tr("Save these frames"));
  connect(dialog, &QFileDialog::fileSelected, this, [=, this](const QString& path) {
    save(
        document, path,
        {begin, end, frameTest(document, filter), filter.text().toStdString(), byPin(m_workspace->labels())});
  });
  dialog->open();
}

void MainWindow::saveLog(const QString& path) {
  if (const auto& document = m_snapshot.view.document)
    save(document, path, {.labels = byPin(m_workspace->labels())});
}

// A copy among the recordings would be taken for one, and may be the recording itself.
void MainWindow::save(const std::shared_ptr<const LogDocument>& document, const QString& path,
                      SavedPart part) {
  const QString recordings = m_session.recordingFolder();
  if (!recordings.isEmpty() && formatToWrite(path.toStdString()).isOwn &&
      QFileInfo(path).dir() == QDir(recordings))
    return m_saveBar->refuse(
        tr("%1 cannot be saved: it would be one of the recordings; choose another folder").arg(path));
  if (document == m_snapshot.view.document) part.missing = m_snapshot.source.read.missing();
  m_saveBar->save(document, path, std::move(part));
}

void MainWindow::follow(Notice::Action action) {
  if (action == Notice::Action::GoToEnd) m_session.goToEnd();
  if (action == Notice::Action::Reconnect) reconnect();
  if (action == Notice::Action::ShowRecordings) showRecordings();
  if (action == Notice::Action::AddUpTimes) addUpTimes();
  if (action == Notice::Action::ChangeBitRate) chooseBitRate();
}

// Connects to the same bus at another rate.
void MainWindow::chooseBitRate() {
  const SourceStatus& source = m_snapshot.source;
  auto* menu = new QMenu(this);
  menu->setObjectName(QStringLiteral("bitRateMenu"));
  menu->setAttribute(Qt::WA_DeleteOnClose);
  for (const int rate : offeredBitRates()) {
    QAction* action = menu->addAction(bitRateText(rate), this,
                                      [this, rate, plugin = source.plugin, name = source.interfaceName] {
                                        m_connection->keepBitRate(rate);
                                        openLink({plugin, name, rate, {}});
                                      });
    action->setCheckable(true);
    action->setChecked(rate == source.bitRate);
  }
  menu->popup(m_notice->mapToGlobal(m_notice->rect().bottomRight() - QPoint(menu->sizeHint().width(), 0)));
}

void MainWindow::setTheme(Theme theme) {
  m_chosenTheme = theme;
  setLook(theme, m_density);
}

void MainWindow::setDensity(Density density) {
  m_chosenDensity = density;
  setLook(m_theme, density);
}

void MainWindow::setLook(Theme theme, Density density) {
  m_theme = theme;
  m_density = density;
  QApplication::setStyle(new AppStyle(density, theme));
  QApplication::setFont(fontFor(density, QFontDatabase::systemFont(QFontDatabase::GeneralFont)));
  m_settings->setTheme(theme);
  m_settings->setDensity(density);
  m_fieldAction->setChecked(density == Density::Field);
  for (QAction* action : m_themes->actions())
    action->setChecked(action->data().toInt() == static_cast<int>(theme));
}

// The look first: what follows is measured in its letters.
void MainWindow::restoreLayout() {
  const QSettings settings;
  setTheme(themeOfKey(settings.value(kThemeKey).toString()).value_or(m_theme));
  setDensity(densityOfKey(settings.value(kDensityKey).toString()).value_or(m_density));
  if (!restoreGeometry(settings.value(QStringLiteral("window/geometry")).toByteArray())) {
    resize(firstSize(screen()->availableGeometry()));
    if (size() != kUsualWindow) setWindowState(windowState() | Qt::WindowMaximized);
  } else if (!isMaximized() && !isFullScreen()) {
    setGeometry(fitted(geometry(), screen()->availableGeometry()));
  }
  m_workspace->restoreFrom(settings);
}

// Docks and columns are measured in the letters of a density: those of another one than is kept are not kept either.
void MainWindow::saveLayout() const {
  QSettings settings;
  settings.setValue(QStringLiteral("window/geometry"), saveGeometry());
  if (m_density == m_chosenDensity) m_workspace->saveTo(settings);
  settings.setValue(kThemeKey, keyOfTheme(m_chosenTheme));
  settings.setValue(kDensityKey, keyOfDensity(m_chosenDensity));
}

// Asked last, after the widget pointed at and all around it: what has no story has its tool tip.
bool MainWindow::event(QEvent* event) {
  if (event->type() == QEvent::QueryWhatsThis) {
    event->accept();
    return true;
  }
  if (event->type() == QEvent::WhatsThis) {
    const auto* help = static_cast<QHelpEvent*>(event);
    QWidget* at = childAt(help->pos());
    while (at != nullptr && at->toolTip().isEmpty()) at = at->parentWidget();
    if (at != nullptr) QWhatsThis::showText(help->globalPos(), at->toolTip(), at);
    event->setAccepted(at != nullptr);
    return at != nullptr;
  }
  return QMainWindow::event(event);
}

void MainWindow::showEvent(QShowEvent* event) {
  QMainWindow::showEvent(event);
  focusNextPane({panes().first()}, false);  // the keyboard begins where the work is, not in the strip above
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  const QList<QUrl> urls = event->mimeData()->urls();
  if (urls.size() == 1 && urls.first().isLocalFile()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) { openLog(event->mimeData()->urls().first().toLocalFile()); }

}  // namespace deckpipe
