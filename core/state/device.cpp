// SPDX-License-Identifier: GPL-3.0-or-later
#include "state/device.h"

#include <algorithm>
#include <cstdlib>

#include "bus/canopen.h"
#include "bus/j1939.h"
#include "protocol/gateway.h"

namespace deckpipe {
namespace {

constexpr int kLeap = 50;  // 0.1 degree: no monitor turns so far in one period of its status

std::size_t paceOf(MessageId id) {
  return static_cast<std::size_t>(std::ranges::find(kOwnPeriodicReports, id) - kOwnPeriodicReports.begin());
}

bool isLeap(const PositionReading& a, const PositionReading& b) {
  return a.state == PositionState::Ok && b.state == PositionState::Ok &&
         std::abs(a.tenths - b.tenths) > kLeap;
}
bool isLeap(const PositionLimitStatus& a, const PositionLimitStatus& b) {
  return isLeap(a.rotation, b.rotation) || isLeap(a.elevation, b.elevation);
}

std::uint64_t objectOf(const Frame& frame) {
  return readBits(frame.data, gateway::kIndex.bits) << 8 | readBits(frame.data, gateway::kSubindex.bits);
}

// A master aborts too, on another identifier.
bool isFromNode(const Frame& frame) {
  return CobId::of(frame.identifier()).function == static_cast<std::uint16_t>(CobFunction::SdoResponse);
}

}  // namespace

Instant Device::staleDue(MessageId id) const {
  const Instant last = report(id).at;
  if (last == kNotYet || isStale(id) || listenedSince == kNever) return kNever;
  return std::max(last, listenedSince) + staleAfter(id);
}

Duration Device::periodOf(MessageId id) const {
  const auto place = std::ranges::find(kNodeReports, id);
  return place == kNodeReports.end()
             ? 0ns
             : m_periods[static_cast<std::size_t>(place - kNodeReports.begin())].value();
}

bool Device::hasPeriod() const {
  return std::ranges::any_of(kNodeReports, [this](MessageId id) { return hasPeriod(id); });
}

// A setting that is slower than the usual one counts.
Duration Device::staleAfter(MessageId id) const {
  const Duration usual = deckpipe::staleAfter(id);
  return slack() + (kind == Kind::Node ? std::max(usual, kStalePeriods * periodOf(id)) : usual);
}

// A node is silent once each of its messages is missing.
Duration Device::silentAfter() const {
  Duration after = kSilentAfter;
  if (kind != Kind::Node) return after;
  for (const MessageId id : kNodeReports) {
    if (report(id).isKnown())
      after = std::max(after, report(id).at - lastStatus + deckpipe::silentAfter(periodOf(id)));
  }
  return after;
}

Instant Device::nextDeadline() const {
  Instant next = kNever;
  for (const MessageId id : kPeriodicReports) next = std::min(next, staleDue(id));
  return next;
}

void Device::timeCame(Instant time) {
  for (const MessageId id : kPeriodicReports) {
    if (staleDue(id) <= time) m_stale.add(id);
  }
}

void Device::linkCameBack(Instant time) {
  m_gapEnd = time;
  addressChanges = 0;
  formerAddresses = {};
  malformed = 0;
  m_malformed = {};
  doubledSince = doubled = paired = kNotYet;
  isOnlyEqual = false;
  m_paces = {};
  m_periods = {};
  for (Instant& asked : m_askedInVain) asked = kNotYet;
  m_refused = {};
  // A log without times stands still at 0.
  if (time == Instant{}) forgetUntil(kNever);
}

void Device::forgetUntil(Instant end) {
  for (Report& report : m_reports) {
    if (report.at < end) report = {};
  }
  for (const MessageId id : kPeriodicReports) {
    if (!report(id).isKnown()) m_stale.remove(id);
  }
  if (!permissive().isKnown()) permissiveFrom = {};
  if (partNumber.at < end) partNumber = {};
  if (operationalErrorCode.at < end) operationalErrorCode = {};
  if (commanded.at < end) commanded = {};
  if (lastStatus < end) lastStatus = kNotYet;
}

void Device::statusCame(Instant time) {
  if (lastStatus != kNotYet && hasPeriod() && time - std::max(lastStatus, listenedSince) >= silentAfter())
    resumed = time;
  lastStatus = time;
}

// A status replaces the one before it, which tells how far the two are apart.
void Device::takeStatus(const Frame& frame, MessageId id, Instant time) {
  statusCame(time);
  // What came before the link was down is not compared.
  if (!report(id).isKnown() || report(id).at < listenedSince) return;
  const Frame before = report(id).frame();
  const bool differs = before.data != frame.data;
  bool leaps = false;
  if (differs && id == MessageId::PositionLimitStatus) {
    const PositionLimitStatus was = PositionLimitStatus::of(before), now = PositionLimitStatus::of(frame);
    leaps = isLeap(was, now);
    if (was.operationalError == Status2::On && now.operationalError != Status2::On) isErrorOver = true;
  }
  const Duration gap = time - report(id).at;
  if (kind == Kind::Node) {
    m_periods[static_cast<std::size_t>(std::ranges::find(kNodeReports, id) - kNodeReports.begin())].came(gap);
  } else if (!isCoarse) {
    takeDoubling(m_paces[paceOf(id)].next(id, gap, differs, leaps), time);
  }
}

void Device::takeDoubling(Doubling doubling, Instant time) {
  const auto isRecent = [time](Instant at) { return at != kNotYet && time - at <= kDoubledFor; };
  switch (doubling) {
    case Doubling::None: return;
    case Doubling::InPairs:
      paired = time;
      if (isOnlyEqual) doubledSince = doubled = kNotYet;
      isOnlyEqual = false;
      return;
    case Doubling::Equal:
      // Another of its statuses shows that the log holds each twice.
      if (isRecent(paired)) return;
      isOnlyEqual = isOnlyEqual || !isRecent(doubled);
      break;
    case Doubling::Differing: isOnlyEqual = false; break;
  }
  if (doubledSince == kNotYet || doubledSince < addressSince) doubledSince = time;
  doubled = time;
}

void Device::take(const Frame& frame, MessageId id, Instant time) {
  if (isOwnPeriodicReport(messageOf(id))) takeStatus(frame, id, time);
  if (const std::optional<Request> request = requestAnsweredBy(id)) answered(*request);
  if (const std::size_t place = kReportPlaces[id]; place < kReports.size()) {
    m_reports[place].set(frame, time);
    m_stale.remove(id);
    m_malformed.remove(id);
  }
  switch (id) {
    case MessageId::SoePermissive: permissiveFrom = J1939Id::of(frame.identifier()).source; break;
    case MessageId::GatewayJoystick: commanded.set(frame, time); break;
    case MessageId::SdoReadRequest:
      if (objectOf(frame) == sdo::kFaultStatus) asked(Request::Fault, time);
      break;
    case MessageId::SdoReadResponse: takeSdo(frame, time); break;
    case MessageId::SdoAbort:
      if (isFromNode(frame) && objectOf(frame) == sdo::kFaultStatus) refused(Request::Fault);
      break;
    case MessageId::Heartbeat:
      if (heartbeatState(frame) == gateway::kBooting) restarted = time;
      break;
    case MessageId::FaultResponse: isErrorOver = false; break;
    default: break;
  }
}

void Device::takeSdo(const Frame& frame, Instant time) {
  const std::uint64_t object = objectOf(frame);
  const unsigned size = sdo::valueSize(frame.data[0]);
  if (object == sdo::kDeviceType && size == 4) {
    partNumber.set(static_cast<std::uint32_t>(readBits(frame.data, gateway::kValue.bits)), time);
  } else if (object == sdo::kFaultStatus && size == 4) {
    m_reports[kReportPlaces[MessageId::FaultResponse]].set(frame, time);
    answered(Request::Fault);
  } else if (object == sdo::kFaultStatus) {
    refused(Request::Fault);
  } else if (object == sdo::kOperationalError && size == 2) {
    operationalErrorCode.set(static_cast<std::uint16_t>(readBits(frame.data, gateway::kValue.bits)), time);
    isErrorOver = false;
  }
}

void Device::takeMalformed(const Frame& frame, MessageId id, Instant time) {
  ++malformed;
  if (isOwnPeriodicReport(messageOf(id))) {
    statusCame(time);
    m_malformed.add(id);
    m_malformedStatus = time;
  }
  const Request request = messageOf(id).request;
  if (request != Request::Count) refused(request);
  // Shorter than four bytes it names no object.
  if (id == MessageId::SdoReadResponse && frame.length >= 4 && objectOf(frame) == sdo::kFaultStatus)
    refused(Request::Fault);
}

bool Device::isMalformedNow(MessageId id, Instant now) const {
  return m_malformed.has(id) && now - m_malformedStatus < staleAfter(id);
}

}  // namespace deckpipe
