// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/candump.h"
#include "log/candump_appender.h"
#include "log/candump_parser.h"

namespace deckpipe {

struct CandumpStream::State {
  State(FrameStore& store, UnkeptList& list) : unkept(list), appender(store, held) {}

  UnkeptList& unkept;
  UnkeptList held;  // reports until it is clear that this is a log
  CandumpAppender appender;
  CandumpParser parser;
  CandumpBlock block;
  ChannelMap channels;

  enum class Verdict : std::uint8_t { Open, Log, NoLog } verdict = Verdict::Open;
  bool full = false;
  std::string pending;         // from the start of a line on
  std::uint64_t consumed = 0;  // where in the text that is
  bool skipping = false;       // pending is what is left of a line that was too long

  bool wantsMore() const { return verdict != Verdict::NoLog && !full; }

  void drop(std::size_t n) {
    pending.erase(0, n);
    consumed += n;
  }

  // The lines in the first n bytes of pending.
  void take(std::size_t n) {
    const char* begin = pending.data();
    parser.parse(begin, begin + n, begin + n, block);
    full = !appender.append(block, channels);
    if (block.count > 0 || block.unkept.understood() > 0) decide(Verdict::Log);
    drop(n);
  }

  void decide(Verdict v) {
    if (verdict != Verdict::Open) return;
    verdict = v;
    if (v != Verdict::Log) return;
    unkept.add(held.content(), 0);
    appender.reportTo(unkept);
  }

  // All that the rule in candump.h looks at has been seen.
  void decideByWhatWasSeen() { decide(held.content().unreadable() == 0 ? Verdict::Log : Verdict::NoLog); }

  // While it is open whether this is a log, line by line; then all at once.
  void takeWholeLines() {
    while (wantsMore()) {
      if (verdict == Verdict::Open && consumed >= kCandumpSniff) {
        decideByWhatWasSeen();
        continue;
      }
      const std::size_t feed =
          verdict == Verdict::Open || skipping ? pending.find('\n') : pending.rfind('\n');
      if (feed == std::string::npos) break;
      if (skipping) {
        drop(feed + 1);
        skipping = false;
      } else {
        take(feed + 1);
      }
    }
  }
};

CandumpStream::CandumpStream(FrameStore& store, UnkeptList& unkept)
    : m_state(std::make_unique<State>(store, unkept)) {}
CandumpStream::~CandumpStream() = default;

bool CandumpStream::feed(std::span<const char> bytes) {
  State& s = *m_state;
  if (!s.wantsMore()) return false;
  s.pending.append(bytes.data(), bytes.size());
  s.takeWholeLines();
  if (s.wantsMore() && (s.skipping || s.pending.size() > kMaxCandumpLine)) {
    if (!s.skipping) s.appender.appendTooLong();
    s.skipping = true;
    s.drop(s.pending.size());
  }
  return s.wantsMore();
}

Result<ReadSummary, ReadError> CandumpStream::finish() {
  State& s = *m_state;
  if (s.wantsMore() && !s.pending.empty() && !s.skipping) s.take(s.pending.size());
  if (!s.appender.finish()) s.full = true;
  s.decideByWhatWasSeen();
  if (s.verdict == State::Verdict::NoLog) {
    return Failure{ReadError{ReadError::Kind::NotThisFormat, std::string(kNotCandump)}};
  }
  if (s.full) return Failure{ReadError{ReadError::Kind::StoreFull, {}}};
  return ReadSummary{s.appender.frames(), s.appender.lines(), false};
}

}  // namespace deckpipe
