// SPDX-License-Identifier: GPL-3.0-or-later
// The language of the program: its texts are English in the source, their plurals come from translations/.
// Called once, before any window is made.
#pragma once

class QCoreApplication;
class QTranslator;

namespace deckpipe {

// The translator belongs to the application. Null where the program was built without its texts.
QTranslator* installLanguage(QCoreApplication& application);

}  // namespace deckpipe
