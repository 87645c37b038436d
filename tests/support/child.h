// SPDX-License-Identifier: GPL-3.0-or-later
// A child that a test needs. One that is not there ends the test as failed, with its type and name, instead
// of the whole program with a null pointer. Whoever asks whether there is one calls findChild() itself.
#pragma once

#include <QObject>
#include <QString>
#include <stdexcept>

namespace deckpipe::test {

template <typename T>
T* child(const QObject& parent, const QString& name) {
  if (T* found = parent.findChild<T*>(name)) return found;
  throw std::runtime_error("no " + std::string(T::staticMetaObject.className()) + " '" + name.toStdString() +
                           "' in '" + parent.objectName().toStdString() + "'");
}
template <typename T>
T* child(const QObject& parent, const char* name) {
  return child<T>(parent, QString::fromLatin1(name));
}
// The first of its type.
template <typename T>
T* child(const QObject& parent) {
  return child<T>(parent, QString());
}

}  // namespace deckpipe::test
