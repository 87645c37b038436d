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
#include <QSplitter>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "model/decode_model.h"
#include "model/device_rows.h"
#include "model/trace_model.h"
#include "panel/decode_panel.h"
#include "panel/device_panel.h"
#include "panel/monitor_page.h"
#include "panel/trace_view.h"
#include "panel/transport_bar.h"
#include "start_page.h"
#include "status_strip.h"

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
      m_traceModel(new TraceModel(this)),
      m_decodeModel(new DecodeModel(this)) {
  setObjectName(QStringLiteral("mainWindow"));
  setAcceptDrops(true);
  auto* start = new StartPage(m_pages);
  m_pages->addWidget(start);
  m_workspace = makeWorkspace();
  m_pages->addWidget(m_workspace);
  auto* central = new QWidget(this);
  auto* layout = new QVBoxLayout(central);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(m_status);
  layout->addWidget(m_pages, 1);
  setCentralWidget(central);
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

QWidget* MainWindow::makeWorkspace() {
  auto* workspace = new QWidget(m_pages);
  m_devices = new DevicePanel(workspace);
  m_page = new MonitorPage(workspace);
  m_trace = new TraceView(workspace);
  m_trace->setModel(m_traceModel);
  m_decode = new DecodePanel(workspace);
  m_decode->setModel(m_decodeModel);
  m_transport = new TransportBar(workspace);

  m_upper = new QSplitter(Qt::Horizontal, workspace);
  m_upper->addWidget(m_devices);
  m_upper->addWidget(m_page);
  m_upper->setStretchFactor(1, 1);
  m_lower = new QSplitter(Qt::Horizontal, workspace);
  m_lower->addWidget(m_trace);
  m_lower->addWidget(m_decode);
  m_lower->setStretchFactor(0, 1);
  m_halves = new QSplitter(Qt::Vertical, workspace);
  m_halves->addWidget(m_upper);
  m_halves->addWidget(m_lower);
  m_halves->setStretchFactor(0, 2);
  m_halves->setStretchFactor(1, 1);
  for (QSplitter* splitter : {m_upper, m_lower, m_halves}) splitter->setChildrenCollapsible(false);
  m_upper->setSizes({336, 1030});
  m_lower->setSizes({946, 420});
  m_halves->setSizes({420, 190});
  m_decode->hide();

  auto* layout = new QVBoxLayout(workspace);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(m_halves, 1);
  layout->addWidget(m_transport);
  return workspace;
}

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

  QMenu* view = menuBar()->addMenu(tr("&View"));
  m_themes = new QActionGroup(this);
  for (const NamedTheme& named : kThemeNames) {
    QAction* action = view->addAction(tr(named.text), this, [this, theme = named.theme] { setTheme(theme); });
    action->setObjectName(QLatin1String(named.key) + QStringLiteral("ThemeAction"));
    action->setCheckable(true);
    action->setData(static_cast<int>(named.theme));
    m_themes->addAction(action);
  }
}

void MainWindow::connectPanels() {
  connect(m_devices, &DevicePanel::deviceSelected, m_page, &MonitorPage::setDevice);
  connect(m_trace, &TraceView::currentFrameChanged, this, &MainWindow::showFrame);
  // The cursor stands behind the frame that was asked for: it has happened.
  connect(m_trace, &TraceView::cursorRequested, this,
          [this](std::uint64_t frame) { m_session.seekFrames(frame + 1); });
  connect(m_transport, &TransportBar::playRequested, &m_session, &Session::play);
  connect(m_transport, &TransportBar::pauseRequested, &m_session, &Session::pause);
  connect(m_transport, &TransportBar::seekRequested, &m_session, &Session::seek);
  connect(m_transport, &TransportBar::stepRequested, &m_session, &Session::step);
  connect(m_transport, &TransportBar::endRequested, &m_session, &Session::goToEnd);
  connect(m_transport, &TransportBar::speedRequested, &m_session, &Session::setSpeed);
}

void MainWindow::showSnapshot() {
  const Snapshot& snapshot = m_session.snapshot();
  const LogView& view = snapshot.view;
  m_status->setSnapshot(snapshot);
  m_pages->setCurrentIndex(view.document == nullptr ? 0 : 1);
  const bool isFile = snapshot.source.kind == SourceStatus::Kind::File;
  setWindowTitle(isFile ? tr("%1 – Deckpipe").arg(QFileInfo(snapshot.source.name).fileName())
                        : tr("Deckpipe"));
  setWindowFilePath(isFile ? snapshot.source.name : QString());
  if (m_shown != view.document.get()) {
    m_shown = view.document.get();
    m_devices->selectDevice({});
    m_page->setDevice({});
    m_trace->setCurrentFrame({});
    showFrame({});
  }
  m_devices->setView(view);
  chooseFirstMonitor();
  m_page->setView(view);
  m_page->setAnimated(view.atEnd || snapshot.playing);
  m_traceModel->setView(view);
  m_decodeModel->setView(view);
  m_transport->setView(
      view, {view.atEnd && snapshot.source.kind == SourceStatus::Kind::Link ? true : snapshot.playing,
             snapshot.speed});
}

// The detail takes room from the trace only while there is a frame to show.
void MainWindow::showFrame(std::optional<std::uint64_t> frame) {
  m_decodeModel->setFrame(frame);
  m_decode->setVisible(frame.has_value());
}

// Until a person chooses, the first monitor that is heard is looked at.
void MainWindow::chooseFirstMonitor() {
  if (m_devices->selectedDevice() != DeviceKey{}) return;
  for (const DeviceRow& row : deviceRows(*m_session.snapshot().view.state)) {
    if (row.group != DeviceGroup::Monitors) continue;
    m_devices->selectDevice(row.key);
    m_page->setDevice(row.key);
    return;
  }
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
  m_devices->setColours(colours);
  m_page->setColours(colours);
  m_trace->setColours(colours);
  m_decode->setColours(colours);
  m_transport->setColours(colours);
  for (QAction* action : m_themes->actions())
    action->setChecked(action->data().toInt() == static_cast<int>(theme));
}

void MainWindow::restoreLayout() {
  const QSettings settings;
  restoreGeometry(settings.value(QStringLiteral("window/geometry")).toByteArray());
  m_upper->restoreState(settings.value(QStringLiteral("window/upper")).toByteArray());
  m_lower->restoreState(settings.value(QStringLiteral("window/lower")).toByteArray());
  m_halves->restoreState(settings.value(QStringLiteral("window/halves")).toByteArray());
  m_trace->restoreState(settings.value(QStringLiteral("window/trace")).toByteArray());
  const QString key = settings.value(QStringLiteral("window/theme")).toString();
  for (const NamedTheme& named : kThemeNames) {
    if (key == QLatin1String(named.key)) setTheme(named.theme);
  }
}

void MainWindow::saveLayout() const {
  QSettings settings;
  settings.setValue(QStringLiteral("window/geometry"), saveGeometry());
  settings.setValue(QStringLiteral("window/upper"), m_upper->saveState());
  settings.setValue(QStringLiteral("window/lower"), m_lower->saveState());
  settings.setValue(QStringLiteral("window/halves"), m_halves->saveState());
  settings.setValue(QStringLiteral("window/trace"), m_trace->saveState());
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
