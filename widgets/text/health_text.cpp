// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/health_text.h"

#include <QCoreApplication>

namespace deckpipe {
namespace {

struct Texts {
  const char* word;
  const char* sentence;
  const char* advice;
};

constexpr EnumTable<HealthCause, Texts> kTexts{{
    {HealthCause::Silent,
     {QT_TRANSLATE_NOOP("Health", "silent"), QT_TRANSLATE_NOOP("Health", "%1."),
      QT_TRANSLATE_NOOP("Health",
                        "Check whether it has power, whether its CAN plug is in, and whether others on the "
                        "same bus are heard.")}},
    {HealthCause::TwoAtOneAddress,
     {QT_TRANSLATE_NOOP("Health", "two at one address"),
      QT_TRANSLATE_NOOP("Health", "Two devices at one address: both send from %1."),
      QT_TRANSLATE_NOOP(
          "Health",
          "Nothing that is shown here is sure to be of this one. Take one of the two off the bus, or give it "
          "another address. A log that holds every frame twice looks the same.")}},
    {HealthCause::FaultsNamed,
     {QT_TRANSLATE_NOOP("Health", "fault"), QT_TRANSLATE_NOOP("Health", "It answered: %1."),
      QT_TRANSLATE_NOOP("Health",
                        "Look up what it names in the device's own manual. When the cause is mended, ask for "
                        "its faults again.")}},
    {HealthCause::SensorError,
     {QT_TRANSLATE_NOOP("Health", "sensor error"), QT_TRANSLATE_NOOP("Health", "Sensor error: %1."),
      QT_TRANSLATE_NOOP(
          "Health",
          "Where this axis stands is not known. Check the position sensor, its plug and its cable.")}},
    {HealthCause::OperationalError,
     {QT_TRANSLATE_NOOP("Health", "operational error"),
      QT_TRANSLATE_NOOP("Health", "It reports an operational error: %1."),
      QT_TRANSLATE_NOOP("Health",
                        "While it lasts, the panel LED blinks the error code. Ask for its faults, and look "
                        "up the code in the device's own manual.")}},
    {HealthCause::Faulted,
     {QT_TRANSLATE_NOOP("Health", "faulted"), QT_TRANSLATE_NOOP("Health", "It says that it is faulted."),
      QT_TRANSLATE_NOOP("Health", "Message 84 says no more than that. Its own manual names the causes.")}},
    {HealthCause::StopError,
     {QT_TRANSLATE_NOOP("Health", "stop error"), QT_TRANSLATE_NOOP("Health", "A hard stop reports an error."),
      QT_TRANSLATE_NOOP("Health",
                        "The device reports the stop itself in error: whether the axis stands there is not "
                        "known. Check the sensing of the stop and its cable.")}},
    {HealthCause::Disabled,
     {QT_TRANSLATE_NOOP("Health", "disabled"), QT_TRANSLATE_NOOP("Health", "Enable is off: it cannot move."),
      QT_TRANSLATE_NOOP("Health",
                        "With enable off, CAN goes on and nothing moves. Look at the truck for what takes "
                        "the enable away; the device's own manual names it.")}},
    {HealthCause::PositionInvalid,
     {QT_TRANSLATE_NOOP("Health", "not valid"), QT_TRANSLATE_NOOP("Health", "Its position is not valid: %1."),
      QT_TRANSLATE_NOOP("Health",
                        "Value and direction contradict each other in the message. If it stays, check the "
                        "position sensor and its cable.")}},
    {HealthCause::Late,
     {QT_TRANSLATE_NOOP("Health", "late"), QT_TRANSLATE_NOOP("Health", "Late: %1."),
      QT_TRANSLATE_NOOP(
          "Health",
          "Other messages come, this one does not. Check how busy the bus is, and whether it has errors.")}},
    {HealthCause::NotOperational,
     {QT_TRANSLATE_NOOP("Health", "not operational"),
      QT_TRANSLATE_NOOP("Health", "It is not operational (NMT)."),
      QT_TRANSLATE_NOOP(
          "Health",
          "Its process data come in the state operational alone. The master of its network starts it.")}},
    {HealthCause::JoystickStopped,
     {QT_TRANSLATE_NOOP("Health", "stopped"),
      QT_TRANSLATE_NOOP("Health", "It stopped sending joystick messages."),
      QT_TRANSLATE_NOOP("Health",
                        "After 200 ms without a message a controller clears what this joystick asked for. "
                        "Check its power and its CAN plug.")}},
    {HealthCause::AddressLost,
     {QT_TRANSLATE_NOOP("Health", "address lost"),
      QT_TRANSLATE_NOOP("Health", "It lost its address and has announced no other."),
      QT_TRANSLATE_NOOP("Health",
                        "Another NAME took its address. Look in the list of devices who holds it now; a "
                        "restart makes it claim anew.")}},
    {HealthCause::AddressContested,
     {QT_TRANSLATE_NOOP("Health", "contested"),
      QT_TRANSLATE_NOOP("Health", "Another NAME claims its address too."),
      QT_TRANSLATE_NOOP("Health",
                        "For 250 ms it is open who keeps the address; nothing is sent there. If it comes "
                        "again, two devices want the same address.")}},
    {HealthCause::CannotClaim,
     {QT_TRANSLATE_NOOP("Health", "no address"),
      QT_TRANSLATE_NOOP("Health", "It could not claim an address."),
      QT_TRANSLATE_NOOP("Health",
                        "Each address that it may have is taken. Look in the list of devices who holds the "
                        "one that it wants.")}},
    {HealthCause::Malformed,
     {QT_TRANSLATE_NOOP("Health", "wrong length"),
      QT_TRANSLATE_NOOP("Health", "It sent messages of a wrong length."),
      QT_TRANSLATE_NOOP("Health",
                        "No manual here gives that length. Another firmware or another maker's device at "
                        "this address sends so.")}},
    {HealthCause::FaultsNotAnswered,
     {QT_TRANSLATE_NOOP("Health", "no answer"),
      QT_TRANSLATE_NOOP("Health", "Asked for its faults %1, and no answer came."),
      QT_TRANSLATE_NOOP("Health",
                        "It may be busy, off the bus, or not of a type that answers. See whether anything "
                        "else of it is heard, and ask again.")}},
    {HealthCause::FaultsRefused,
     {QT_TRANSLATE_NOOP("Health", "refused"),
      QT_TRANSLATE_NOOP("Health", "Asked for its faults, it refused or its answer had a wrong length."),
      QT_TRANSLATE_NOOP("Health",
                        "Ask again; if it stays, its firmware may give another answer than the manual.")}},
    {HealthCause::LinkDown,
     {QT_TRANSLATE_NOOP("Health", "unknown"),
      QT_TRANSLATE_NOOP("Health", "The link went down %1: how it has been since is not known."),
      QT_TRANSLATE_NOOP("Health", "Connect again, then look again.")}},
    {HealthCause::Filtered,
     {QT_TRANSLATE_NOOP("Health", "filtered"),
      QT_TRANSLATE_NOOP("Health",
                        "This log was saved through a filter: what it left out is not known, and "
                        "whether anything of it is late or silent neither."),
      QT_TRANSLATE_NOOP("Health", "Open the log that it was saved from.")}},
    {HealthCause::Idle,
     {QT_TRANSLATE_NOOP("Health", "idle"), QT_TRANSLATE_NOOP("Health", "%1."),
      QT_TRANSLATE_NOOP("Health", "Ask it for its firmware or faults: an answer shows that it is there.")}},
    {HealthCause::FaultsAwaited,
     {QT_TRANSLATE_NOOP("Health", "asked"),
      QT_TRANSLATE_NOOP("Health", "Asked for its faults; no answer yet."),
      QT_TRANSLATE_NOOP("Health", "The answer is due within half a second.")}},
    {HealthCause::FaultsOld,
     {QT_TRANSLATE_NOOP("Health", "old answer"), QT_TRANSLATE_NOOP("Health", "%1."),
      QT_TRANSLATE_NOOP("Health", "Ask for its faults again.")}},
    {HealthCause::FaultsNeverAsked,
     {QT_TRANSLATE_NOOP("Health", "not asked"), QT_TRANSLATE_NOOP("Health", "Its faults were never asked."),
      QT_TRANSLATE_NOOP("Health",
                        "Ask for its faults (Ctrl+R): without an answer nothing is known of them.")}},
    {HealthCause::StatusNeverHeard,
     {QT_TRANSLATE_NOOP("Health", "not heard"), QT_TRANSLATE_NOOP("Health", "Not heard yet: %1."),
      QT_TRANSLATE_NOOP("Health",
                        "Its type sends this message by itself. Wait a moment; if it does not come, restart "
                        "the device or check that it is of this type.")}},
    {HealthCause::NotAnnounced,
     {QT_TRANSLATE_NOOP("Health", "no PIN"),
      QT_TRANSLATE_NOOP("Health", "It is Akron's by its NAME and has not said its PIN."),
      QT_TRANSLATE_NOOP(
          "Health", "Ask who is there (menu Bus): devices of Akron's follow their answer with their PIN.")}},
    {HealthCause::CannotBeAsked,
     {QT_TRANSLATE_NOOP("Health", "heard"),
      QT_TRANSLATE_NOOP("Health", "Not known to be a device of Akron's: it cannot be asked for faults."),
      QT_TRANSLATE_NOOP("Health", "What it sends is in the trace. Nothing of Akron's is ever sent to it.")}},
}};

}  // namespace

QString healthWord(HealthCause cause) {
  return cause == HealthCause::Count ? QCoreApplication::translate("Health", "fine")
                                     : QCoreApplication::translate("Health", kTexts[cause].word);
}

QString healthSentence(HealthCause cause, const QString& what) {
  const QString sentence = QCoreApplication::translate("Health", kTexts[cause].sentence);
  return sentence.contains(QLatin1String("%1")) ? sentence.arg(what) : sentence;
}

QString healthAdvice(HealthCause cause) {
  return cause == HealthCause::Count ? QString()
                                     : QCoreApplication::translate("Health", kTexts[cause].advice);
}

}  // namespace deckpipe
