// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/pipe/terminal_panel.h"

#include <QCheckBox>
#include <QPushButton>
#include <algorithm>

#include "paint/app_style.h"
#include "panel/common/build.h"
#include "panel/common/labels.h"
#include "panel/common/send_hint.h"
#include "panel/pipe/file_send_bar.h"
#include "panel/pipe/pipe_input.h"
#include "panel/pipe/pipe_view.h"
#include "text/service_text.h"
#include "text/time_text.h"

namespace deckpipe {
namespace {

constexpr int kTitleLetters = 44;

}  // namespace

TerminalPanel::TerminalPanel(QWidget* parent)
    : QWidget(parent),
      m_hint(new SendHint(QStringLiteral("pipe"), this)),
      m_text(new PipeView(this)),
      m_file(new FileSendBar(this)),
      m_input(new PipeInput(this)),
      m_sendFile(new SendFileButton(*m_input, this)) {
  named(this, "terminalPanel", tr("Data pipe terminal"));
  inColumn(this, {8, 6, 8, 6}, 6, {makeTop(), m_hint, {m_text, 1}, m_file, makeBottom()});
  setFocusProxy(m_input);

  connect(m_hint, &SendHint::unlockRequested, this, &TerminalPanel::unlockRequested);
  connect(m_text, &PipeView::toolsWanted, m_more, [this] { m_more->setChecked(true); });
  connect(m_text, &PipeView::searchLeft, m_input, [this] { m_input->setFocus(); });
  connect(m_text, &PipeView::failed, this, &TerminalPanel::say);
  connect(m_file, &FileSendBar::pauseRequested, this, [this](bool pause) {
    act(pause ? intent::PipeAction::What::Pause : intent::PipeAction::What::Resume);
  });
  connect(m_file, &FileSendBar::cancelRequested, this, [this] { act(intent::PipeAction::What::Cancel); });
  connect(m_input, &PipeInput::typed, this, [this](const std::string& bytes) {
    say({});
    Q_EMIT intended(intent::PipeWrite{m_view.device, bytes});
  });
  connect(m_input, &PipeInput::refused, this, &TerminalPanel::say);
  connect(m_input, &PipeInput::findRequested, m_text, &PipeView::beginSearch);
  connect(m_sendFile, &SendFileButton::intended, this, &TerminalPanel::intended);
  connect(m_sendFile, &SendFileButton::failed, this, &TerminalPanel::say);
  showState();
}

// Whom it talks to, and beside it the manual's caution, or what to decide.
QLayout* TerminalPanel::makeTop() {
  m_title = named(new ElidedLabel(this, Qt::ElideMiddle), "pipeDevice", tr("Device at the other end"));
  m_title->setFont(boldFont(m_title->font()));
  m_title->setMaximumWidth(kTitleLetters * fontMetrics().averageCharWidth());
  const QString caution =
      tr("The manual calls the data pipe “simplistic”, “not appropriate for control-related "
         "messaging” and “not available for integrator use”.");
  m_caution = makeWords(this, "pipeCaution", caution, Ink::Secondary);
  m_caution->setText(caution);
  m_caution->setFont(secondaryFont(font()));
  return inRow(16, {m_title, {m_caution, 1}, {makeStallBar(), 1}});
}

QWidget* TerminalPanel::makeStallBar() {
  m_stallBar = new QWidget(this);
  m_stallBar->setObjectName(QStringLiteral("pipeStall"));
  m_stall = makeWords(m_stallBar, "pipeStallText", tr("Why sending stopped"), Ink::Warning);
  m_forTheRest = new QCheckBox(m_stallBar);
  m_forTheRest->setObjectName(QStringLiteral("pipeForTheRest"));
  m_forTheRest->setToolTip(tr("Resend or Skip at every further missing ack of this file or text, "
                              "up to %1 in a row")
                               .arg(kMaxMissingAcks));
  auto* row = inRow(m_stallBar, {{inColumn(2, {m_stall, m_forTheRest}), 1}});
  connect(m_forTheRest, &QCheckBox::toggled, this, &TerminalPanel::showState);
  const auto add = [&](const char* name, const QString& text, const QString& tip,
                       intent::PipeAction::What what) {
    QPushButton* button = makeButton(m_stallBar, name, text);
    button->setToolTip(tip);
    row->addWidget(button);
    connect(button, &QPushButton::clicked, this, [this, what] { decide(what); });
    return button;
  };
  m_resend =
      add("pipeResend", tr("Resend"), tr("The packet once more. If only its ack was lost, it arrives twice."),
          intent::PipeAction::What::Resend);
  m_skip = add("pipeSkip", tr("Skip"), tr("Goes on as if the packet had arrived."),
               intent::PipeAction::What::Skip);
  add("pipeAbort", tr("Abort"), tr("Sends nothing more of what waits."), intent::PipeAction::What::Abort);
  return m_stallBar;
}

QLayout* TerminalPanel::makeBottom() {
  m_more = makeButton(this, "pipeMore", tr("More"));
  m_more->setCheckable(true);
  m_more->setToolTip(tr("What is shown, search, and saving"));
  connect(m_more, &QPushButton::toggled, m_text, &PipeView::showTools);
  return inRow({{m_input, 1}, m_sendFile, m_more});
}

void TerminalPanel::setView(const PanelView& view) {
  if (view.device != m_view.device) {
    m_input->clear();  // what was typed was meant for the other
    m_trouble.clear();
    m_forTheRest->setChecked(false);
  }
  m_view = view;
  m_sendFile->setView(view);
  m_text->setView(view.log, view.device);
  const bool isWaiting = std::ranges::any_of(services().devices, [](const DeviceServices& at) {
    return at.pipe && at.pipe->progress == PipeStatus::Progress::Stalled;
  });
  setWindowTitle(isWaiting ? tr("Data pipe – waits for you") : QString());
  showState();
}

// What is said for the rest once is not said the next time.
void TerminalPanel::decide(intent::PipeAction::What what) {
  act(what, what != intent::PipeAction::What::Abort && m_forTheRest->isChecked());
  m_forTheRest->setChecked(false);
}

Instant TerminalPanel::now() const { return std::max(m_view.log.cursor.time, m_view.log.end); }

QString TerminalPanel::restartHint(const PipeStatus& pipe) const {
  const Instant restarted = m_text->restartedSinceSent();
  if (restarted == kNotYet) return {};
  const QString when = agoText(now() - restarted);
  if (pipe.notTaken == 0) return tr("The device restarted %1, after what was sent to it last.").arg(when);
  return tr("The device restarted %1: %Ln characters that were typed before were not taken.", nullptr,
            static_cast<int>(pipe.notTaken))
      .arg(when);
}

QString TerminalPanel::ownHint(const DeviceServices* device, const PipeStatus& pipe) const {
  if (device == nullptr) return tr("Choose an Akron device to talk to.");
  if (device->address == kNullAddress) return tr("%1 has no address now.").arg(m_view.name);
  if (services().refusal == Refusal::Busy || services().refusal == Refusal::TooMuch)
    return refusalText(services().refusal);
  if (const QString restart = restartHint(pipe); !restart.isEmpty()) return restart;
  if (pipe.isSendingFile() || pipe.progress == PipeStatus::Progress::Stalled) return {};  // said beside it
  return pipe.rest != PipeStatus::Rest::Ask ? restText(pipe) : typedDoubtText(pipe);
}

void TerminalPanel::showState() {
  setText(*m_title, m_view.name);
  m_title->setToolTip(m_view.name);
  m_title->setVisible(!m_view.name.isEmpty());
  const DeviceServices* device = services().find(m_view.device);
  const PipeStatus pipe = device != nullptr && device->pipe ? *device->pipe : PipeStatus{};
  m_hint->setStatus(services(), m_view.isLive, ownHint(device, pipe), m_trouble);
  showStall(pipe);
  m_file->setStatus(pipe, now(), m_view.isLive);
  const bool mayType = m_view.isLive && services().canRequest() && device != nullptr &&
                       device->address != kNullAddress && !pipe.isSendingFile();
  m_input->setOffered(mayType, m_view.name, m_text->restartedSinceSent() != kNotYet);
  m_sendFile->setEnabled(mayType && pipe.progress != PipeStatus::Progress::Stalled);
}

void TerminalPanel::showStall(const PipeStatus& pipe) {
  const bool isStalled = pipe.progress == PipeStatus::Progress::Stalled;
  m_stallBar->setVisible(isStalled);
  m_caution->setVisible(!isStalled);  // a small screen has room for one of them
  m_resend->setEnabled(m_view.isLive);
  m_skip->setEnabled(m_view.isLive);
  // There may be no rest, and what is not for want of an ack is asked each time.
  const bool hasRest =
      pipe.waiting > 0 || (pipe.isSendingFile() && pipe.fileSize - pipe.fileSent > kPipePacket);
  m_forTheRest->setVisible(pipe.stall == PipeStatus::Stall::NoAck && hasRest);
  m_forTheRest->setEnabled(m_view.isLive);
  if (!isStalled || m_forTheRest->isHidden()) m_forTheRest->setChecked(false);
  m_forTheRest->setText(pipe.isSendingFile() ? tr("For the rest of this file too")
                                             : tr("For the rest of this text too"));
  if (isStalled) setText(*m_stall, stallWords(pipe));
  m_stall->setToolTip(m_stall->text());
}

QString TerminalPanel::stallWords(const PipeStatus& pipe) const {
  if (!m_forTheRest->isChecked()) return stallText(pipe);
  return tr("Resend may deliver pieces twice, Skip may leave gaps. It stops after %1 missing acks in a row.")
      .arg(kMaxMissingAcks);
}

void TerminalPanel::say(const QString& trouble) {
  m_trouble = trouble;
  showState();
}

}  // namespace deckpipe
