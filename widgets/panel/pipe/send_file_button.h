// SPDX-License-Identifier: GPL-3.0-or-later
// "Send file…": chooses a file, reads it, and asks once by the device's name before it is sent over the data
// pipe: as it is, or, of a text whose lines end otherwise than the device takes them, with one chosen end a
// line. Part of the terminal; how the sending goes is the FileSendBar's.
#pragma once

#include <QPushButton>

#include "control/intent.h"
#include "panel/common/device_question.h"

namespace deckpipe {

class PipeInput;

class SendFileButton : public QPushButton {
  Q_OBJECT

 public:
  static constexpr qint64 kLargest = 8 << 20;  // at some hundred bytes a second more would take days

  // The lines of a text may go with the end that is chosen at `input` for what is typed.
  explicit SendFileButton(const PipeInput& input, QWidget* parent = nullptr);

  // The file goes to whom it was chosen for, whatever device is looked at by then.
  void setView(const PanelView& view);

 Q_SIGNALS:
  void intended(const deckpipe::Intent& intent);
  // Empty: another try begins.
  void failed(const QString& why);

 private:
  void choose();
  void confirm(const QString& path, const DeviceKey& device, const QString& name);

  const PipeInput& m_input;
  PanelView m_view;
  DeviceQuestion m_question;
};

}  // namespace deckpipe
