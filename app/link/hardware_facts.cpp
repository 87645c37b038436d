// SPDX-License-Identifier: GPL-3.0-or-later
#include "link/hardware_facts.h"

#include <algorithm>
#include <utility>

namespace deckpipe {

HardwareFacts::HardwareFacts(std::string name, std::unique_ptr<InterfaceSource> source, QObject* parent)
    : QObject(parent), m_name(std::move(name)), m_source(std::move(source)), m_timer(this) {
  m_timer.setSingleShot(true);
  connect(&m_timer, &QTimer::timeout, this, &HardwareFacts::request);
  connect(m_source.get(), &InterfaceSource::answered, this, &HardwareFacts::answered);
  connect(m_source.get(), &InterfaceSource::changed, this, &HardwareFacts::changed);
  connect(m_source.get(), &InterfaceSource::overrun, this, [this] {
    m_hasMissedNews = true;
    request();
  });
}

// The news first: whatever happens after the answer is told by them.
void HardwareFacts::start() {
  m_isFirst = true;
  m_source->start();
  request();
}

void HardwareFacts::stop() {
  ++m_stops;
  m_source->stop();
  m_timer.stop();
  m_known.reset();
  m_isBound = false;
  m_hasMissedNews = false;
}

void HardwareFacts::setBound(bool isBound) {
  m_isBound = isBound;
  m_overruns = m_known ? m_known->overruns : 0;
}

void HardwareFacts::readSoon() {
  if (m_timer.isActive() && m_timer.remainingTimeAsDuration() > kAfterError) m_timer.start(kAfterError);
}

// The timer rests until the answer is there: a kernel that is slow to answer is not asked twice.
void HardwareFacts::request() {
  m_timer.stop();
  m_isOvertaken = false;
  m_source->request(m_name);
}

void HardwareFacts::answered(const InterfaceReader::Answer& answer) {
  if (m_isOvertaken) return request();
  m_timer.start(kPeriod);
  const bool hasMissedNews = std::exchange(m_hasMissedNews, false);
  if (!answer) {
    // A bound interface that was renamed is still there; removed, it would have been told.
    if (m_isBound && hasMissedNews) return remove();
    if (std::exchange(m_isFirst, false)) Q_EMIT missing(QString::fromStdString(answer.error()));
    return;
  }
  if (m_isBound && m_known && answer.value().index != m_known->index) {
    const int stops = m_stops;
    remove();
    if (m_stops != stops) return;
  }
  learn(answer.value());
}

void HardwareFacts::changed(const CanInterface& facts) {
  const bool isOurs = m_isBound ? m_known && facts.index == m_known->index : facts.name == m_name;
  if (!isOurs) return;
  m_isOvertaken = true;
  if (!facts.isRemoved) return learn(facts);
  if (m_isBound) remove();
}

void HardwareFacts::learn(const CanInterface& facts) {
  m_isFirst = false;
  if (m_isBound) countOverruns(facts);
  m_known = facts;
  Q_EMIT learned(facts);
}

// Of one interface the counter only grows; news that are older than an answer show less.
void HardwareFacts::countOverruns(const CanInterface& facts) {
  const std::uint64_t before = std::exchange(m_overruns, std::max(m_overruns, facts.overruns));
  if (m_overruns != before) Q_EMIT lost(static_cast<std::uint32_t>(m_overruns - before));
}

void HardwareFacts::remove() {
  m_known.reset();
  Q_EMIT removed();
}

}  // namespace deckpipe
