// SPDX-License-Identifier: GPL-3.0-or-later
// Connects standard input and output to one device's data pipe, byte for byte. Made by `pipe`, driven by its run's ticks. The pipe service paces it by the device's acks; here
// is only how much is handed over, what follows a missing ack, and when it is over.
#pragma once

#include <QElapsedTimer>
#include <memory>
#include <string>

#include "device_finder.h"

class QSocketNotifier;

namespace deckpipe::ctl {

struct PipePlan {
  enum class MissingAck : std::uint8_t { Stop, Skip, Resend };

  DeviceName whom;
  std::string lineEnd = "\r";  // takes the place of each LF and CR LF of standard input
  double idle = 1;             // s: over when the device said nothing for so long after everything was sent
  MissingAck missingAck = MissingAck::Stop;
  std::string before;    // sent first, as it is
  std::string fileName;  // for people; empty: standard input is sent, no file
  std::shared_ptr<const std::string> content;
};

class PipeTalk {
 public:
  PipeTalk(LiveRun& run, PipePlan plan);
  ~PipeTalk();

 private:
  enum class Phase : std::uint8_t { Finding, Before, Sending, Listening };

  void tick();
  void talk(const PipeStatus& pipe);
  void begin(const DeviceServices& device);
  void beginSending();
  void write(std::string bytes);
  void readInput();
  std::string withLineEnds(std::string_view input);
  void frameCame(const Frame& frame);
  void ackMissing(const PipeStatus& pipe);
  void act(intent::PipeAction::What what);
  void sayProgress(const PipeStatus& pipe);
  void sayEnd(const PipeStatus& pipe);
  static void sayDoubts(const PipeStatus& pipe);
  std::optional<ExitStatus> stop();
  void fail(const QString& why, const PipeStatus& pipe);
  PipeStatus status() const;
  bool sendsFile() const { return m_plan.content != nullptr; }

  LiveRun& m_run;
  PipePlan m_plan;
  DeviceFinder m_finder;
  DeviceKey m_device;
  Address m_address;
  Phase m_phase = Phase::Finding;
  std::unique_ptr<QSocketNotifier> m_input;
  bool m_endsInCr = false;  // the last input: an LF may follow
  bool m_inputEnded = false, m_isStopping = false;
  std::uint64_t m_handed = 0;       // characters handed to the pipe service, no file
  std::uint64_t m_firstSerial = 0;  // of our intents
  // Stalls so far, of which each resend counts again; and stalls that were already answered by resend or skip.
  std::uint32_t m_stalls = 0, m_decided = 0;
  std::uint32_t m_acks = 0;
  unsigned m_inARow = 0;
  QElapsedTimer m_quiet;     // since the device said something, or all was sent
  QElapsedTimer m_sending;   // since the file began
  QElapsedTimer m_progress;  // since it was last told
};

}  // namespace deckpipe::ctl
