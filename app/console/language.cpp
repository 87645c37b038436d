// SPDX-License-Identifier: GPL-3.0-or-later
#include "language.h"

#include <QCoreApplication>
#include <QTranslator>
#include <memory>

// Resources of a static library are known only once asked for, and only from outside of any namespace.
static void knowTranslations() { Q_INIT_RESOURCE(translations); }

namespace deckpipe {

QTranslator* installLanguage(QCoreApplication& application) {
  knowTranslations();
  auto translator = std::make_unique<QTranslator>();
  if (!translator->load(QStringLiteral(":/translations/deckpipe_en.qm"))) return nullptr;
  translator->setParent(&application);
  QCoreApplication::installTranslator(translator.get());
  return translator.release();
}

}  // namespace deckpipe
