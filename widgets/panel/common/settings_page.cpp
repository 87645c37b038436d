// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/common/settings_page.h"

#include <QButtonGroup>
#include <QPushButton>
#include <QRadioButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <algorithm>

#include "panel/common/build.h"
#include "protocol/address_book.h"
#include "text/device_text.h"

namespace deckpipe {
namespace {

constexpr int kSettingsColumn = 640;
constexpr int kIndent = 30;
constexpr int kMaxMegabytes = 1'000'000;
constexpr int kMaxDays = 10'000;

QString hex(int address) { return hexText(static_cast<std::uint8_t>(address)); }
AddressUse useOf(int address) { return addressUse(Address{static_cast<std::uint8_t>(address)}); }

// Addresses as everywhere else: F9. Steps pass over those that are refused.
class AddressBox : public QSpinBox {
 public:
  using QSpinBox::QSpinBox;
  void stepBy(int steps) override {
    int wanted = std::clamp(value() + steps, minimum(), maximum());
    while (useOf(wanted) == AddressUse::Refused) wanted += steps < 0 ? -1 : 1;
    setValue(wanted);
  }

 protected:
  QString textFromValue(int value) const override { return hex(value); }
};

}  // namespace

SettingsPage::SettingsPage(QWidget* parent) : ExtraPage(parent) {
  named(this, "settingsPage", tr("Settings"));
  auto* inside = new QWidget;
  inside->setMaximumWidth(kSettingsColumn);
  m_column = inColumn(inside, {24, 16, 24, 16}, 4, {});
  m_column->addWidget(makeTitle(inside, "", tr("Settings"), 1.5));
  m_themes = addGroup(tr("Colours"));
  addChoice(m_themes, static_cast<int>(Theme::Light), "lightTheme", tr("Light"),
            tr("For indoors and for shade."));
  addChoice(m_themes, static_cast<int>(Theme::Dark), "darkTheme", tr("Dark"),
            tr("For the night: does not blind."));
  addChoice(m_themes, static_cast<int>(Theme::Sunlight), "sunlightTheme", tr("Sunlight"),
            tr("For direct sun: black on white, heavier lines."));
  m_densities = addGroup(tr("Size"));
  addChoice(m_densities, static_cast<int>(Density::Desk), "deskDensity", tr("Desk"),
            tr("More fits on the screen; for mouse and keyboard."));
  addChoice(m_densities, static_cast<int>(Density::Field), "fieldDensity", tr("Field"),
            tr("Larger text, and buttons that gloves can hit."));
  m_column->addSpacing(12);
  m_column->addWidget(makeTitle(inside, "", tr("On the bus"), 1.15));
  m_address =
      addNumber(new AddressBox(this), "preferredAddress", tr("Preferred address, hex"),
                tr("Claimed on unlocking; where another holds it, F9, FA or a free one of 80 to F7 is "
                   "taken."),
                0, 0xFD);
  m_address->setDisplayIntegerBase(16);
  m_addressNote = addStory({});
  m_addressNote->setObjectName(QStringLiteral("preferredAddressNote"));
  m_identity = addNumber(new QSpinBox(this), "identityNumber", tr("Identity number"),
                         tr("Of this computer's NAME. Two consoles on one bus need different ones; it was "
                            "made up when the program first ran."),
                         1, 1);
  addStory(tr("Both hold from the next connection."));
  m_column->addSpacing(12);
  m_column->addWidget(makeTitle(inside, "", tr("Recordings"), 1.15));
  m_megabytes = addNumber(new QSpinBox(this), "recordingMegabytes", tr("All together at most, MB"),
                          tr("Beyond it the oldest go, when the program starts."), 0, kMaxMegabytes);
  m_days = addNumber(new QSpinBox(this), "recordingDays", tr("Kept at most, days"),
                     tr("Only what was saved, or was received from the simulated truck, goes by itself. What "
                        "was not saved stays until you delete it."),
                     0, kMaxDays);
  m_column->addSpacing(12);
  m_column->addWidget(makeTitle(inside, "", tr("Put back"), 1.15));
  addAction("settingsResetLayout", tr("Reset layout"), tr("Puts every dock back where it was at first."),
            &SettingsPage::resetLayoutRequested);
  addAction("settingsForgetLogs", tr("Forget recent logs"), tr("Empties the list of logs; the files stay."),
            &SettingsPage::forgetLogsRequested);
  m_column->addSpacing(12);
  m_path = makeWords(inside, "settingsPath", tr("Where settings are kept"), Ink::Secondary);
  m_path->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_column->addWidget(m_path);
  m_column->addSpacing(12);
  QPushButton* done = makeDone("settingsDone", tr("Close the settings"));
  m_column->addWidget(done, 0, Qt::AlignLeft);
  m_column->addStretch(1);
  fillScrolled(this, inside, "settingsScroll");
  connect(m_themes, &QButtonGroup::idClicked, this,
          [this](int id) { Q_EMIT themeChosen(static_cast<Theme>(id)); });
  connect(m_densities, &QButtonGroup::idClicked, this,
          [this](int id) { Q_EMIT densityChosen(static_cast<Density>(id)); });
  connect(m_address, &QSpinBox::valueChanged, this, &SettingsPage::takeAddress);
  connect(m_identity, &QSpinBox::valueChanged, this, &SettingsPage::sayIdentity);
  for (const QSpinBox* box : {m_megabytes, m_days}) {
    connect(box, &QSpinBox::valueChanged, this,
            [this] { Q_EMIT recordingLimitsChosen(m_megabytes->value(), m_days->value()); });
  }
}

QButtonGroup* SettingsPage::addGroup(const QString& title) {
  m_column->addSpacing(12);
  m_column->addWidget(makeTitle(this, "", title, 1.15));
  return new QButtonGroup(this);
}

void SettingsPage::addChoice(QButtonGroup* group, int id, const char* name, const QString& text,
                             const QString& story) {
  auto* choice = named(new QRadioButton(text, this), name, text);
  choice->setAccessibleDescription(story);
  group->addButton(choice, id);
  m_column->addWidget(choice);
  addStory(story)->setIndent(kIndent);
}

QLabel* SettingsPage::makeStory(const QString& story) {
  QLabel* label = makeWords(this, "", {}, Ink::Secondary);
  label->setText(story);
  return label;
}

QLabel* SettingsPage::addStory(const QString& story) {
  QLabel* label = makeStory(story);
  m_column->addWidget(label);
  return label;
}

QSpinBox* SettingsPage::addNumber(QSpinBox* box, const char* name, const QString& text, const QString& story,
                                  int least, int most) {
  named(box, name, text);
  box->setAccessibleDescription(story);
  box->setRange(least, most);
  box->setKeyboardTracking(false);
  auto* label = new QLabel(text, this);
  label->setBuddy(box);
  m_column->addLayout(inRow({label, box, LayoutPart::rest()}));
  addStory(story);
  return box;
}

void SettingsPage::addAction(const char* name, const QString& text, const QString& story,
                             void (SettingsPage::*intent)()) {
  auto* made = makeButton(this, name, text);
  made->setAccessibleDescription(story);
  connect(made, &QPushButton::clicked, this, intent);
  m_column->addLayout(inRow({made, {makeStory(story), 1}}));
}

void SettingsPage::setTheme(Theme theme) { m_themes->button(static_cast<int>(theme))->setChecked(true); }

void SettingsPage::setDensity(Density density) {
  m_densities->button(static_cast<int>(density))->setChecked(true);
}

void SettingsPage::takeAddress(int address) {
  if (useOf(address) != AddressUse::Refused) {
    m_takenAddress = address;
    sayUse();
    return sayIdentity();
  }
  const QSignalBlocker silent(m_address);
  m_address->setValue(m_takenAddress);
  refuseAddress(address);
}

void SettingsPage::sayIdentity() { Q_EMIT identityChosen(m_takenAddress, m_identity->value()); }

void SettingsPage::sayUse() {
  m_addressNote->setText(
      useOf(m_takenAddress) == AddressUse::Warn
          ? tr("Below 80 an address is fixed and belongs to a device, which may be on your bus.")
          : tr("F9 is that of a service tool (SAE J1939). F8 to FD are free to choose."));
}

void SettingsPage::refuseAddress(int address) {
  m_addressNote->setText(
      tr("%1 is not taken: 33 to 38 are joysticks' addresses, which monitors obey, and 80 to F7 "
         "are monitors' own.")
          .arg(hex(address)));
}

void SettingsPage::setIdentity(int preferredAddress, int identityNumber, int largestIdentity) {
  const QSignalBlocker address(m_address), identity(m_identity);
  m_takenAddress = preferredAddress;
  m_address->setValue(preferredAddress);
  m_identity->setMaximum(largestIdentity);
  m_identity->setValue(identityNumber);
  sayUse();
}

void SettingsPage::setRecordingLimits(int megabytes, int days) {
  const QSignalBlocker ofMegabytes(m_megabytes), ofDays(m_days);
  m_megabytes->setValue(megabytes);
  m_days->setValue(days);
}

void SettingsPage::setPath(const QString& path) { m_path->setText(tr("Settings are kept in %1").arg(path)); }

}  // namespace deckpipe
