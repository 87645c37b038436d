// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/pipe_transcript.h"

#include <QCoreApplication>
#include <utility>

#include "model/device_rows.h"
#include "model/field_text.h"
#include "text/elapsed_text.h"

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

bool PipeTranscript::take(const LogView& view, const DeviceKey& device) {
  const auto exchanges = view.document != nullptr ? view.document->exchanges.list() : nullptr;
  const Device* known = view.state != nullptr ? findDevice(*view.state, device) : nullptr;
  const Instant restarted = known != nullptr ? known->restarted : kNotYet;
  const bool isAnew = exchanges != m_exchanges || device != m_device || view.cursor.frames < m_cursor ||
                      restarted != m_restarted;
  if (isAnew) {
    *this = {};
    m_exchanges = exchanges;
    m_device = device;
    m_restarted = restarted;
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
  Address last;
  bool isLineOpen = false;
  bool tellsRestart = restarted() != kNotYet;
  const auto restart = [&] {
    if (std::exchange(isLineOpen, false)) text += QLatin1Char('\n');
    text += elapsedText(restarted() - m_begin) + QStringLiteral("  ") + pipeRestartText() + QLatin1Char('\n');
    tellsRestart = false;
  };
  for (const PipePacket& packet : m_packets) {
    if (tellsRestart && packet.time > restarted()) restart();
    if (isLineOpen && packet.sender != last) {
      text += QLatin1Char('\n');
      isLineOpen = false;
    }
    last = packet.sender;
    for (const QChar c : pipeText(packet.bytes)) {
      if (!isLineOpen) {
        text += elapsedText(packet.time - m_begin) +
                (packet.isFromDevice ? QStringLiteral("  < ")
                 : packet.isOurs     ? QStringLiteral("  > ")
                                     : QStringLiteral("  %1> ").arg(hexText(packet.sender.value, 2)));
        isLineOpen = true;
      }
      text += c;
      if (c == QLatin1Char('\n')) isLineOpen = false;
    }
  }
  if (isLineOpen) text += QLatin1Char('\n');
  isLineOpen = false;
  if (tellsRestart) restart();
  return text;
}

QString PipeTranscript::ledger() const {
  QString text = QStringLiteral("time_s,direction,bytes,ack_ms\n");
  for (const PipePacket& packet : m_packets) {
    const auto milliseconds = [](Duration d) {
      return QString::number(static_cast<double>(d.count()) / 1e6, 'f', 1);
    };
    text += QString::number(static_cast<double>((packet.time - m_begin).count()) / 1e9, 'f', 6) +
            (packet.isFromDevice ? QStringLiteral(",in,") : QStringLiteral(",out,")) +
            QString::number(packet.bytes.size()) + QLatin1Char(',') +
            (packet.acknowledged ? milliseconds(*packet.acknowledged - packet.time) : QString()) +
            QLatin1Char('\n');
  }
  return text;
}

}  // namespace deckpipe
