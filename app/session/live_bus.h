// SPDX-License-Identifier: GPL-3.0-or-later
// The bus thread's side of a live connection: it owns the link, the writer end of the store and the live
// State, and publishes snapshots of it. Made by the session, moved to the bus thread, started and stopped by
// queued calls; only latest() and take() are for other threads.
//
// It runs the services too: each event of the link, an intent and their one timer are followed by writing
// what they want sent. They get each frame with its own log time when the State has it, and are asked about
// deadlines only when every frame that has arrived was handed over.
//
// The live State stays kBehind before now, so that a frame that is handled a little late still finds its
// place. A frame that comes later than that is marked late. Log time is what a replay of the log will show.
#pragma once

#include <QObject>
#include <atomic>
#include <memory>
#include <mutex>
#include <optional>

#include "bus/port.h"
#include "link/can_link.h"
#include "service/services.h"
#include "session/arming_lock.h"
#include "state/log_view.h"

class QTimer;

namespace deckpipe {

class LiveBus : public QObject, public PortListener {
  Q_OBJECT
 public:
  static constexpr std::chrono::milliseconds kTick{33};
  static constexpr Duration kBehind = 100ms;

  struct Published {
    std::shared_ptr<const State> state;  // never null
    LinkStatus link;
    std::shared_ptr<const ServiceStatus> services;  // never null
    bool storeFull = false;
  };

  // Holds the last state that was published. It outlives the bus, so that the final state stays readable.
  class Board {
   public:
    Board();
    Published latest() const;

   private:
    friend class LiveBus;
    mutable std::mutex m_lock;
    Published m_published;
  };

  // `before`: the board of the previous bus of this log, whose thread must have ended; null if the log is empty.
  LiveBus(std::shared_ptr<LogDocument> document, LinkSettings settings, ClaimSettings claim = {},
          const std::shared_ptr<const Board>& before = nullptr);
  ~LiveBus() override;

  std::shared_ptr<const Board> board() const { return m_board; }
  Published latest() const { return m_board->latest(); }
  // Returns the latest state and allows the next ticked().
  Published take() {
    m_isTold = false;
    return latest();
  }

 public Q_SLOTS:
  void start();
  // Closes the link and writes down what came until then. To be called before the bus is destroyed, which
  // writes and publishes nothing.
  void stop();
  // Carries the intent out or refuses it at once; a refusal is in the next Published. On a full log only what stops
  // something is carried out.
  void apply(const deckpipe::StampedIntent& intent);
  // Records the person's statement that this address is, or is not, a Copley drive. No frame tells it.
  void sayDrive(deckpipe::Address address, bool isDrive);
  // Ends the services, waits for what they still have to say (Services: 1 s at most), closes the link and
  // quits this thread's event loop.
  void close();

 Q_SIGNALS:
  // A tick has published: draw now. It is not emitted again before take(), so that a slow window finds one tick
  // waiting and not many.
  void ticked();

 private:
  Arrival arrival() const;
  void framesReceived(std::span<const Frame> frames) override;
  void framesNotKept(NotKept reason, std::uint32_t count) override;
  void linkChanged(LinkState state, const std::string& reason) override;
  // Notes are few: at most one a second says how many frames the log could not hold.
  void leftOut(note::LeftOut::Why why, std::uint32_t count);
  void noteLeftOut();
  // Places a note at the end of the log.
  void write(NoteValue value);
  // Tells the services whether the adapter is listen-only, whether it returns echoes and how its controller is.
  void followHardware();
  // Disarms after the computer was asleep: a hand of before is none.
  void followClocks();
  // What the services want sent and noted, and when they want to be called again.
  void serve();
  void deadlineCame();
  void publish();

  std::shared_ptr<LogDocument> m_document;
  LinkSettings m_settings;
  std::unique_ptr<CanLink> m_link;
  Services m_services;
  QTimer* m_tick = nullptr;
  QTimer* m_serviceTimer = nullptr;
  State m_state;
  LogTimes m_times;
  LinkState m_linkState = LinkState::Closed;
  std::vector<note::LeftOut> m_leftOut;  // of each reason, since the last note
  Instant m_nextLeftOut = kNotYet;       // no note of it before
  bool m_storeFull = false;
  bool m_isClosing = false;
  ArmingLock m_armingLock;
  std::optional<Duration> m_asleep;    // in all, when the clocks were last read
  std::atomic<bool> m_isTold = false;  // ticked(), and nobody has taken it
  std::vector<OutFrame> m_toSend;
  std::vector<Note> m_toNote;

  std::shared_ptr<Board> m_board = std::make_shared<Board>();
};

}  // namespace deckpipe
