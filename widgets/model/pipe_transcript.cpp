// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/pipe_transcript.h"

#include <QCoreApplication>
#include <algorithm>
#include <iterator>
#include <utility>

#include "log/time_grain.h"
#include "model/device_rows.h"
#include "model/field_text.h"
#include "text/time_text.h"

namespace deckpipe {
namespace {

struct PipeTranscriptText {
  Q_DECLARE_TR_FUNCTIONS(PipeTranscript)
};

bool isPrintable(char c) { return c >= 0x20 && c <= 0x7E; }

}  // namespace

QString pipeText(std::string_view bytes) {
  QString text;
  for (const char c : bytes) {
    if (isPrintable(c) || c == '\n') {
      text += QLatin1Char(c);
    } else if (c != '\r') {
      text += QStringLiteral("⟨%1⟩").arg(hexText(static_cast<unsigned char>(c), 2));
    }
  }
  return text;
}

QString pipeHex(std::string_view bytes) {
  QStringList hex;
  for (const char c : bytes) hex.append(hexText(static_cast<unsigned char>(c), 2));
  return hex.join(QLatin1Char(' '));
}

QString pipeRestartText() { return PipeTranscriptText::tr("— the device restarted —"); }

bool PipeTranscript::isOfDevice(Channel channel, Address address, const Pin& pin) const {
  if (channel != m_device.channel) return false;
  return m_device.kind == DeviceKey::Kind::Pin ? pin == m_device.pin
                                               : pin.isNull() && address == m_device.address;
}

// A device that claims an address and then announces itself restarts once.
void PipeTranscript::addRestart(Instant time) {
  const auto after = std::ranges::lower_bound(m_restarts, time - kOneStart);
  if (after == m_restarts.end() || *after > time + kOneStart) m_restarts.insert(after, time);
}

// The log's events tell all of them, a moment later. The state knows the last one at once.
void PipeTranscript::findRestarts(const LogView& view) {
  for (const Event& event : view.document->events.after(m_eventsSeen)) {
    ++m_eventsSeen;
    if (event.kind == EventKind::Restarted && isOfDevice(event.channel, event.address, event.pin))
      addRestart(event.time);
  }
  const Device* known = view.state != nullptr ? findDevice(*view.state, m_device) : nullptr;
  if (known != nullptr && known->restarted != kNotYet) addRestart(known->restarted);
}

std::span<const Instant> PipeTranscript::restarts() const {
  const auto all = std::span(m_restarts).first(m_restartsShown);
  if (m_packets.empty()) return {};
  const auto first = std::ranges::upper_bound(all, m_packets.front().time);
  return all.subspan(static_cast<std::size_t>(first - all.begin()));
}

Instant PipeTranscript::restartedSinceSent() const {
  return restarts().empty() || m_lastSent >= restarts().back() ? kNotYet : restarts().back();
}

bool PipeTranscript::take(const LogView& view, const DeviceKey& device) {
  const auto exchanges = view.document != nullptr ? view.document->exchanges.list() : nullptr;
  const unsigned generation = view.document != nullptr ? view.document->events.generation() : 0;
  bool isAnew = exchanges != m_exchanges || device != m_device || view.cursor.frames < m_cursor ||
                generation != m_generation;
  if (isAnew) {
    *this = {};
    m_exchanges = exchanges;
    m_device = device;
    m_generation = generation;
  }
  m_document = view.document;
  if (m_document != nullptr) {
    const std::vector<Instant> shown(m_restarts.begin(),
                                     m_restarts.begin() + static_cast<std::ptrdiff_t>(m_restartsShown));
    findRestarts(view);
    m_restartsShown =
        static_cast<std::size_t>(std::ranges::upper_bound(m_restarts, view.cursor.time) - m_restarts.begin());
    // One that was found late stands before packets that were shown already.
    const bool goesOn = m_restartsShown >= shown.size() &&
                        std::ranges::equal(shown, std::span(m_restarts).first(shown.size()));
    const bool isLate = m_restartsShown > shown.size() && !m_packets.empty() &&
                        m_restarts[shown.size()] < m_packets.back().time;
    isAnew = isAnew || !goesOn || isLate;
  }
  m_cursor = view.cursor.frames;
  m_begin = view.begin;
  if (m_exchanges == nullptr) return isAnew;
  for (; m_taken < m_exchanges->size() && (*m_exchanges)[m_taken].frame < m_cursor; ++m_taken) {
    const Exchange& exchange = (*m_exchanges)[m_taken];
    if (exchange.device != m_device) continue;
    if (exchange.message == MessageId::PipeData) {
      const Frame& frame = view.document->frames[exchange.frame];
      std::string bytes(frame.data.begin() + 1, frame.data.begin() + frame.length);
      m_open[exchange.isFromDevice ? 1 : 0] = m_packets.size();
      if (!exchange.isFromDevice) m_lastSent = exchange.time;
      m_packets.push_back({exchange.frame,
                           exchange.time,
                           exchange.isFromDevice,
                           std::move(bytes),
                           {},
                           J1939Id::of(frame.identifier()).source,
                           (frame.flags & Frame::kSent) != 0});
    } else if (exchange.message == MessageId::PipeAck) {
      // An ack answers the packet of the other direction.
      auto& open = m_open[exchange.isFromDevice ? 0 : 1];
      if (open) m_packets[*open].acknowledged = exchange.time;
      open.reset();
    }
  }
  return isAnew;
}

QString PipeTranscript::text() const {
  QString text;
  const bool hasTimes = m_document == nullptr || m_document->frames.hasTimes();
  const auto when = [&](Instant time) {
    return hasTimes ? elapsedText(time - m_begin) : QString(QChar(0x2013));
  };
  Address last;
  bool isLineOpen = false;
  std::span<const Instant> left = restarts();
  const auto restartsBefore = [&](Instant time) {
    for (; !left.empty() && left.front() < time; left = left.subspan(1)) {
      if (std::exchange(isLineOpen, false)) text += QLatin1Char('\n');
      text += when(left.front()) + QStringLiteral("  ") + pipeRestartText() + QLatin1Char('\n');
    }
  };
  for (const PipePacket& packet : m_packets) {
    restartsBefore(packet.time);
    if (isLineOpen && packet.sender != last) {
      text += QLatin1Char('\n');
      isLineOpen = false;
    }
    last = packet.sender;
    for (const QChar c : pipeText(packet.bytes)) {
      if (!isLineOpen) {
        text += when(packet.time) + (packet.isFromDevice ? QStringLiteral("  < ")
                                     : packet.isOurs
                                         ? QStringLiteral("  > ")
                                         : QStringLiteral("  %1> ").arg(hexText(packet.sender.value, 2)));
        isLineOpen = true;
      }
      text += c;
      if (c == QLatin1Char('\n')) isLineOpen = false;
    }
  }
  if (std::exchange(isLineOpen, false)) text += QLatin1Char('\n');
  restartsBefore(kNever);
  return text;
}

// A note of a resent packet stands before that packet, one of a skipped packet behind it.
std::vector<QStringList> PipeTranscript::repairs() const {
  std::vector<QStringList> repairs(m_packets.size());
  if (m_document == nullptr) return repairs;
  const auto isSent = [](const PipePacket& packet) { return packet.isOurs && !packet.isFromDevice; };
  for (const Note& note : m_document->notes.between(0, m_cursor + 1)) {
    const auto* pipe = std::get_if<note::Pipe>(&note.value);
    if (pipe == nullptr || !isOfDevice(pipe->channel, pipe->address, pipe->pin)) continue;
    const auto after = std::ranges::lower_bound(m_packets, note.frame, {}, &PipePacket::frame);
    if (pipe->event == PipeEvent::Resent) {
      const auto resent = std::find_if(after, m_packets.end(), isSent);
      if (resent != m_packets.end())
        repairs[static_cast<std::size_t>(resent - m_packets.begin())] << QStringLiteral("resent");
    } else if (pipe->event == PipeEvent::Skipped) {
      const auto skipped = std::find_if(std::reverse_iterator(after), m_packets.rend(), isSent);
      if (skipped != m_packets.rend())
        repairs[static_cast<std::size_t>(m_packets.rend() - skipped - 1)] << QStringLiteral("skipped");
    }
  }
  return repairs;
}

QString PipeTranscript::ledger() const {
  QString text = QStringLiteral("time_s,direction,bytes,ack_ms,repair\n");
  const bool hasTimes = m_document == nullptr || m_document->frames.hasTimes();
  const bool isFine = m_document == nullptr || timeGrainOf(m_document->frames) == TimeGrain::Fine;
  const std::vector<QStringList> repaired = repairs();
  for (std::size_t i = 0; i < m_packets.size(); ++i) {
    const PipePacket& packet = m_packets[i];
    const auto milliseconds = [](Duration d) {
      return QString::number(static_cast<double>(d.count()) / 1e6, 'f', 1);
    };
    if (hasTimes) text += QString::number(static_cast<double>((packet.time - m_begin).count()) / 1e9, 'f', 6);
    text += (packet.isFromDevice ? QStringLiteral(",in,") : QStringLiteral(",out,")) +
            QString::number(packet.bytes.size()) + QLatin1Char(',') +
            (packet.acknowledged && isFine ? milliseconds(*packet.acknowledged - packet.time) : QString()) +
            QLatin1Char(',') + repaired[i].join(QLatin1Char(' ')) + QLatin1Char('\n');
  }
  return text;
}

}  // namespace deckpipe
