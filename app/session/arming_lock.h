// SPDX-License-Identifier: GPL-3.0-or-later
// One Deckpipe a computer may move monitors at a time (design.md section 7, rule 2). The bus takes it when the joystick
// is armed, and gives it back when it is disarmed; the system does so for a program that is killed. It asks no disk.
// Programs in another network namespace are not seen: their name is in another space.
#pragma once

namespace deckpipe {

class ArmingLock {
 public:
  ArmingLock() = default;
  ~ArmingLock() { free(); }
  ArmingLock(const ArmingLock&) = delete;
  ArmingLock& operator=(const ArmingLock&) = delete;

  // False where another one has it, of whatever user.
  bool take();
  void free();

 private:
  int m_socket = -1;
};

}  // namespace deckpipe
