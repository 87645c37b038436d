// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/fault_text.h"

#include <QCoreApplication>
#include <algorithm>

#include "protocol/akron.h"
#include "text/catalogue_text.h"

namespace deckpipe {
namespace {

struct Fault {
  Q_DECLARE_TR_FUNCTIONS(Fault)
};

}  // namespace

QString faultName(unsigned bit) {
  const auto found = std::ranges::find(akron::kFaultBits, bit, &ValueName::value);
  return found == akron::kFaultBits.end() ? Fault::tr("Reserved bit %1").arg(bit) : wordText(found->word);
}

QString faultRemark(unsigned bit) {
  if (bit >= 17 && bit <= 20) return Fault::tr("older manuals: pCode fault %1").arg(bit - 16);
  if (bit == 22) return Fault::tr("older manuals: real-time clock");
  return {};
}

QStringList faultLines(std::uint32_t map) {
  QStringList lines;
  for (unsigned bit = 0; bit < 32; ++bit) {
    if ((map >> bit & 1u) == 0) continue;
    const QString remark = faultRemark(bit);
    lines << (remark.isEmpty() ? faultName(bit) : Fault::tr("%1 (%2)").arg(faultName(bit), remark));
  }
  return lines;
}

QString pcodeErrorText(unsigned code) {
  const QString name = numberName(akron::kPcodeErrors, code);
  return name.isEmpty() ? Fault::tr("Error %1").arg(code) : Fault::tr("Error %1: %2").arg(code).arg(name);
}

}  // namespace deckpipe
