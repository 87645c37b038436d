// SPDX-License-Identifier: GPL-3.0-or-later
#include "log_input.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cinttypes>
#include <cstdio>
#include <cstring>
#include <optional>
#include <thread>

#include "command.h"
#include "log/log_stream.h"

namespace deckpipe::ctl {
namespace {

int sayError(const std::string& name, const ReadError& error) {
  std::string text = name + ": ";
  if (!error.format.empty()) text += error.format + ": ";
  text += readErrorText(error.kind);
  if (!error.detail.empty()) text += ": " + error.detail;
  if (error.kind == ReadError::Kind::UnknownFormat) text += ": " + formatNames(LogUse::Read);
  std::fprintf(stderr, "deckpipectl: %s\n", text.c_str());
  return error.kind == ReadError::Kind::CannotOpen ? kBadUsage : kNotWhole;
}

}  // namespace

QString logArgumentHelp() {
  return QStringLiteral("Log to read (%1); - is standard input (%2).")
      .arg(QString::fromStdString(formatNames(LogUse::Read)),
           QString::fromStdString(formatNames(LogUse::ReadFromPipe)));
}

int LogInput::read(const std::function<bool()>& more) {
  if (path == "-") return readStream(STDIN_FILENO, more);
  struct stat facts {};
  if (::stat(path.c_str(), &facts) != 0 || S_ISREG(facts.st_mode) || S_ISDIR(facts.st_mode))
    return readFile(more);
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return sayError(path, {ReadError::Kind::CannotOpen, std::strerror(errno)});
  const int status = readStream(descriptor, more);
  ::close(descriptor);
  return status;
}

int LogInput::readFile(const std::function<bool()>& more) {
  std::atomic<unsigned> published = 0;  // grows whenever there is something new, the end included
  std::atomic<bool> wanted = true;
  std::atomic<bool> ended = false;
  std::optional<Result<ReadSummary, ReadError>> outcome;
  const auto publish = [&] {
    published.fetch_add(1);
    published.notify_one();
  };
  std::thread reader([&] {
    ReadOptions options;
    options.threads = 2;
    options.onProgress = [&](const ReadProgress&) {
      publish();
      return wanted.load();
    };
    outcome.emplace(openLog(path, {frames, unkept, &notes}, options));
    ended = true;
    publish();
  });
  for (unsigned seen = 0; !ended;) {
    published.wait(seen);
    seen = published;
    if (wanted && !more()) wanted = false;
  }
  reader.join();
  if (wanted) more();
  const int unkeptStatus = sayUnkept();
  if (!*outcome) return sayError(name(), outcome->error());
  return std::max(unkeptStatus, sayMissing(outcome->value()));
}

int LogInput::readStream(int descriptor, const std::function<bool()>& more) {
  LogStream stream(frames, unkept);
  std::array<char, 64 * 1024> buffer;
  int status = kDone;
  for (;;) {
    const ssize_t got = ::read(descriptor, buffer.data(), buffer.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) {
      std::fprintf(stderr, "deckpipectl: %s: %s\n", name().c_str(), std::strerror(errno));
      status = kNotWhole;
    }
    if (got <= 0) break;
    if (!stream.feed({buffer.data(), static_cast<std::size_t>(got)}) || !more()) break;
  }
  const auto outcome = stream.finish();
  more();
  const int unkeptStatus = sayUnkept();
  if (!outcome) return sayError(name(), outcome.error());
  return std::max(status, unkeptStatus);
}

int LogInput::sayMissing(const ReadSummary& summary) const {
  if (summary.cutBytes > 0)
    std::fprintf(stderr, "%s: the last %" PRIu64 " bytes are not whole and were left out\n", name().c_str(),
                 summary.cutBytes);
  if (summary.newerParts > 0)
    std::fprintf(stderr, "%s: %" PRIu64 " parts of a newer version of Deckpipe were left out\n",
                 name().c_str(), summary.newerParts);
  if (summary.isOpenEnded)
    std::fprintf(stderr, "%s: the recording was not ended: it still goes on, or its last second was lost\n",
                 name().c_str());
  return summary.cutBytes == 0 && summary.newerParts == 0 ? kDone : kNotWhole;
}

int LogInput::sayUnkept() const {
  const UnkeptPlaces content = unkept.content();
  EnumArray<Unkept, std::uint64_t> said;
  for (const UnkeptPlace& place : content.places()) {
    if (!isUnreadable(place.reason)) continue;
    const std::string_view reason = unkeptText(place.reason);
    std::fprintf(stderr, "%s:%" PRIu64 ": %.*s\n", name().c_str(), place.place,
                 static_cast<int>(reason.size()), reason.data());
    ++said[place.reason];
  }
  for (const Unkept reason : kAllOf<Unkept>) {
    const std::uint64_t rest = content.count(reason) - said[reason];
    if (rest == 0) continue;
    const std::string_view text = unkeptText(reason);
    std::fprintf(
        stderr,
        isUnreadable(reason) ? "%s: %" PRIu64 " more lines: %.*s\n" : "%s: %" PRIu64 " not kept: %.*s\n",
        name().c_str(), rest, static_cast<int>(text.size()), text.data());
  }
  return content.unreadable() == 0 ? kDone : kNotWhole;
}

}  // namespace deckpipe::ctl
