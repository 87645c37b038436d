// SPDX-License-Identifier: GPL-3.0-or-later
// Logs as a truck writes them, for pictures and tests of the panels.
#pragma once

#include <cstdio>
#include <memory>
#include <string>

#include "support/logs.h"

namespace deckpipe::test {

inline void addLine(std::string& text, double seconds, const char* frame, const char* channel = "can0") {
  char line[96];
  std::snprintf(line, sizeof line, "(%.6f) %s %s\n", 1'700'000'000.0 + seconds, channel, frame);
  text += line;
}

// A monitor that is turned by a joystick, a gateway, polls and answers, a wrong length, an error.
inline std::string busyText(int rounds) {
  std::string text;
  addLine(text, 0, "18EEFF80#0B1AC22800420090");
  addLine(text, 0.25, "18EFFF80#FF83150206021A0B");
  addLine(text, 0.31, "5A4#4300500116699803", "can1");
  for (int i = 0; i < rounds; ++i) {
    const double t = 0.5 + i * 0.1;
    char frame[64];
    std::snprintf(frame, sizeof frame, "18EFFF80#01%02X%X40371000001", (i * 3) & 0xFF, i & 0xF);
    addLine(text, t, frame);
    addLine(text, t + 0.0004, i % 8 == 0 ? "18EFFF80#83C071" : "18EFFF80#83C051");
    addLine(text, t + 0.0011, "18EFFF80#81FED401C280");
    addLine(text, t + 0.02, "0CFDD633#107D046400100000 T");
    addLine(text, t + 0.0204, "1A4#011D940371000001", "can1");
    if (i % 10 == 0) addLine(text, t + 0.03, "724#05", "can1");
    if (i % 5 == 0) addLine(text, t + 0.04, "18EF8005#02 T");
    if (i % 5 == 0)
      addLine(text, t + 0.043, i % 10 == 0 ? "18EF0580#0200000000000B" : "18EF0580#02000000020000");
    if (i % 7 == 3) addLine(text, t + 0.05, "18EFFF80#011D94");
    if (i % 9 == 4) addLine(text, t + 0.06, "18EF81A0#FE0102030405");
    if (i % 9 == 5) addLine(text, t + 0.061, "18FEF100#F3FFFF0000FFFFFF");
    if (i % 11 == 6) addLine(text, t + 0.062, "20000088#0000000000000000");
    if (i % 11 == 7) addLine(text, t + 0.063, "724#R", "can1");
    if (i % 13 == 8) addLine(text, t + 0.064, "5A4#8001500200000206", "can1");
    if (i % 15 == 9) addLine(text, t + 0.065, "18EF80F2#FE48454C4C4F0D0A T");
    if (i == rounds / 2) addLine(text, t - 30, "18EFFF80#82FF38038400");
  }
  return text;
}

// Everything out of the ordinary within one page.
inline std::string oddText() {
  std::string text;
  addLine(text, 0.0, "18EFFF80#011D940371000041");
  addLine(text, 0.1, "18EFFF80#011D94");
  addLine(text, 0.2, "18EF81A0#FE0102030405");
  addLine(text, 0.3, "20000088#0000000000000000");
  addLine(text, 0.4, "724#R", "can1");
  addLine(text, -40, "724#7F", "can1");
  addLine(text, 0.6, "18EFFF80#FF83150206021A0B");
  addLine(text, 0.7, "18EFFF80#01FFFFFFF4800004");
  addLine(text, 0.8, "18EFFF80#011D94");
  addLine(text, 0.9, "18EFFF80#55AA");
  addLine(text, 9000, "18EF80F2#FE48454C4C4F0D0A T");
  addLine(text, 9000.1, "18EF0580#0280201003");
  addLine(text, 9000.2, "18EF0580#0200000000000B T");
  addLine(text, 9000.3, "1CEBFF00#01FFFFFFFFFFFFFF");
  addLine(text, 9000.4, "123#");
  addLine(text, 9000.5, "000#8124", "can1");
  addLine(text, 9000.6, "5A4#8001500200000206", "can1");
  addLine(text, 9000.7, "18EFFF80#83C051");
  addLine(text, 9000.8, "18EFFF80#011D94");
  addLine(text, 9000.9, "20000004#0000000000000000", "can1");
  return text;
}

// Nothing of it is for this console.
inline std::string foreignText(int rounds) {
  std::string text;
  for (int i = 0; i < rounds; ++i) {
    const double t = i * 0.01;
    char frame[64];
    std::snprintf(frame, sizeof frame, "18F00400#F0%02X7D%02X1300FF7D", i & 0xFF, (i * 7) & 0xFF);
    addLine(text, t, frame);
    std::snprintf(frame, sizeof frame, "18FEF200#%02X00FFFF0000FFFF", (i * 5) & 0xFF);
    addLine(text, t + 0.002, frame);
    std::snprintf(frame, sizeof frame, "2F%X#%02X", i & 7, i & 0xFF);
    addLine(text, t + 0.004, frame);
    if (i % 12 == 0) addLine(text, t + 0.005, "1CECFF00#20160004FFCAFE00");
  }
  return text;
}

}  // namespace deckpipe::test
