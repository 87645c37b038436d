// SPDX-License-Identifier: GPL-3.0-or-later
// What the window draws at one tick: the view of the log, how it is played, and how its source is doing.
#pragma once

#include <QString>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "control/status.h"
#include "link/can_link.h"
#include "log/journal_writer.h"
#include "log/reading.h"
#include "state/log_view.h"

namespace deckpipe {

// Neither memory nor disk has room for more frames of the link.
struct StoreFull {
  friend bool operator==(const StoreFull&, const StoreFull&) = default;
};
// What went wrong with a source. The window translates it (app/console/status_text.h).
using SourceError = std::variant<std::monostate, ReadError, LinkError, StoreFull>;

// Marks that a person made in the log of a file are in memory alone. The window says why.
struct UnkeptMarks {
  enum class Why : std::uint8_t {
    LogIsBeingRead,
    LogIsCut,         // it could not be read to its end
    IsARecording,     // one that is opened is not added to
    SidecarUnusable,  // and is not replaced
    SidecarNewer,     // the same of one of a newer version
    SidecarChanged,   // the same of one that was changed meanwhile
    NoAnswer,         // the disk gives none
    CannotWrite,
  };
  Why why = Why::CannotWrite;
  QString detail{};  // the system's words; of CannotWrite only
  friend bool operator==(const UnkeptMarks&, const UnkeptMarks&) = default;
};

// A log that was to be opened and cannot be read, while what was open stays so.
struct NotOpened {
  QString path;
  std::optional<ReadError> error;  // nothing: it holds no frame
  bool isInView = false;           // it is the recording of the link that is open, and goes on
  friend bool operator==(const NotOpened&, const NotOpened&) = default;
};

// Where the frames come from and how that goes: for the status strip alone, never for a view of the log.
struct SourceStatus {
  enum class Kind : std::uint8_t { Nothing, File, Link };
  enum class Progress : std::uint8_t {
    Idle,
    Opening,  // a link is connecting; a file is being read
    Running,  // a link is up
    Done,     // a file was read
    Lost,     // a link went away
    Failed,   // could not be opened, or not be read to its end
  };
  Kind kind = Kind::Nothing;
  Progress progress = Progress::Idle;
  QString name;                  // file path, or plugin and interface; empty for the simulator
  SourceError error;             // the last thing that went wrong
  double fraction = 0;           // of a file being read, 0..1
  std::uint64_t unreadable = 0;  // lines of a file
  ReadSummary read{};            // of a file, once it was read
  bool addsUpTimes = false;      // of a file: its times are differences, and were added up
  int bitRate = 0;               // bit/s that it runs at, or that was asked for; 0 = not applicable
  QString plugin;                // of a link
  QString interfaceName;
  bool isListenOnly = false;  // the driver says so
  ControllerState controller = ControllerState::Unknown;
  bool simulated = false;  // behind it is the simulator
  // Marks that a person made in a file are being written beside it.
  bool isKeepingMarks = false;
  std::optional<UnkeptMarks> unkeptMarks{};
  // Of a link: how it is written down. A recording without a path has no frame yet, or could not be begun.
  std::optional<JournalStatus> recording{};

  // Whether a file grows with what is received.
  bool isRecorded() const {
    return recording && !recording->path.empty() && !recording->fault && !recording->isEnded;
  }

  friend bool operator==(const SourceStatus&, const SourceStatus&) = default;
};

// Frames that the adapter of a link had and the bus had not, when the link was left. They may still go out, and no link
// tells whether they did.
struct LeftWaiting {
  QString interfaceName;
  std::uint64_t frames = 0;
  std::vector<WaitingCommand> commands;  // among them
  friend bool operator==(const LeftWaiting&, const LeftWaiting&) = default;
};

struct Snapshot {
  LogView view;
  bool playing = false;
  double speed = 1;  // times real time; Playback::kUnbounded: as fast as the state is found
  bool isLooping = false;
  bool skipsSilences = false;
  Duration skipped{0};  // log time without frames that playing has just skipped
  // The state of the view stands still at another place than its cursor: it is being found.
  bool isCatchingUp = false;
  SourceStatus source;
  // Of the live link, whatever the cursor shows; locked and empty without one. Never null.
  std::shared_ptr<const ServiceStatus> services = std::make_shared<const ServiceStatus>();
  // Why the last intent was not handed to the link at all; None again with the next one, or once the cursor is
  // moved by hand.
  Refusal notSent = Refusal::None;
  // The same of a log that cannot be read, and of the recording of a link that was left.
  std::optional<NotOpened> notOpened{};
  std::optional<JournalStatus> leftRecording{};
  // The same of a file of the recording that was removed or changed, so that the recording goes on in another.
  std::optional<JournalFault> givenUpFile{};
  // Until the interface is seen down, which takes them back, or another link is left so.
  std::optional<LeftWaiting> leftWaiting{};
};

}  // namespace deckpipe
