// SPDX-License-Identifier: GPL-3.0-or-later
// deckpipectl move: holds the console's joystick for a short time. It wants what design.md section 7 wants of a
// program that moves monitors (rule 20); what is sent, and when it ends, is the joystick service's.
#include <poll.h>
#include <unistd.h>

#include <QElapsedTimer>
#include <QTimer>
#include <algorithm>
#include <cerrno>
#include <cmath>
#include <utility>

#include "command.h"
#include "device_finder.h"
#include "json_line.h"
#include "live_run.h"
#include "moves_monitors.h"
#include "protocol/address_book.h"
#include "request_words.h"
#include "service/motion_watch.h"
#include "session/clocks.h"

namespace deckpipe::ctl {
namespace {

using JoystickProgress = JoystickStatus::Progress;

constexpr std::uint64_t kLongestMove = 10'000;  // ms
constexpr int kTurn = 20;                       // ms between two words that it is held
constexpr int kListenFirst = 1'100;             // ms; what was heard in them is known a tick later
constexpr double kEndPatience = 2;              // s, for neutral to be said

struct MovePlan {
  Address source;
  std::vector<Pin> moves;
  Deflection x, y;
  qint64 length = 0;  // ms
  bool endsWithInput = false;
  bool acceptsUnproven = false;
};

QString pinText(const Pin& pin) { return DeviceName{pin, {}}.text(); }

// Standard input is there and has not ended. What comes on it means nothing.
bool inputGoesOn() {
  pollfd input{STDIN_FILENO, POLLIN, 0};
  const int ready = ::poll(&input, 1, 0);
  if (ready <= 0) return ready == 0 || errno == EINTR;
  // The writer of the input has let go, whatever still waits to be read.
  if ((input.revents & (POLLHUP | POLLERR | POLLNVAL)) != 0) return false;
  char passed[4096];
  const ssize_t count = ::read(STDIN_FILENO, passed, sizeof passed);
  return count > 0 || (count < 0 && (errno == EINTR || errno == EAGAIN));
}

class MonitorMove {
 public:
  MonitorMove(LiveRun& run, MovePlan plan);

 private:
  enum class Phase : std::uint8_t { Listening, Finding, Arming, Moving, Ending };
  struct Stood {
    PositionReading rotation, elevation;
  };

  bool hasListened();
  void tick();
  void find();
  // Empty where the monitors that are heard are those that were named.
  QString whyNotThese() const;
  void arm();
  void begin();
  void hold();
  void follow();
  void end(std::string_view how, ExitStatus status);
  void report();
  void refuse(const QString& why);
  const JoystickStatus& joystick() const { return m_run.services().joystick; }
  Stood positionOf(const Pin& pin) const;
  void addAngle(JsonLine& line, const char* key, const PositionReading& reading) const;

  LiveRun& m_run;
  MovePlan m_plan;
  Phase m_phase = Phase::Listening;
  QElapsedTimer m_since, m_asked, m_held;
  QTimer m_turn;
  bool m_isSourceHeard = false, m_wasActive = false, m_wasHeld = false, m_isReported = false;
  std::uint64_t m_armSerial = 0, m_holdSerial = 0;
  std::vector<Stood> m_before;
  std::string m_how;
  qint64 m_heldFor = 0;
  ExitStatus m_status = kNotWhole;
};

MonitorMove::MonitorMove(LiveRun& run, MovePlan plan) : m_run(run), m_plan(std::move(plan)) {
  run.mayUnlock = [this] { return hasListened(); };
  run.onReady = [this] {
    m_phase = Phase::Finding;
    m_since.start();
    m_asked.start();
  };
  run.onTick = [this] { tick(); };
  run.onStop = [this]() -> std::optional<ExitStatus> {
    if (m_phase < Phase::Arming) return kNotWhole;
    end("stopped", kNotWhole);
    return {};
  };
  run.follower().onFrame = [this](const Frame& frame, const Classified&) {
    const bool isForeign = frame.isExtended() && !frame.isError() && (frame.flags & Frame::kSent) == 0;
    if (isForeign && Address{static_cast<std::uint8_t>(frame.id)} == m_plan.source) m_isSourceHeard = true;
  };
  m_turn.setTimerType(Qt::PreciseTimer);
  QObject::connect(&m_turn, &QTimer::timeout, &m_run, [this] { hold(); });
}

void MonitorMove::refuse(const QString& why) {
  m_run.say(QStringLiteral("does not move: ") + why);
  m_run.finish(kNotWhole);
}

bool MonitorMove::hasListened() {
  if (!m_since.isValid()) m_since.start();
  if (m_since.elapsed() < kListenFirst) return false;
  if (!m_isSourceHeard) return true;
  refuse(QStringLiteral("another node sends from address %1").arg(addressText(m_plan.source)));
  return false;
}

void MonitorMove::tick() {
  switch (m_phase) {
    case Phase::Listening: return;
    case Phase::Finding: return find();
    case Phase::Arming:
      if (m_run.services().refusedSerial == m_armSerial)
        return refuse(QLatin1String(kRefusalWords[m_run.services().refusal].sentence));
      if (joystick().progress == JoystickProgress::Armed) return begin();
      if (joystick().progress != JoystickProgress::Off) {
        m_wasActive = true;
      } else if (m_wasActive) {
        refuse(QLatin1String(kMotionCauseWords[joystick().cause].sentence));
      }
      return;
    case Phase::Moving: return follow();
    case Phase::Ending:
      if (joystick().progress == JoystickProgress::Off) report();
      return;
  }
}

// The NAMEs were asked for at unlocking, and PINs follow them. An answer may get lost on a busy bus.
void MonitorMove::find() {
  if (m_asked.elapsed() >= DeviceFinder::kAskAgain) {
    m_asked.start();
    m_run.session().intend(intent::RequestNames{});
  }
  if (m_since.elapsed() < DeviceFinder::kHearEveryone) return;
  if (m_isSourceHeard)
    return refuse(QStringLiteral("another node sends from address %1").arg(addressText(m_plan.source)));
  if (const QString why = whyNotThese(); !why.isEmpty()) return refuse(why);
  arm();
}

QString MonitorMove::whyNotThese() const {
  QStringList missing;
  std::vector<Stranger> others;
  const std::vector<const Device*> heard = monitorsHeard(m_run.follower().state(), m_run.channel());
  for (const Pin& pin : m_plan.moves) {
    if (std::ranges::count(heard, pin, [](const Device* device) { return device->pin; }) == 0)
      missing += pinText(pin);
  }
  for (const Device* device : heard) {
    if (std::ranges::count(m_plan.moves, device->pin) == 0)
      others.push_back({.address = device->address, .node = device->node, .pin = device->pin});
  }
  QStringList why;
  if (!missing.isEmpty())
    why += QStringLiteral("not heard as a monitor: %1").arg(missing.join(QStringLiteral(", ")));
  if (!others.empty())
    why += QStringLiteral("it would also move what is not named by --pin: %1").arg(strangersText(others));
  return why.join(QStringLiteral("; "));
}

void MonitorMove::arm() {
  QStringList names;
  for (const Pin& pin : m_plan.moves) {
    const Device* device = m_run.follower().state().devices().byPin(m_run.channel(), pin);
    names += strangersText({{.address = device->address, .pin = pin}});
    if (positionOf(pin).rotation.state != PositionState::Ok)
      m_run.say(QStringLiteral("cannot see whether %1 moves: it reports no position").arg(pinText(pin)));
  }
  m_run.say(QStringLiteral("moves %1 %2, and whoever else listens to address %3 without a word: %4")
                .arg(m_plan.moves.size())
                .arg(m_plan.moves.size() == 1 ? QStringLiteral("monitor") : QStringLiteral("monitors"))
                .arg(addressText(m_plan.source), names.join(QStringLiteral("; "))));
  m_phase = Phase::Arming;
  m_armSerial = m_run.session().intend(intent::ArmJoystick{.source = m_plan.source,
                                                           .moves = m_plan.moves,
                                                           .limit = kSpeedLimit,
                                                           .acceptsUnproven = m_plan.acceptsUnproven,
                                                           .platform = "deckpipectl move"});
  if (m_armSerial == 0) refuse(QLatin1String(kRefusalWords[m_run.snapshot().notSent].sentence));
}

MonitorMove::Stood MonitorMove::positionOf(const Pin& pin) const {
  const Device* device = m_run.follower().state().devices().byPin(m_run.channel(), pin);
  if (device == nullptr || !device->isKnownNow(MessageId::PositionLimitStatus))
    return {{PositionState::NotFitted, 0}, {PositionState::NotFitted, 0}};
  const PositionLimitStatus position = device->position().value();
  return {position.rotation, position.elevation};
}

// Let go first, then held with the stick at rest: only so it may be deflected.
void MonitorMove::begin() {
  for (const Pin& pin : m_plan.moves) m_before.push_back(positionOf(pin));
  m_phase = Phase::Moving;
  m_held.start();
  m_run.session().intend(intent::HoldJoystick{});
  m_holdSerial =
      m_run.session().intend(intent::HoldJoystick{.isHeld = true, .x = {}, .y = {}, .verified = bootTime()});
  m_turn.start(kTurn);
}

// Each word that it is held is good for 100 ms: whatever keeps this from being called lets go.
void MonitorMove::hold() {
  if (m_phase != Phase::Moving) return;
  if (m_plan.endsWithInput && !inputGoesOn()) return end("input_ended", kDone);
  if (m_held.elapsed() >= m_plan.length) return end("done", kDone);
  m_run.session().intend(
      intent::HoldJoystick{.isHeld = true, .x = m_plan.x, .y = m_plan.y, .verified = bootTime()});
}

void MonitorMove::follow() {
  const bool isHeld = joystick().progress == JoystickProgress::Held;
  m_wasHeld = m_wasHeld || isHeld;
  const bool isRefused = m_run.services().refusedSerial >= m_holdSerial;
  if (isHeld || (!m_wasHeld && !isRefused)) return;
  const MotionCause cause = joystick().cause;
  if (cause == MotionCause::None) {
    m_run.say(QLatin1String(kRefusalWords[m_run.services().refusal].sentence));
    return end(kRefusalWords[m_run.services().refusal].word, kNotWhole);
  }
  m_run.say(QStringLiteral("ended: ") + QLatin1String(kMotionCauseWords[cause].sentence));
  end(kMotionCauseWords[cause].word, kNotWhole);
}

void MonitorMove::end(std::string_view how, ExitStatus status) {
  if (m_phase == Phase::Ending) return;
  m_turn.stop();
  m_heldFor = m_held.isValid() ? m_held.elapsed() : 0;
  m_phase = Phase::Ending;
  m_how = how;
  m_status = status;
  m_run.session().intend(intent::DisarmJoystick{});
  m_run.after(kEndPatience, [this] {
    m_run.say(QStringLiteral("cannot tell whether neutral is on the bus"));
    m_status = kNotWhole;
    report();
  });
}

void MonitorMove::addAngle(JsonLine& line, const char* key, const PositionReading& reading) const {
  line.add(key, reading.state == PositionState::Ok ? Value::decimal(reading.tenths, 1) : Value());
}

void MonitorMove::report() {
  if (std::exchange(m_isReported, true)) return;
  const auto inMs = [](Duration d) { return Value::decimal(d / 100us, 1); };
  if (joystick().wentOutLate) m_run.say(QStringLiteral("an old motion frame has just gone out"));
  for (std::size_t i = 0; i < m_before.size(); ++i) {
    const Stood now = positionOf(m_plan.moves[i]);
    JsonLine line;
    line.add("pin", m_plan.moves[i]).add("source", m_plan.source).add("end", m_how);
    line.add("held_ms", m_heldFor).add("frames", joystick().frames);
    line.add("period_ms", inMs(joystick().period));
    line.add("worst_gap_ms", inMs(joystick().worstGap));
    addAngle(line, "rotation_before_deg", m_before[i].rotation);
    addAngle(line, "rotation_deg", now.rotation);
    addAngle(line, "elevation_before_deg", m_before[i].elevation);
    addAngle(line, "elevation_deg", now.elevation);
    m_run.output().text() += line.text();
  }
  m_run.finish(m_status);
}

// A deflection in percent, one decimal; no more than may be had without raising the limit.
Deflection deflectionOf(Arguments& arguments, const char* name) {
  bool isNumber = false;
  const double tenths = arguments.text(name).toDouble(&isNumber) * 10;
  if (isNumber && std::abs(tenths) <= kSpeedLimit && tenths == std::round(tenths))
    return Deflection::of(static_cast<int>(tenths)).value_or(Deflection());
  arguments.bad(QStringLiteral("--%1 wants per cent from -%2 to %2, in steps of 0.1")
                    .arg(QLatin1String(name))
                    .arg(kSpeedLimit / 10));
  return {};
}

}  // namespace

ExitStatus moveCommand(const QStringList& given) {
  Arguments arguments(
      given,
      R"(Moves monitors for a short time: sends joystick messages every 20 ms, from an address of its own, while
it is held, and neutral for half a second at the end. A joystick message has no addressee: every
controller that listens to the address moves, so all monitors that are heard must be named by --pin,
and no other. Silent ones cannot be known: see the monitor, and nobody near it.
It listens 1 s first. It ends after --for, by Ctrl+C, SIGTERM or SIGHUP, by whatever speaks against it,
and with --hold at the end of standard input; status 0 only after --for or that end.
It moves simulated monitors alone, on a vcan or virtualcan: real ones not yet.
This is no emergency stop and no safety device. It raises no soft limit, gives no permissive, presses
no switch, aims at no angle, and reaches no monitor behind a gateway.
One JSON line for each PIN: pin, source, end, held_ms, frames, period_ms, worst_gap_ms, and
rotation_before_deg, rotation_deg, elevation_before_deg, elevation_deg, null where not reported.)");
  arguments.add(liveOptions());
  arguments.add({
      {"pin", "A monitor that will move; once for each that is heard.", "PIN"},
      {"x", "Rotation speed in per cent, right positive, at most 30; 0 by default.", "PERCENT", "0"},
      {"y", "Stick forward (elevation down) positive, back (up) negative, at most 30; 0 by default.",
       "PERCENT", "0"},
      {"for", "So long, 1 to " + std::to_string(kLongestMove) + " ms.", "MS"},
      {"source", "Joystick's address, 33 to 38 in hex; 33 wins over all others; 38 by default.", "HEX",
       addressText(kLastJoystick).toStdString()},
      {"hold", "End with standard input too."},
      movesMonitorsOption(),
  });
  if (const auto status = arguments.parse()) return *status;
  const LiveSettings settings = liveSettings(arguments, true);
  MovePlan plan;
  for (const QString& text : arguments.texts("pin")) {
    const auto pin = Pin::parse(text.toStdString());
    if (!pin) arguments.bad(QStringLiteral("--pin '%1' is not a PIN of 15 characters").arg(text));
    if (pin && std::ranges::count(plan.moves, *pin) == 0) plan.moves.push_back(*pin);
  }
  if (plan.moves.empty()) arguments.bad(QStringLiteral("a --pin is wanted for each monitor that will move"));
  plan.source = arguments.address("source");
  if (!isJoystickAddress(plan.source))
    arguments.bad(QStringLiteral("--source wants a joystick's address, %1 to %2")
                      .arg(addressText(kFirstJoystick), addressText(kLastJoystick)));
  plan.x = deflectionOf(arguments, "x");
  plan.y = deflectionOf(arguments, "y");
  plan.length = static_cast<qint64>(arguments.number("for", 1, kLongestMove));
  if (plan.x.isAtRest() && plan.y.isAtRest())
    arguments.bad(QStringLiteral("nothing would move: --x or --y is wanted"));
  plan.endsWithInput = arguments.has("hold");
  if (arguments.areBad()) return kBadUsage;
  if (const auto trouble = movesMonitorsTrouble(arguments, settings.link)) return arguments.bad(*trouble);
  // Rules 4 and 5 want more of real monitors: a proof of the echo, and a person's word at each arming.
  if (mayHoldRealMonitors(settings.link))
    return arguments.bad(
        QStringLiteral("real monitors are not moved yet: it moves simulated ones on a vcan or "
                       "virtualcan alone, as nothing proves yet that a frame is on this bus"));
  plan.acceptsUnproven = true;
  if (plan.endsWithInput && !inputGoesOn())
    return arguments.bad(QStringLiteral("--hold: standard input has ended already"));

  LiveRun run(settings, true);
  MonitorMove move(run, std::move(plan));
  return run.run();
}

}  // namespace deckpipe::ctl
