// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the state at a cursor on a thread of its own, and builds keyframes, events and the index of roles when
// there is nothing else to do. The session asks on its tick and takes what is there: the window never waits for a
// walk.
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "state/log_view.h"

namespace deckpipe {

class StateWalker {
 public:
  explicit StateWalker(std::shared_ptr<LogDocument> document);
  ~StateWalker();

  // The newest request wins.
  void request(Cursor cursor);
  // The log has grown, or its time has moved on, to `end`: index what is new, and find its events.
  void index(Cursor end);
  // Notes came at places that were walked already: what was found there is found anew.
  void notesCame();
  // The state at the last cursor that was reached; never null.
  std::shared_ptr<const State> latest() const;

 private:
  void run(std::stop_token stop);
  std::shared_ptr<const State> walkTo(Cursor cursor, bool isAnew, const std::stop_token& stop);
  // A step of roles, events and keyframes; false where all are complete.
  bool indexMore();
  bool isSuperseded() const;

  std::shared_ptr<LogDocument> m_document;
  mutable std::mutex m_lock;
  std::condition_variable_any m_wake;
  std::optional<Cursor> m_request;
  bool m_indexRequested = false;
  bool m_notesCame = false;
  Cursor m_end;  // of the log, as last told
  std::shared_ptr<const State> m_latest;
  std::jthread m_thread;  // last: it uses all of the above
};

}  // namespace deckpipe
