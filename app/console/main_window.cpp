// SPDX-License-Identifier: GPL-3.0-or-later
#include "main_window.h"

#include <QActionGroup>
#include <QApplication>
#include <QCloseEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenuBar>
#include <QMimeData>
#include <QSettings>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "pane_cycle.h"
#include "panel/trace_panel.h"
#include "panel/transport_bar.h"
#include "sending_actions.h"
#include "start_page.h"
#include "status_strip.h"
#include "workspace.h"

namespace deckpipe {
namespace {

struct NamedTheme {
  Theme theme;
  const char* key;  // in settings
  const char* text;
};
constexpr NamedTheme kThemeNames[] = {
    {Theme::Light, "light", QT_TRANSLATE_NOOP("deckpipe::MainWindow", "&Light")},
    {Theme::Dark, "dark", QT_TRANSLATE_NOOP("deckpipe::MainWindow", "&Dark")},
    {Theme::Sunlight, "sunlight", QT_TRANSLATE_NOOP("deckpipe::MainWindow", "&Sunlight")},
};

}  // namespace

MainWindow::MainWindow(Session& session, QWidget* parent)
    : QMainWindow(parent),
      m_session(session),
      m_status(new StatusStrip(this)),
      m_pages(new QStackedWidget(this)),
      m_workspace(new Workspace(m_labels, m_pages)),
      m_transport(new TransportBar(this)) {
  setObjectName(QStringLiteral("mainWindow"));
  setAcceptDrops(true);
  auto* start = new StartPage(m_pages);
  m_pages->addWidget(start);
  m_pages->addWidget(m_workspace);
  auto* central = new QWidget(this);
  auto* layout = new QVBoxLayout(central);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(m_status);
  layout->addWidget(m_pages, 1);
  layout->addWidget(m_transport);
  setCentralWidget(central);
  m_sending = new SendingActions(m_session, this);
  m_session.setClaim(claimSettings());
  makeMenus();
  connect(start, &StartPage::logRequested, this, &MainWindow::openLogByHand);
  connect(start, &StartPage::demoRequested, &m_session, &Session::openDemo);
  connect(&m_session, &Session::changed, this, &MainWindow::showSnapshot);
  connectPanels();
  setTheme(m_theme);
  resize(1366, 720);
  showSnapshot();
}

MainWindow::~MainWindow() = default;

void MainWindow::makeMenus() {
  QMenu* file = menuBar()->addMenu(tr("&File"));
  file->addAction(tr("&Open log…"), QKeySequence::Open, this, &MainWindow::openLogByHand)
      ->setObjectName(QStringLiteral("openLogAction"));
  file->addAction(tr("Start the &simulated truck"), &m_session, &Session::openDemo)
      ->setObjectName(QStringLiteral("demoAction"));
  file->addAction(tr("&Close"), QKeySequence::Close, this,
                  [this] {
                    m_session.closeSource();
                    showSnapshot();
                  })
      ->setObjectName(QStringLiteral("closeAction"));
  file->addSeparator();
  file->addAction(tr("&Quit"), QKeySequence::Quit, this, &QWidget::close)
      ->setObjectName(QStringLiteral("quitAction"));

  menuBar()->addMenu(m_sending->menu());

  QMenu* view = menuBar()->addMenu(tr("&View"));
  m_themes = new QActionGroup(this);
  for (const NamedTheme& named : kThemeNames) {
    QAction* action = view->addAction(tr(named.text), this, [this, theme = named.theme] { setTheme(theme); });
    action->setObjectName(QLatin1String(named.key) + QStringLiteral("ThemeAction"));
    action->setCheckable(true);
    action->setData(static_cast<int>(named.theme));
    m_themes->addAction(action);
  }
  view->addSeparator();
  view->addActions(m_workspace->dockActions());
  view->addSeparator();
  view->addAction(tr("&Next pane"), QKeySequence(Qt::Key_F6), this, [this] { focusNextPane(panes(), false); })
      ->setObjectName(QStringLiteral("nextPaneAction"));
  view->addAction(tr("&Previous pane"), QKeySequence(Qt::SHIFT | Qt::Key_F6), this,
                  [this] { focusNextPane(panes(), true); })
      ->setObjectName(QStringLiteral("previousPaneAction"));
  view->addAction(tr("&Reset layout"), m_workspace, &Workspace::resetLayout)
      ->setObjectName(QStringLiteral("resetLayoutAction"));
}

QList<QWidget*> MainWindow::panes() const {
  if (m_pages->currentWidget() != m_workspace) return {m_pages->currentWidget()};
  return m_workspace->panes() << m_transport;
}

void MainWindow::connectPanels() {
  connect(m_workspace, &Workspace::frameRequested, this,
          [this](std::uint64_t frame) { m_session.seekFrames(frame + 1); });
  connect(m_workspace, &Workspace::seekRequested, &m_session, &Session::seek);
  connect(m_workspace, &Workspace::wished, m_sending, &SendingActions::wish);
  connect(m_workspace, &Workspace::unlockRequested, m_sending, &SendingActions::askToUnlock);
  connect(m_workspace, &Workspace::twinWished, &m_session, &Session::wantOfTwin);
  connect(&m_session, &Session::twinChanged, m_workspace, &Workspace::setTwin);
  connect(m_transport, &TransportBar::playRequested, &m_session, &Session::play);
  connect(m_transport, &TransportBar::pauseRequested, &m_session, &Session::pause);
  connect(m_transport, &TransportBar::seekRequested, &m_session, &Session::seek);
  connect(m_transport, &TransportBar::stepRequested, &m_session, &Session::step);
  connect(m_transport, &TransportBar::rowStepRequested, m_workspace->trace(), &TracePanel::stepCursor);
  connect(m_transport, &TransportBar::spanRequested, m_workspace->trace(), &TracePanel::setFilter);
  connect(m_workspace->trace(), &TracePanel::filteredChanged, m_transport, &TransportBar::setFiltered);
  connect(m_transport, &TransportBar::endRequested, &m_session, &Session::goToEnd);
  connect(m_transport, &TransportBar::speedRequested, &m_session, &Session::setSpeed);
}

void MainWindow::showSnapshot() {
  const Snapshot& snapshot = m_session.snapshot();
  const LogView& view = snapshot.view;
  m_status->setSnapshot(snapshot);
  m_sending->setSnapshot(snapshot);
  if (view.document == nullptr) {
    m_pages->setCurrentIndex(0);
  } else {
    m_pages->setCurrentWidget(m_workspace);
  }
  m_transport->setVisible(view.document != nullptr);
  const bool isFile = snapshot.source.kind == SourceStatus::Kind::File;
  setWindowTitle(isFile ? tr("%1 – Deckpipe").arg(QFileInfo(snapshot.source.name).fileName())
                        : tr("Deckpipe"));
  setWindowFilePath(isFile ? snapshot.source.name : QString());
  m_workspace->setSnapshot(snapshot);
  m_transport->setView(
      view, {view.atEnd && snapshot.source.kind == SourceStatus::Kind::Link ? true : snapshot.playing,
             snapshot.speed});
}

void MainWindow::openLogByHand() {
  const QString path = QFileDialog::getOpenFileName(
      this, tr("Open a log"), {}, tr("candump logs (*.log *.txt *.candump);;All files (*)"));
  if (!path.isEmpty()) m_session.openLog(path);
}

void MainWindow::setTheme(Theme theme) {
  m_theme = theme;
  const Colours colours = coloursOf(theme);
  QApplication::setPalette(qtPalette(colours));
  m_status->setColours(colours);
  m_workspace->setColours(colours);
  m_transport->setColours(colours);
  for (QAction* action : m_themes->actions())
    action->setChecked(action->data().toInt() == static_cast<int>(theme));
}

void MainWindow::restoreLayout() {
  const QSettings settings;
  restoreGeometry(settings.value(QStringLiteral("window/geometry")).toByteArray());
  m_workspace->restoreFrom(settings);
  const QString key = settings.value(QStringLiteral("window/theme")).toString();
  for (const NamedTheme& named : kThemeNames) {
    if (key == QLatin1String(named.key)) setTheme(named.theme);
  }
}

void MainWindow::saveLayout() const {
  QSettings settings;
  settings.setValue(QStringLiteral("window/geometry"), saveGeometry());
  m_workspace->saveTo(settings);
  for (const NamedTheme& named : kThemeNames) {
    if (named.theme == m_theme) settings.setValue(QStringLiteral("window/theme"), QLatin1String(named.key));
  }
}

void MainWindow::closeEvent(QCloseEvent* event) {
  saveLayout();
  QMainWindow::closeEvent(event);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  const QList<QUrl> urls = event->mimeData()->urls();
  if (urls.size() == 1 && urls.first().isLocalFile()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  m_session.openLog(event->mimeData()->urls().first().toLocalFile());
}

}  // namespace deckpipe
