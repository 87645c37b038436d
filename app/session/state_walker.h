// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the state at a cursor on a thread of its own, and builds keyframes, events and the index of roles when
// there is nothing else to do. The session asks on its tick and takes what is there, so the window waits for no walk.
#pragma once

#include <cstdint>
#include <memory>

#include "base/latest_request_worker.h"
#include "state/log_view.h"

namespace deckpipe {

class StateWalker {
 public:
  explicit StateWalker(std::shared_ptr<LogDocument> document);

  // The newest cursor wins.
  void request(Cursor cursor);
  // The log has grown, or its time has moved on, to `end`: index what is new, and find its events.
  void index(Cursor end);
  // Notes came at places that were walked already: what was found there is found anew.
  void notesCame();
  // The state at the last cursor that was reached; never null.
  std::shared_ptr<const State> latest() const { return m_worker.latest(); }

 private:
  // An intent is whole: a newer one repeats what still holds of the older one.
  struct Intent {
    Cursor cursor;
    Cursor end;                    // of the log, as last told
    std::uint64_t generation = 0;  // counts how often notes came in the past
  };
  using Worker = LatestRequestWorker<Intent, State>;
  void fulfil(const Intent& intent, const Worker::Turn& turn);
  // Null where a newer intent or the end came between.
  std::shared_ptr<const State> walk(const Intent& intent, const Worker::Turn& turn);
  // A step of roles, events and keyframes; false where all are complete.
  bool indexMore(Cursor end);

  std::shared_ptr<LogDocument> m_document;
  Intent m_intent;  // the caller's
  // The worker's own:
  std::shared_ptr<const State> m_here;
  std::uint64_t m_generation = 0;  // of the notes that it knows
  bool m_isAnew = false;           // no state was found since notes came
  Worker m_worker;                 // last: it uses all of the above
};

}  // namespace deckpipe
