// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/trace_filter.h"

#include <algorithm>
#include <cmath>

#include "bus/canopen.h"
#include "bus/j1939.h"
#include "model/field_text.h"
#include "model/filter_parser.h"
#include "model/message_text.h"
#include "model/trace_cells.h"
#include "protocol/decode.h"

namespace deckpipe {
namespace {

constexpr unsigned kMemoryBits = 17;  // so many frames, as a power of two, contains(text) remembers

// What a numeric key is of a frame; nothing where the frame has none.
std::optional<std::uint64_t> numberOf(const FilterNode& node, const FilterFrame& at) {
  const Frame& frame = at.frame;
  const bool isJ1939 = frame.isExtended() && !frame.isError();
  const auto byte = [&frame](unsigned n) -> std::optional<std::uint64_t> {
    if (frame.bytes().size() < n) return {};
    return frame.data[n - 1];
  };
  switch (node.key) {
    case FilterKey::Id:
      return frame.isError() ? std::nullopt
                             : std::optional<std::uint64_t>(frame.id & (kExtendedBit | kIdMask));
    case FilterKey::Pgn:
      return isJ1939 ? std::optional<std::uint64_t>(J1939Id::of(frame.identifier()).pgn) : std::nullopt;
    case FilterKey::Source: return isJ1939 ? std::optional<std::uint64_t>(frame.id & 0xFF) : std::nullopt;
    case FilterKey::Destination: {
      if (!isJ1939) return {};
      const J1939Id id = J1939Id::of(frame.identifier());
      return id.hasDestination() ? std::optional<std::uint64_t>(id.destination.value) : std::nullopt;
    }
    case FilterKey::Priority:
      return isJ1939 ? std::optional<std::uint64_t>(frame.identifier() >> 26 & 7) : std::nullopt;
    case FilterKey::Node: {
      if (frame.isExtended() || frame.isError()) return {};
      const CobId cob = CobId::of(frame.identifier());
      return cob.hasNode() ? std::optional<std::uint64_t>(cob.node.value) : std::nullopt;
    }
    case FilterKey::Type:
      return isJ1939 && J1939Id::of(frame.identifier()).pgn == pgn::kProprietaryA ? byte(1) : std::nullopt;
    case FilterKey::Byte: return byte(node.byte);
    case FilterKey::Length: return frame.length;
    case FilterKey::FrameNumber: return at.index + 1;
    case FilterKey::Direction: return (frame.flags & Frame::kSent) != 0 ? 1u : 0u;
    default: return {};
  }
}

template <typename T>
bool compare(FilterOp op, T value, T with) {
  switch (op) {
    case FilterOp::Equal: return !(value < with) && !(with < value);
    case FilterOp::Less: return value < with;
    case FilterOp::LessEqual: return !(with < value);
    case FilterOp::Greater: return with < value;
    case FilterOp::GreaterEqual: return !(value < with);
    case FilterOp::Contains: return false;
  }
  return false;
}

bool matchesNumber(const FilterNode& node, std::uint64_t value) {
  if (node.op == FilterOp::Equal || node.op == FilterOp::Contains)
    return std::any_of(node.numbers.begin(), node.numbers.end(),
                       [value](const FilterNumber& number) { return number.has(value); });
  const FilterNumber& with = node.numbers.front();
  // 18EFFF80 is not above 7FF: the two kinds of identifiers do not compare.
  if (node.key == FilterKey::Id && ((value ^ with.low) & kExtendedBit) != 0) return false;
  const bool isUpper = node.op == FilterOp::LessEqual || node.op == FilterOp::Greater;
  return compare(node.op, value, isUpper ? with.high : with.low);
}

bool startsAt(const FilterBytes& pattern, std::span<const std::uint8_t> bytes, std::size_t at) {
  for (std::size_t i = 0; i < pattern.length; ++i) {
    if ((bytes[at + i] & pattern.mask[i]) != pattern.bytes[i]) return false;
  }
  return true;
}

bool matchesBytes(const FilterNode& node, std::span<const std::uint8_t> bytes) {
  return std::any_of(node.patterns.begin(), node.patterns.end(), [&](const FilterBytes& pattern) {
    if (pattern.length > bytes.size()) return false;
    if (node.op == FilterOp::Equal) return pattern.length == bytes.size() && startsAt(pattern, bytes, 0);
    for (std::size_t at = 0; at + pattern.length <= bytes.size(); ++at) {
      if (startsAt(pattern, bytes, at)) return true;
    }
    return false;
  });
}

bool matchesTitle(const FilterTitles& titles, const FilterFrame& at) {
  if (at.frame.isError()) return titles.error;
  if (at.frame.isRemote()) return titles.remote;
  if (at.what.message != MessageId::Count) {
    return (at.what.malformed ? titles.malformed : titles.messages).has(at.what.message);
  }
  if (const j1939::StandardGroup* group = standardGroup(at.frame, at.what); group != nullptr)
    return std::ranges::find(titles.groups, group) != titles.groups.end();
  return titles.families.has(at.what.family);
}

std::optional<double> realOf(const Value& value) {
  switch (value.type()) {
    case Value::Type::Integer: return static_cast<double>(value.number());
    case Value::Type::Decimal:
      return static_cast<double>(value.number()) / std::pow(10.0, static_cast<double>(value.decimals()));
    case Value::Type::Real: return value.real();
    case Value::Type::Flag: return value.flag() ? 1.0 : 0.0;
    default: return {};
  }
}

bool matchesValue(const FilterNode& node, const Value& value) {
  if (value.isNull()) return node.wantsNone;
  if (const auto real = realOf(value); real && node.op != FilterOp::Contains) {
    const bool fits = std::any_of(node.values.begin(), node.values.end(),
                                  [&](double with) { return compare(node.op, *real, with); });
    if (fits) return true;
  }
  if (node.words.isEmpty() || (node.op != FilterOp::Equal && node.op != FilterOp::Contains)) return false;
  const QString text = value.type() == Value::Type::Flag
                           ? (value.flag() ? QStringLiteral("on") : QStringLiteral("off"))
                           : toQString(toText(value));
  const QStringList parts = text.split(QStringLiteral(", "));  // the names of faults that are set
  return std::any_of(node.words.begin(), node.words.end(), [&](const QString& word) {
    if (node.op == FilterOp::Contains) return text.contains(word, Qt::CaseInsensitive);
    return text.compare(word, Qt::CaseInsensitive) == 0 || parts.contains(word, Qt::CaseInsensitive);
  });
}

bool matchesField(const FilterNode& node, const FilterFrame& at) {
  if (!at.what.isDecoded() || !node.messages.has(at.what.message)) return false;
  for (const Field& field : messageOf(at.what.message).fields) {
    if (field.key != node.field || field.kind == Kind::Reserved || !isPresent(field, at.frame)) continue;
    return matchesValue(node, valueOf(field, at.frame));
  }
  return false;
}

bool textMatches(const FilterNode& node, const FilterFrame& at) {
  const QString& wanted = node.words.front();
  const auto in = [&wanted](const QString& cell) { return cell.contains(wanted, Qt::CaseInsensitive); };
  return in(identifierText(at.frame)) || in(bytesText(at.frame)) || in(pgnText(at.frame)) ||
         in(endsText(at.frame)) || in(frameTitle(at.frame, at.what)) || in(summaryText(at.frame, at.what));
}

bool matchesText(const FilterNode& node, const FilterFrame& at) {
  if (node.channels[at.frame.channel]) return true;
  if (node.mayBeStamp && stampText(at.frame).contains(node.words.front(), Qt::CaseInsensitive)) return true;
  auto& entries = node.memory.entries;
  if (entries.empty()) entries.resize(std::size_t{1} << kMemoryBits);
  Frame key = at.frame;
  key.stamp = 0;
  key.channel = key.flags = 0;
  const std::uint64_t mixed = (loadLittle(key.data) ^ key.id) * 0x9E37'79B9'7F4A'7C15;
  FilterMemory::Entry& entry = entries[mixed >> (64 - kMemoryBits)];
  if (!entry.isKnown || entry.frame != key || entry.what != at.what)
    entry = {key, at.what, true, textMatches(node, at)};
  return entry.isMatch;
}

bool matchesKey(const FilterNode& node, const FilterFrame& at) {
  switch (node.key) {
    case FilterKey::Data: return matchesBytes(node, at.frame.bytes());
    case FilterKey::Seconds: {
      const auto since = static_cast<double>((at.time - node.begin).count());
      return std::any_of(node.values.begin(), node.values.end(),
                         [&](double with) { return compare(node.op, since, with); });
    }
    case FilterKey::ChannelName: return node.channels[at.frame.channel];
    case FilterKey::Name: return matchesTitle(node.titles, at);
    case FilterKey::Family: return node.titles.families.has(at.what.family);
    case FilterKey::Error: return at.frame.isError();
    case FilterKey::Remote: return at.frame.isRemote();
    case FilterKey::Malformed: return at.what.malformed;
    case FilterKey::Presumed: return at.what.family == Family::Presumed;
    case FilterKey::Ambiguous: return at.what.family == Family::Ambiguous;
    case FilterKey::Decoded: return at.what.isDecoded();
    case FilterKey::TimeJump: return (at.frame.flags & Frame::kTimeJump) != 0;
    default: {
      const auto value = numberOf(node, at);
      return value && matchesNumber(node, *value);
    }
  }
}

}  // namespace

Result<TraceFilter, FilterError> TraceFilter::parse(const QString& expression) {
  auto filter = FilterParser(expression).parse();
  if (filter) filter.value().m_text = expression.trimmed();
  return filter;
}

FilterNode FilterNode::containing(const QString& text) {
  FilterNode node;
  node.kind = Kind::Text;
  node.op = FilterOp::Contains;
  node.words += text;
  // Making times of ten million frames into words takes longer than all else.
  node.mayBeStamp =
      std::none_of(text.begin(), text.end(), [](QChar c) { return c.isLetter() || c.isSpace(); });
  return node;
}

TraceFilter TraceFilter::containing(const QString& text) {
  TraceFilter filter;
  if (text.isEmpty()) return filter;
  filter.m_text = text;
  filter.m_nodes.push_back(FilterNode::containing(text));
  filter.m_needsRoles = true;
  return filter;
}

void TraceFilter::bind(const FrameStore& frames) {
  for (FilterNode& node : m_nodes) {
    node.begin = frames.count() == 0 ? Instant{} : frames.timeAt(0);
    const bool isChannel = node.kind == FilterNode::Kind::Text || node.key == FilterKey::ChannelName;
    if (!isChannel || node.kind == FilterNode::Kind::Field) continue;
    for (std::size_t i = 0; i < frames.channelCount(); ++i) {
      const QString name = toQString(frames.channelName(static_cast<std::uint8_t>(i)));
      node.channels[i] = std::any_of(node.words.begin(), node.words.end(), [&](const QString& word) {
        return node.op == FilterOp::Contains ? name.contains(word, Qt::CaseInsensitive)
                                             : name.compare(word, Qt::CaseInsensitive) == 0;
      });
    }
  }
}

bool TraceFilter::matches(const FilterFrame& frame) const {
  return m_nodes.empty() || matches(static_cast<int>(m_nodes.size()) - 1, frame);
}

bool TraceFilter::matches(int at, const FilterFrame& frame) const {
  const FilterNode& node = m_nodes[static_cast<std::size_t>(at)];
  switch (node.kind) {
    case FilterNode::Kind::And: return matches(node.left, frame) && matches(node.right, frame);
    case FilterNode::Kind::Or: return matches(node.left, frame) || matches(node.right, frame);
    case FilterNode::Kind::Not: return !matches(node.left, frame);
    case FilterNode::Kind::Key: return matchesKey(node, frame);
    case FilterNode::Kind::Field: return matchesField(node, frame);
    case FilterNode::Kind::Text: return matchesText(node, frame);
  }
  return false;
}

}  // namespace deckpipe
