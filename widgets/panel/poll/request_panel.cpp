// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/poll/request_panel.h"

#include <QAbstractItemView>
#include <QHeaderView>
#include <QPointer>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSplitter>
#include <QStandardItemModel>
#include <QTabWidget>
#include <QTreeView>
#include <algorithm>

#include "model/answer_history.h"
#include "model/device_details.h"
#include "model/device_rows.h"
#include "panel/common/build.h"
#include "panel/common/flat_header.h"
#include "panel/common/labels.h"
#include "panel/common/send_hint.h"
#include "panel/common/tick_box.h"
#include "panel/poll/repeat_bar.h"
#include "panel/poll/request_card.h"
#include "text/service_text.h"
#include "text/time_text.h"

namespace deckpipe {
namespace {

constexpr std::array<Duration, 6> kPeriods{0s, 500ms, 1s, 5s, 30s, 60s};
constexpr int kHistoryHeight = 120;  // two or three answers

// How long the console may take from unlocking to an address of its own, until nobody expects the question any more.
constexpr Duration kUnlockPatience = 10s;

// What a command does, for the one question before it. The manual's words, no more.
constexpr KeyTable<kCommands, const char*> kConsequences{{
    {Request::ZeroAxes,
     QT_TRANSLATE_NOOP(
         "deckpipe::RequestPanel",
         "Sets the position where it stands now as its zero for rotation and elevation (message 41). "
         "The manual names no way back to the zero of before; valid angles of before stay in the log.")},
    {Request::Reset,
     QT_TRANSLATE_NOOP(
         "deckpipe::RequestPanel",
         "The controller resets at once and does what it does at power-up: it claims an address "
         "and announces itself (message 45). It does not acknowledge.")},
    {Request::SetupMode,
     QT_TRANSLATE_NOOP("deckpipe::RequestPanel",
                       "The controller enters its setup mode at once (message 46), as at power-up with the "
                       "pattern stream input active. What it does there its own manual says.")},
}};

bool namesFault(const Device& device) {
  const FaultStatus faults = device.faults().value();
  return device.faults().isKnown() && (faults.map != 0 || faults.pcodeError.value_or(0) != 0);
}

}  // namespace

RequestPanel::RequestPanel(QWidget* parent) : QWidget(parent), m_history(new AnswerHistory(this)) {
  named(this, "requestPanel", tr("Ask the device"));
  m_title = named(new QLabel(this), "requestDevice", tr("Device that is asked"));
  m_title->setWordWrap(true);
  m_title->setFont(boldFont(m_title->font()));

  m_hint = new SendHint(QStringLiteral("request"), this);
  connect(m_hint, &SendHint::unlockRequested, this, &RequestPanel::unlockRequested);
  m_hint->keepRoom();
  m_repeats = new RepeatBar(this);
  connect(m_repeats, &RepeatBar::endRequested, this, [this] {
    Q_EMIT intended(intent::Repeat{{}, kPolls, Duration{0}});
  });

  m_historyView = new QTreeView(this);
  m_historyHeader = new FlatHeader(m_historyView);
  m_historyHeader->setObjectName(QStringLiteral("answerHeader"));
  named(m_historyView, "answerHistory", tr("Earlier answers"));
  m_historyView->setToolTip(tr("A double click shows the frame"));
  m_historyView->setHeader(m_historyHeader);
  m_historyView->setModel(m_history);
  makeFlat(*m_historyView);  // a tool tip has what is cut off
  m_historyView->setUniformRowHeights(true);
  m_historyView->setAlternatingRowColors(true);
  m_historyHeader->setStretchLastSection(true);
  m_historyHeader->resizeSection(AnswerHistory::When,
                                 fontMetrics().horizontalAdvance(QStringLiteral("000:00:00.000")) + 16);
  m_historyHeader->resizeSection(AnswerHistory::What,
                                 fontMetrics().horizontalAdvance(requestText(Request::Config)) + 24);
  m_historyView->setMinimumHeight(kHistoryHeight);

  auto* tabs = named(new QTabWidget(this), "requestTabs", tr("Ask or change"));
  tabs->addTab(makePolls(), tr("Ask"));
  tabs->addTab(makeCommands(), warningIcon(tabs), tr("Change"));
  tabs->setTabToolTip(1, tr("Commands that change the device. Each asks once before it is sent."));
  auto* split = new QSplitter(Qt::Vertical, this);
  split->setChildrenCollapsible(false);
  split->addWidget(tabs);
  split->addWidget(m_historyView);
  split->setStretchFactor(0, 3);
  split->setStretchFactor(1, 1);
  inColumn(this, {8, 8, 8, 0}, 6, {m_title, m_hint, {split, 1}, m_repeats});

  connect(m_historyView, &QTreeView::activated, this, [this](const QModelIndex& index) {
    Q_EMIT frameRequested(index.data(AnswerHistory::FrameRole).toULongLong());
  });
}

QWidget* RequestPanel::makePolls() {
  auto* content = new QWidget(this);
  m_askAll = makeButton(content, "askAll", tr("Ask it all"));
  m_askAll->setToolTip(tr("Every poll that this device takes, once"));
  m_askEveryone = makeButton(content, "askEveryone", tr("Ask every device"));
  m_askEveryone->setToolTip(
      tr("Every poll of every device, once or as often as chosen above, within a small share of the bus"));
  m_repeat = named(new CalmCombo(content), "askRepeat", tr("Repeat the polls of this device"));
  for (const Duration period : kPeriods)
    m_repeat->addItem(period == 0s ? tr("Ask once") : tr("Every %1").arg(periodText(period)));
  m_cancel = makeButton(content, "askCancel", tr("Give up"));
  m_cancel->setToolTip(tr("Ends what is asked of this device and not yet answered"));
  m_none = makeMessage(content, "requestNone", tr("Why there is nothing to ask"), 16);
  m_none->setAutoFillBackground(false);
  auto* column =
      inColumn(content, {}, 2,
               {inRow({{m_askAll, 1}, {m_repeat, 1}}), inRow({{m_askEveryone, 1}, {m_cancel, 1}}), m_none});
  for (const Request request : kAllOf<Request>) {
    m_cards[request] = new RequestCard(request, content);
    if (!isCommand(request)) column->addWidget(m_cards[request]);
    connect(m_cards[request], &RequestCard::pressed, this, [this, request] { press(request); });
  }
  column->addStretch(1);
  connect(m_askAll, &QPushButton::clicked, this, &RequestPanel::askAll);
  connect(m_askEveryone, &QPushButton::clicked, this, [this] {
    const Duration period = kPeriods.at(static_cast<std::size_t>(std::max(0, m_repeat->currentIndex())));
    Q_EMIT intended(period > 0ns ? Intent(intent::Repeat{{}, kPolls, period})
                                 : Intent(intent::SendRequests{{}, kPolls}));
  });
  connect(m_cancel, &QPushButton::clicked, this, [this] { Q_EMIT intended(intent::Cancel{m_view.device}); });
  connect(m_repeat, &QComboBox::activated, this, &RequestPanel::repeat);

  return scrolled("askArea", content);
}

QWidget* RequestPanel::makeCommands() {
  auto* content = new QWidget(this);
  auto* sign = new GlyphLabel(content);
  sign->setGlyph(Glyph::Warning, Ink::Warning);
  auto* caution = makeWords(content, "changeCaution", tr("What this tab is for"), Ink::Warning);
  caution->setText(
      tr("These change the device. Whether it moves at one of them the manual does not say: see that "
         "nobody is near it."));
  m_noCommand = makeMessage(content, "changeNone", tr("Why there is nothing to change"), 16);
  m_noCommand->setAutoFillBackground(false);
  auto* column =
      inColumn(content, {8, 8, 8, 0}, 6, {inRow(8, {{sign, 0, Qt::AlignTop}, {caution, 1}}), m_noCommand});
  for (const Request command : kCommands) column->addWidget(m_cards[command]);
  column->addStretch(1);
  return scrolled("changeArea", content);
}

QScrollArea* RequestPanel::scrolled(const char* name, QWidget* content) {
  QScrollArea* area = makeScroll(this, name, content);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->setAccessibleName(tr("Requests"));
  return area;
}

void RequestPanel::setView(const PanelView& view) {
  m_view = view;
  QScrollBar* bar = m_historyView->verticalScrollBar();
  const bool isAtEnd = bar->value() == bar->maximum();
  const int rows = m_history->rowCount();
  m_history->setView(view.log, view.device);
  if (isAtEnd && m_history->rowCount() != rows) m_historyView->scrollToBottom();
  showState();
  m_question.setView(view);
  askOnceUnlocked();
}

void RequestPanel::showState() {
  setText(*m_title, m_view.name);
  const bool isNews = services().refusal != Refusal::Busy;  // the card says it already
  m_hint->setStatus(services(), m_view.isLive, isNews ? refusalText(services().refusal) : QString());
  m_repeats->setStatus(services(), m_view.labels);
  const DeviceServices* device = services().find(m_view.device);
  showPolls(device);
  bool hasPoll = false, hasCommand = false;
  for (RequestCard* card : m_cards) {
    const bool isTaken = device != nullptr && device->takes.has(card->request());
    const bool isShown = isTaken || m_history->latest(card->request()) != nullptr;
    card->setVisible(isShown);
    bool& has = isCommand(card->request()) ? hasCommand : hasPoll;
    has = has || isShown;
    if (isShown) showCard(*card, device);
  }
  m_none->setVisible(!hasPoll);
  m_none->setText(m_view.device.isNull() ? tr("Choose an Akron device to ask it.")
                                         : tr("This device takes no polls, or was not asked in this log."));
  m_noCommand->setVisible(!hasCommand);
  m_noCommand->setText(m_view.device.isNull() ? tr("Choose an Akron device to change it.")
                                              : tr("This device takes no command that changes it."));
}

void RequestPanel::showPolls(const DeviceServices* device) {
  const bool canRequest = m_view.isLive && services().canRequest();
  bool isOpen = false;
  const Duration period = device != nullptr ? device->longestPeriod() : Duration{0};
  const bool isRepeated = period > 0ns;
  if (device != nullptr) {
    for (const RequestStatus& request : device->requests) {
      isOpen = isOpen || request.progress == RequestStatus::Progress::Queued ||
               request.progress == RequestStatus::Progress::Waiting ||
               request.progress == RequestStatus::Progress::NotOnBusYet;
    }
  }
  m_askAll->setEnabled(canAskAll());
  m_askAll->setText(isBehindLock() ? tr("Unlock, ask it all…") : tr("Ask it all"));
  m_askAll->setAccessibleName(m_askAll->text());
  m_repeat->setEnabled((canRequest && takesPolls()) || isRepeated);
  offerPeriods(canRequest && takesPolls());
  m_askEveryone->setEnabled(canRequest);
  m_cancel->setEnabled(isOpen || isRepeated);
  const auto found = std::ranges::find(kPeriods, period);
  const int index = found == kPeriods.end() ? 0 : static_cast<int>(found - kPeriods.begin());
  if (!m_repeat->view()->isVisible() && m_repeat->currentIndex() != index) m_repeat->setCurrentIndex(index);
}

// What is repeated can be ended off the live edge too, but not begun.
void RequestPanel::offerPeriods(bool isOffered) {
  auto* items = qobject_cast<QStandardItemModel*>(m_repeat->model());
  for (int i = 1; i < items->rowCount(); ++i) {
    if (items->item(i)->isEnabled() != isOffered) items->item(i)->setEnabled(isOffered);
  }
}

QString RequestPanel::stateText(Request request, const RequestStatus& status, bool& isFine) const {
  using Progress = RequestStatus::Progress;
  isFine = status.end == RequestEnd::Answered;
  QStringList parts;
  if (status.progress == Progress::Queued && status.period == 0ns) parts.append(tr("waits for its turn"));
  if (status.progress == Progress::Waiting) {
    parts.append(request == Request::Reset ? tr("waiting for it to announce itself")
                 : isCommand(request)      ? tr("waiting for the acknowledgement")
                                           : tr("asked, try %1").arg(status.tries));
  } else if (status.progress == Progress::NotOnBusYet) {
    parts.append(tr("not on the bus yet; it may still go out"));
  } else if (status.end != RequestEnd::None) {
    const QString end = request == Request::Reset && isFine
                            ? tr("restarted, announced itself after %1").arg(periodText(status.latency))
                        : request == Request::Reset && status.end == RequestEnd::NoAnswer
                            ? tr("not seen again within 10 s")
                        : isCommand(request) && isFine ? tr("acknowledged")
                        : isFine && status.tries > 1   ? tr("answered at try %1, %2 after the first")
                                                           .arg(status.tries)
                                                           .arg(periodText(status.ended - status.firstSent))
                        : isFine ? tr("answered in %1").arg(periodText(status.latency))
                                 : requestEndText(request, status.end);
    parts.append(
        tr("%1, %2").arg(end, agoText(std::max(m_view.log.cursor.time, m_view.log.end) - status.ended)));
  }
  if (status.period > 0ns)
    parts.append(
        tr("every %1: %2 of %3 answered")
            .arg(periodText(status.period))
            .arg(status.answered)
            .arg(status.asked > 0 && status.progress == Progress::Queued ? status.asked - 1 : status.asked));
  if (status.unasked > 0) parts.append(tr("%Ln answers too many", nullptr, static_cast<int>(status.unasked)));
  return parts.join(QStringLiteral(" · "));
}

RequestCardValues RequestPanel::loggedValues(Request request, bool withMissing) const {
  RequestCardValues values;
  if (isCommand(request)) return values;
  const Instant now = m_view.log.cursor.time;
  const Device* known = m_view.log.state != nullptr ? findDevice(*m_view.log.state, m_view.device) : nullptr;
  const AnswerHistory::Row* last = m_history->latest(request);
  QStringList parts;
  if (last == nullptr) {
    parts << (known != nullptr ? noAnswerText(*m_view.log.state, *known, request, now) : tr("never asked"));
    if (known != nullptr && !askedAgainText(*m_view.log.state, *known, request, now).isEmpty())
      values.tone = Severity::Warning;
  } else {
    const QString again =
        withMissing && known != nullptr ? askedAgainText(*m_view.log.state, *known, request, now) : QString();
    if (!again.isEmpty()) {
      values.tone = Severity::Warning;
      parts << again;
    }
    values.answer = m_history->latestText(request);
    const AnswerAge age =
        known != nullptr ? ageOfAnswer(*m_view.log.state, *known, last->time) : AnswerAge::Current;
    values.isOld = age != AnswerAge::Current;
    values.isFault = request == Request::Fault && known != nullptr && namesFault(*known);
    const std::optional<Duration> since = ageAt(last->time, now);
    const QString heard = since ? tr("heard %1").arg(agoText(*since)) : tr("heard");
    parts << (values.isOld ? tr("%1, %2", "age of an answer, why it is old").arg(heard, answerAgeText(age))
                           : heard);
  }
  values.state = parts.join(QStringLiteral(" · "));
  return values;
}

void RequestPanel::showCard(RequestCard& card, const DeviceServices* device) {
  RequestCardValues values = loggedValues(card.request(), true);
  if (device != nullptr) {
    const RequestStatus& request = device->of(card.request());
    bool isFine = false;
    // How a request ended is of now; the past knows its answers alone.
    const bool isKept = request.progress == RequestStatus::Progress::NotOnBusYet;
    const bool isOpen =
        isKept || request.progress == RequestStatus::Progress::Waiting || request.period > 0ns;
    const QString state = m_view.log.atEnd || isOpen ? stateText(card.request(), request, isFine) : QString();
    if (!state.isEmpty()) {
      values = loggedValues(card.request(), false);
      // What the log says is said too where the request does not say it: how old the answer is, and why.
      const bool isAdded = !values.answer.isEmpty() && (!isFine || values.isOld);
      values.state = isAdded ? tr("%1 · %2", "state, age of the answer").arg(state, values.state) : state;
      values.tone = isKept                                                 ? Severity::Warning
                    : request.progress == RequestStatus::Progress::Waiting ? Severity::Busy
                    : request.end == RequestEnd::None                      ? Severity::Plain
                    : !isFine                                              ? Severity::Warning
                    : values.isFault || values.isOld                       ? Severity::Plain
                                                                           : Severity::Fine;
    }
    const bool isFree =
        device->takes.has(card.request()) && request.progress != RequestStatus::Progress::Waiting && !isKept;
    values.isOffered = isFree && m_view.isLive && services().canRequest();
    values.isBehindLock = isFree && isCommand(card.request()) && isBehindLock();
  }
  card.setValues(values);
}

// Nothing but the lock is in the way.
bool RequestPanel::isBehindLock() const {
  return m_view.isLive && services().linkUp && services().locked && !services().isEnding &&
         !services().isListenOnly;
}

void RequestPanel::press(Request request) {
  if (!isCommand(request)) {
    Q_EMIT intended(intent::SendRequests{m_view.device, RequestSet{request}});
  } else if (isBehindLock()) {
    unlockFor(RequestSet{request});
  } else {
    ask(request);
  }
}

void RequestPanel::unlockFor(RequestSet requests) {
  Q_EMIT unlockForRequested([self = QPointer(this), requests, device = m_view.device] {
    if (self != nullptr) self->m_waiting = Waiting{requests, device, self->now()};
  });
}

bool RequestPanel::takesPolls() const {
  const DeviceServices* device = services().find(m_view.device);
  return device != nullptr && !(device->takes & kPolls).isEmpty();
}

bool RequestPanel::canAskAll() const {
  return takesPolls() && (isBehindLock() || (m_view.isLive && services().canRequest()));
}

void RequestPanel::askAll() {
  if (!canAskAll()) return;
  if (isBehindLock()) return unlockFor(kPolls);
  Q_EMIT intended(intent::SendRequests{m_view.device, kPolls});
}

void RequestPanel::askOnceUnlocked() {
  if (!m_waiting) return;
  const Waiting waiting = *m_waiting;
  const bool isExpected =
      m_view.isLive && m_view.device == waiting.device && now() - waiting.since < kUnlockPatience;
  if (isExpected && !services().canRequest()) return;
  m_waiting.reset();
  if (!isExpected) return;
  for (const Request command : kCommands) {
    if (waiting.requests.has(command)) return ask(command);
  }
  Q_EMIT intended(intent::SendRequests{waiting.device, waiting.requests});
}

void RequestPanel::ask(Request command) {
  m_question.ask(this, m_view,
                 {.title = tr("%1: %2?").arg(requestText(command), m_view.name),
                  .text = tr(*kConsequences.find(command)) + QLatin1Char(' ') +
                          tr("Whether the device moves then it does not say: see that nobody is near it."),
                  .verb = requestText(command)},
                 [this, wanted = intent::SendRequests{m_view.device, RequestSet{command}}](bool) {
                   Q_EMIT intended(wanted);
                 });
}

void RequestPanel::repeat(int index) {
  Q_EMIT intended(intent::Repeat{m_view.device, kPolls, kPeriods.at(static_cast<std::size_t>(index))});
}

}  // namespace deckpipe
