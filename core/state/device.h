// SPDX-License-Identifier: GPL-3.0-or-later
// One device as a person thinks of it: an Akron controller by its PIN, wherever its address went on its
// channel; an address that sends such messages without a PIN being known; or a CANopen node behind a gateway.
// Everything it reported, each with its time.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "base/ids.h"
#include "log/time_grain.h"
#include "protocol/lists.h"
#include "protocol/typed.h"
#include "state/pace.h"
#include "state/timed.h"

namespace deckpipe {

// Without a periodic message for so long a device is silent, if its own period is not longer: three heartbeats, thirty
// of any other period.
inline constexpr Duration kSilentAfter = 3s;
// The same of one whose period was heard.
constexpr Duration silentAfter(Duration period) { return std::max(kSilentAfter, kStalePeriods * period); }

// From its first claim to its announcement a device needs up to this long.
inline constexpr Duration kOneStart = 1s;

// So long two devices at one address are believed after their statuses last showed it.
inline constexpr Duration kDoubledFor = 10s;

// An address that a device had, and until when.
struct FormerAddress {
  Instant until = kNotYet;
  Address address;
  friend bool operator==(const FormerAddress&, const FormerAddress&) = default;
};

struct Device {
  enum class Kind : std::uint8_t { Free, Pin, Address, Node };

  Kind kind = Kind::Free;
  Channel channel;
  Address address;  // null while its address was lost and no other is known
  NodeId node;      // Kind::Node
  Pin pin;          // Kind::Pin
  std::uint16_t addressChanges = 0;
  Instant addressSince = kNotYet;
  std::array<FormerAddress, 3> formerAddresses;  // the latest first; null addresses where there were fewer
  Instant announced = kNotYet;                   // the PIN that it has, or had before its link was down
  Instant listenedSince = kNotYet;  // when the link of its channel last came up; kNever while it is down
  Instant lastHeard = kNotYet;
  std::uint32_t frames = 0;
  std::uint32_t malformed = 0;
  FrameRate rate;

  Instant lastStatus = kNotYet;  // when one of kOwnPeriodicReports came last, of whatever length
  Instant resumed = kNotYet;     // when they came again after a silence
  Instant restarted = kNotYet;   // when it said its NAME or PIN of its own accord, or as a node booted
  Instant provoked =
      kNotYet;  // when it alone had cause to: asked for its NAME, or its address claimed by another
  // When statuses first and last showed that two devices send from its address (pace.h). The first time stays as long
  // as it has the address.
  Instant doubledSince = kNotYet;
  Instant doubled = kNotYet;
  Instant paired = kNotYet;  // when a status changed last as in a log that holds each frame twice
  bool isOnlyEqual = false;  // nothing but equal statuses showed the two: the log may hold each frame twice
  bool isCoarse = false;     // its log has times that are good to the second
  bool isErrorOver = false;  // so says a status of the operational error whose code an answer gave before

  Address permissiveFrom;  // the master controller that sent the permissive

  // Kind::Node
  Timed<std::uint32_t> partNumber;
  Timed<std::uint16_t> operationalErrorCode;
  Reported<&BasicJoystick::of> commanded;  // RPDO1; the sender is not known

  // The part number; 0: not said, or not since the link came back.
  std::uint32_t part() const { return isBeforeGap(partNumber.at) ? 0 : partNumber.value; }
  // Null where it had none before.
  Address previousAddress() const { return formerAddresses.front().address; }
  // A frame of it came.
  void heard(Instant time) {
    rate.count(time, lastHeard);
    lastHeard = time;
    ++frames;
  }

  // Frames come again after its link was down. What it said keeps its time, but where there are no times to keep.
  // What is counted begins anew, and its earlier addresses were another's, as far as is known.
  void linkCameBack(Instant time);
  // Somebody else said what was said before that.
  void forgetBeforeGap() { forgetUntil(m_gapEnd); }
  // Whether a report is of whoever is there: of before a gap it is only as long as nothing is heard behind it.
  bool isKnownNow(MessageId id) const {
    return report(id).isKnown() && (!isBeforeGap(report(id).at) || isBeforeGap(lastHeard));
  }

  // It claims an address and then announces itself: that is one start.
  void starts(Instant time) {
    if (restarted == kNotYet || time - restarted > kOneStart) restarted = time;
  }

  // The last message of a kind, one of kReports.
  const Report& report(MessageId id) const { return m_reports[kReportPlaces[id]]; }
  template <auto Of>
  Reported<Of> reported(MessageId id) const {
    return Reported<Of>(report(id));
  }
  auto position() const { return reported<&PositionLimitStatus::of>(MessageId::PositionLimitStatus); }
  auto rotationLimits() const { return reported<&SoftLimits::ofRotation>(MessageId::RotationSoftLimits); }
  auto elevationLimits() const { return reported<&SoftLimits::ofElevation>(MessageId::ElevationSoftLimits); }
  auto outputs() const { return reported<&DigitalOutputs::of>(MessageId::DigitalOutputs); }
  auto miniOutputs() const { return reported<&MiniOutputs::of>(MessageId::MiniDigitalOutputs); }
  auto inputs() const { return reported<&DigitalInputs::of>(MessageId::DigitalInputs); }
  auto permissive() const { return reported<&Permissive::of>(MessageId::SoePermissive); }
  // Of a node from SDO 5001.01, which has the same map.
  auto faults() const { return reported<&FaultStatus::of>(MessageId::FaultResponse); }
  auto firmware() const { return reported<&FirmwareVersions::of>(MessageId::FirmwareResponse); }
  auto pcode() const { return reported<&PcodeVersion::of>(MessageId::PcodeResponse); }
  auto config() const { return reported<&ConfigVersion::of>(MessageId::ConfigResponse); }
  auto heartbeat() const { return reported<&heartbeatState>(MessageId::Heartbeat); }

  // When it was first asked for something without an answer since; kNotYet: it answered, or was never asked.
  Instant askedInVain(Request request) const { return m_askedInVain[request]; }
  void asked(Request request, Instant time) {
    if (m_askedInVain[request] == kNotYet) m_askedInVain[request] = time;
  }

  // Whether it was asked for something and the last answer does not say it: an SDO abort, or a wrong length.
  bool hasRefused(Request request) const { return m_refused.has(request); }

  // Whether it is known how often it sends anything by itself. How often a node does is heard.
  bool hasPeriod() const;
  bool hasPeriod(MessageId id) const { return kind != Kind::Node || periodOf(id) > 0ns; }
  // So long after lastStatus it is silent.
  Duration silentAfter() const;

  // Whether one of kPeriodicReports came and is older than three of its periods.
  bool isStale(MessageId id) const { return m_stale.has(id); }
  const EnumSet<MessageId>& stale() const { return m_stale; }
  // What its times err by.
  Duration slack() const { return isCoarse ? kSecondGrain : Duration{0}; }
  // So long after its last one a periodic report is stale.
  Duration staleAfter(MessageId id) const;
  // When one of kPeriodicReports is stale unless another one comes; kNever: it is stale, or nothing can be heard.
  Instant staleDue(MessageId id) const;
  Instant nextDeadline() const;
  // Marks what is due at `time` stale.
  void timeCame(Instant time);
  // Takes what a decoded frame of this device says. `id` is a message that the device sends or receives.
  void take(const Frame& frame, MessageId id, Instant time);

  // Takes a message of a wrong length that this device sent, or a node's master sent to it.
  void takeMalformed(const Frame& frame, MessageId id, Instant time);
  // Whether one of kOwnPeriodicReports comes in a wrong length now.
  bool isMalformedNow(MessageId id, Instant now) const;

  friend bool operator==(const Device&, const Device&) = default;

 private:
  bool isBeforeGap(Instant at) const { return at < m_gapEnd; }
  void forgetUntil(Instant end);
  void answered(Request request) {
    m_askedInVain[request] = kNotYet;
    m_refused.remove(request);
  }
  // What was not asked cannot be refused.
  void refused(Request request) {
    if (m_askedInVain[request] != kNotYet) m_refused.add(request);
    m_askedInVain[request] = kNotYet;
  }
  // What was heard of it; 0: nothing yet, or of no node.
  Duration periodOf(MessageId id) const;
  void statusCame(Instant time);
  void takeStatus(const Frame& frame, MessageId id, Instant time);
  void takeDoubling(Doubling doubling, Instant time);
  void takeSdo(const Frame& frame, Instant time);

  Instant m_gapEnd = kNotYet;  // when the link of its channel last came back
  std::array<Report, kReports.size()> m_reports;
  std::array<Pace, kOwnPeriodicReports.size()> m_paces;
  std::array<OwnPeriod, kNodeReports.size()> m_periods;
  EnumArray<Request, Instant> m_askedInVain = [] {
    EnumArray<Request, Instant> never;
    for (Instant& time : never) time = kNotYet;
    return never;
  }();
  EnumSet<Request> m_refused;
  EnumSet<MessageId> m_stale;
  EnumSet<MessageId> m_malformed;       // reports that came in a wrong length last
  Instant m_malformedStatus = kNotYet;  // when the last of them came
};

}  // namespace deckpipe
