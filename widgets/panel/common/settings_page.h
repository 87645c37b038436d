// SPDX-License-Identifier: GPL-3.0-or-later
// What a person can set, each with what it does. Every choice holds at once and is kept; the console applies
// them and shows those that hold.
#pragma once

#include "paint/app_style.h"
#include "paint/palette.h"
#include "panel/common/build.h"

class QButtonGroup;
class QLabel;
class QSpinBox;
class QVBoxLayout;

namespace deckpipe {

class SettingsPage : public ExtraPage {
  Q_OBJECT

 public:
  explicit SettingsPage(QWidget* parent = nullptr);

  void setTheme(Theme theme);
  void setDensity(Density density);
  // Who the console is on a bus: the address it would like and the identity number of its NAME, with the
  // largest there is.
  void setIdentity(int preferredAddress, int identityNumber, int largestIdentity);
  // How much of what was recorded is kept.
  void setRecordingLimits(int megabytes, int days);
  // Says why this address is not used: it is a joystick's or a monitor's.
  void refuseAddress(int address);
  // Where all this is kept.
  void setPath(const QString& path);

 Q_SIGNALS:
  void themeChosen(deckpipe::Theme theme);
  void densityChosen(deckpipe::Density density);
  // The address is never one that addressUse() refuses.
  void identityChosen(int preferredAddress, int identityNumber);
  void recordingLimitsChosen(int megabytes, int days);
  void resetLayoutRequested();
  void forgetLogsRequested();

 private:
  QButtonGroup* addGroup(const QString& title);
  void addChoice(QButtonGroup* group, int id, const char* name, const QString& text, const QString& story);
  QLabel* makeStory(const QString& story);
  QLabel* addStory(const QString& story);
  QSpinBox* addNumber(QSpinBox* box, const char* name, const QString& text, const QString& story, int least,
                      int most);
  void takeAddress(int address);
  void sayIdentity();
  void sayUse();
  void addAction(const char* name, const QString& text, const QString& story, void (SettingsPage::*intent)());

  QVBoxLayout* m_column;
  QButtonGroup* m_themes;
  QButtonGroup* m_densities;
  QSpinBox* m_address;
  QLabel* m_addressNote;
  int m_takenAddress = 0;  // the last that was not refused
  QSpinBox* m_identity;
  QSpinBox* m_megabytes;
  QSpinBox* m_days;
  QLabel* m_path;
};

}  // namespace deckpipe
