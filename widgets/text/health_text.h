// SPDX-License-Identifier: GPL-3.0-or-later
// How a device is, in the person's language: one word for a list and one sentence for a reason.
#pragma once

#include <QString>

#include "base/health_cause.h"

namespace deckpipe {

// "disabled", "late"; "fine" for Count.
QString healthWord(HealthCause cause);
// A sentence. `what` is the part that differs from device to device: which axis, how long ago, which faults.
// Causes that need none leave it out.
QString healthSentence(HealthCause cause, const QString& what = {});
// What it means for a person, and what to check. Empty for Count.
QString healthAdvice(HealthCause cause);

}  // namespace deckpipe
