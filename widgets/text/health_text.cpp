// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/health_text.h"

#include <QCoreApplication>

namespace deckpipe {
namespace {

struct Texts {
  const char* word;
  const char* sentence;
};

constexpr EnumTable<HealthCause, Texts> kTexts{{
    {HealthCause::Silent, {QT_TRANSLATE_NOOP("Health", "silent"), QT_TRANSLATE_NOOP("Health", "%1.")}},
    {HealthCause::TwoAtOneAddress,
     {QT_TRANSLATE_NOOP("Health", "two at one address"),
      QT_TRANSLATE_NOOP("Health", "Two devices at one address: both send from %1.")}},
    {HealthCause::FaultsNamed,
     {QT_TRANSLATE_NOOP("Health", "fault"), QT_TRANSLATE_NOOP("Health", "It answered: %1.")}},
    {HealthCause::SensorError,
     {QT_TRANSLATE_NOOP("Health", "sensor error"), QT_TRANSLATE_NOOP("Health", "Sensor error: %1.")}},
    {HealthCause::OperationalError,
     {QT_TRANSLATE_NOOP("Health", "operational error"),
      QT_TRANSLATE_NOOP("Health", "It reports an operational error: %1.")}},
    {HealthCause::Faulted,
     {QT_TRANSLATE_NOOP("Health", "faulted"), QT_TRANSLATE_NOOP("Health", "It says that it is faulted.")}},
    {HealthCause::StopError,
     {QT_TRANSLATE_NOOP("Health", "stop error"),
      QT_TRANSLATE_NOOP("Health", "A hard stop reports an error.")}},
    {HealthCause::Disabled,
     {QT_TRANSLATE_NOOP("Health", "disabled"),
      QT_TRANSLATE_NOOP("Health", "Enable is off: it cannot move.")}},
    {HealthCause::PositionInvalid,
     {QT_TRANSLATE_NOOP("Health", "not valid"),
      QT_TRANSLATE_NOOP("Health", "Its position is not valid: %1.")}},
    {HealthCause::Late, {QT_TRANSLATE_NOOP("Health", "late"), QT_TRANSLATE_NOOP("Health", "Late: %1.")}},
    {HealthCause::NotOperational,
     {QT_TRANSLATE_NOOP("Health", "not operational"),
      QT_TRANSLATE_NOOP("Health", "It is not operational (NMT).")}},
    {HealthCause::JoystickStopped,
     {QT_TRANSLATE_NOOP("Health", "stopped"),
      QT_TRANSLATE_NOOP("Health", "It stopped sending joystick messages.")}},
    {HealthCause::AddressLost,
     {QT_TRANSLATE_NOOP("Health", "address lost"),
      QT_TRANSLATE_NOOP("Health", "It lost its address and has announced no other.")}},
    {HealthCause::AddressContested,
     {QT_TRANSLATE_NOOP("Health", "contested"),
      QT_TRANSLATE_NOOP("Health", "Another NAME claims its address too.")}},
    {HealthCause::CannotClaim,
     {QT_TRANSLATE_NOOP("Health", "no address"),
      QT_TRANSLATE_NOOP("Health", "It could not claim an address.")}},
    {HealthCause::Malformed,
     {QT_TRANSLATE_NOOP("Health", "wrong length"),
      QT_TRANSLATE_NOOP("Health", "It sent messages of a wrong length.")}},
    {HealthCause::FaultsNotAnswered,
     {QT_TRANSLATE_NOOP("Health", "no answer"),
      QT_TRANSLATE_NOOP("Health", "Asked for its faults %1, and no answer came.")}},
    {HealthCause::FaultsRefused,
     {QT_TRANSLATE_NOOP("Health", "refused"),
      QT_TRANSLATE_NOOP("Health", "Asked for its faults, it refused or its answer had a wrong length.")}},
    {HealthCause::LinkDown,
     {QT_TRANSLATE_NOOP("Health", "unknown"),
      QT_TRANSLATE_NOOP("Health", "The link went down %1: how it has been since is not known.")}},
    {HealthCause::Filtered,
     {QT_TRANSLATE_NOOP("Health", "filtered"),
      QT_TRANSLATE_NOOP("Health",
                        "This log was saved through a filter: what it left out is not known, and "
                        "whether anything of it is late or silent neither.")}},
    {HealthCause::Idle,
     {QT_TRANSLATE_NOOP("Health", "idle"),
      QT_TRANSLATE_NOOP("Health", "Last heard %1; no periodic message is expected of it.")}},
    {HealthCause::FaultsAwaited,
     {QT_TRANSLATE_NOOP("Health", "asked"),
      QT_TRANSLATE_NOOP("Health", "Asked for its faults; no answer yet.")}},
    {HealthCause::FaultsOld, {QT_TRANSLATE_NOOP("Health", "old answer"), QT_TRANSLATE_NOOP("Health", "%1.")}},
    {HealthCause::FaultsNeverAsked,
     {QT_TRANSLATE_NOOP("Health", "not asked"), QT_TRANSLATE_NOOP("Health", "Its faults were never asked.")}},
    {HealthCause::StatusNeverHeard,
     {QT_TRANSLATE_NOOP("Health", "not heard"), QT_TRANSLATE_NOOP("Health", "Not heard yet: %1.")}},
    {HealthCause::NotAnnounced,
     {QT_TRANSLATE_NOOP("Health", "no PIN"),
      QT_TRANSLATE_NOOP("Health", "It is Akron's by its NAME and has not said its PIN.")}},
    {HealthCause::CannotBeAsked,
     {QT_TRANSLATE_NOOP("Health", "heard"),
      QT_TRANSLATE_NOOP("Health", "Not known to be a device of Akron's: it cannot be asked for faults.")}},
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

}  // namespace deckpipe
