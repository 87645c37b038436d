// SPDX-License-Identifier: GPL-3.0-or-later
#include "link/convert.h"

#include <algorithm>

namespace deckpipe {

Result<Frame, NotKept> fromCanBusFrame(const QCanBusFrame& frame, Channel channel) {
  const QByteArray payload = frame.payload();
  if (frame.hasFlexibleDataRateFormat()) return Failure{NotKept::FlexibleDataRate};
  if (payload.size() > 8) return Failure{NotKept::Invalid};

  Frame out;
  switch (frame.frameType()) {
    case QCanBusFrame::DataFrame:
    case QCanBusFrame::RemoteRequestFrame:
      if (!frame.isValid()) return Failure{NotKept::Invalid};
      out.id = frame.frameId() | (frame.hasExtendedFrameFormat() ? kExtendedBit : 0u);
      if (frame.frameType() == QCanBusFrame::RemoteRequestFrame) out.id |= kRemoteBit;
      break;
    case QCanBusFrame::ErrorFrame:
      // frameId() is 0 for these; the error class stands where the identifier would.
      out.id = kErrorBit | (static_cast<std::uint32_t>(frame.error().toInt()) & kIdMask);
      break;
    case QCanBusFrame::UnknownFrame:
    case QCanBusFrame::InvalidFrame: return Failure{NotKept::Invalid};
  }
  out.channel = channel.value;
  out.length = static_cast<std::uint8_t>(payload.size());
  if (!out.isRemote()) std::copy(payload.cbegin(), payload.cend(), out.data.begin());
  const QCanBusFrame::TimeStamp stamp = frame.timeStamp();
  if (stamp.seconds() != 0 || stamp.microSeconds() != 0) {
    out.stamp = stamp.seconds() * 1'000'000'000 + stamp.microSeconds() * 1'000;
  }
  return out;
}

QCanBusFrame toCanBusFrame(const Frame& frame) {
  QCanBusFrame out(QCanBusFrame::DataFrame);
  if (frame.isError()) {
    out.setFrameType(QCanBusFrame::ErrorFrame);
    out.setError(QCanBusFrame::FrameErrors::fromInt(static_cast<int>(frame.identifier())));
  } else {
    if (frame.isRemote()) out.setFrameType(QCanBusFrame::RemoteRequestFrame);
    out.setFrameId(frame.identifier());
    out.setExtendedFrameFormat(frame.isExtended());
  }
  const qsizetype length = std::min<qsizetype>(frame.length, 8);
  QByteArray payload(length, '\0');
  if (!frame.isRemote()) std::copy_n(frame.data.begin(), length, payload.begin());
  out.setPayload(payload);
  if (frame.hasStamp()) {
    out.setTimeStamp(QCanBusFrame::TimeStamp::fromMicroSeconds(frame.stamp / 1'000));
  }
  return out;
}

}  // namespace deckpipe
