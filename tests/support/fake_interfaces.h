// SPDX-License-Identifier: GPL-3.0-or-later
// An interface of Linux that does what a test says, for links that follow one. Put under a link on a virtual
// bus it shows what the link makes of the kernel's news, on a machine without CAN.
//
//   auto source = std::make_unique<FakeInterfaces>(name);   FakeInterfaces& fake = *source;
//   CanLink link(settings, nullptr, CanLink::systemClock, std::move(source));
//   fake.set([](CanInterface& facts) { facts.isUp = false; });    happens, and is told
//   fake.setSilently(...); fake.loseNews();            happens, and is not told; then 'ask again'
//   fake.hold(); ... fake.release();                   the kernel's lock is held: no answers
//
// A question is answered from the event loop, with the facts of the moment of the question.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "link/interface_watch.h"

namespace deckpipe {

class FakeInterfaces : public InterfaceSource {
 public:
  explicit FakeInterfaces(std::string name) : m_name(std::move(name)) { plug(); }

  using Change = std::function<void(CanInterface&)>;
  void setSilently(const Change& change) { change(*m_now); }
  void set(const Change& change) {
    change(*m_now);
    tell(*m_now);
  }
  void unplugSilently() { m_now.reset(); }
  void unplug() {
    CanInterface last = *m_now;
    last.isRemoved = true;
    m_now.reset();
    tell(last);
  }
  // Anew, under another index as the kernel does it; up at 250 kbit/s unless told otherwise.
  void plug(const Change& change = {}) {
    m_now.emplace();
    m_now->index = ++m_lastIndex;
    m_now->name = m_name;
    m_now->isCan = true;
    m_now->isUp = true;
    m_now->bitRate = 250'000;
    if (change) change(*m_now);
    tell(*m_now);
  }
  // Of any interface.
  void tell(const CanInterface& facts) {
    if (m_isStarted) Q_EMIT changed(facts);
  }
  void loseNews() {
    if (m_isStarted) Q_EMIT overrun();
  }
  bool isStarted() const { return m_isStarted; }

  CanInterface now() const { return *m_now; }

  void hold() { m_isHeld = true; }
  bool isAsked() const { return m_isAsked; }
  void release() {
    m_isHeld = false;
    if (m_isAsked) answerSoon();
  }

  void request(const std::string& name) override {
    if (m_now && name == m_name) {
      m_answer = *m_now;
    } else {
      m_answer = Failure{std::string("No such device")};
    }
    m_isAsked = true;
    ++m_questions;
    if (!m_isHeld) answerSoon();
  }
  void start() override { m_isStarted = true; }
  void stop() override { m_isStarted = m_isAsked = false; }

 private:
  void answerSoon() {
    const auto answer = [this, question = m_questions] {
      if (m_isAsked && question == m_questions) {
        m_isAsked = false;
        Q_EMIT answered(m_answer);
      }
    };
    QMetaObject::invokeMethod(this, answer, Qt::QueuedConnection);
  }

  std::string m_name;
  std::optional<CanInterface> m_now;
  int m_lastIndex = 6;
  bool m_isStarted = false;
  bool m_isHeld = false;
  bool m_isAsked = false;
  int m_questions = 0;
  InterfaceReader::Answer m_answer{CanInterface{}};
};

}  // namespace deckpipe
