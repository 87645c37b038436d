// SPDX-License-Identifier: GPL-3.0-or-later
// Part of every test program and tool of the thread sanitizer's build. Debian's Qt is not instrumented and
// locks with futexes, so the sanitizer does not see that a call that one thread posts happens before the
// other thread runs it. This file tells it: what was written before a signal or a queued call is known to
// each thread that takes an event later. All threads share one such mark, so that a race between two threads
// may hide behind a call that they exchanged for something else; that is the price of knowing neither the
// receiver of a signal nor the sender of an event.
#include <dlfcn.h>

#include <QObject>

extern "C" void __tsan_acquire(void* mark);
extern "C" void __tsan_release(void* mark);

// Qt's own hook for debuggers (private/qobject_p.h).
struct QSignalSpyCallbackSet {
  void (*signalBegin)(QObject* sender, int signal, void** arguments);
  void (*slotBegin)(QObject* receiver, int method, void** arguments);
  void (*signalEnd)(QObject* sender, int signal);
  void (*slotEnd)(QObject* receiver, int method);
};
Q_CORE_EXPORT void qt_register_signal_spy_callbacks(QSignalSpyCallbackSet* callbacks);

namespace {

char handOver;

QSignalSpyCallbackSet spy{
    [](QObject*, int, void**) { __tsan_release(&handOver); },
    nullptr,
    nullptr,
    nullptr,
};

[[maybe_unused]] const bool hooked = [] {
  qt_register_signal_spy_callbacks(&spy);
  return QInternal::registerCallback(QInternal::EventNotifyCallback, [](void**) {
    __tsan_acquire(&handOver);
    return false;  // the event goes on to its receiver
  });
}();

template <typename F>
F original(const char* symbol) {
  return reinterpret_cast<F>(dlsym(RTLD_NEXT, symbol));
}

}  // namespace

// These two stand before Qt's own, for the calls from our code.
bool QMetaObject::invokeMethodImpl(QObject* object, QtPrivate::QSlotObjectBase* slot, Qt::ConnectionType type,
                                   void* result) {
  static const auto invoke = original<bool (*)(QObject*, QtPrivate::QSlotObjectBase*, Qt::ConnectionType,
                                               void*)>(
      "_ZN11QMetaObject16invokeMethodImplEP7QObjectPN9QtPrivate15QSlotObjectBaseEN2Qt14ConnectionTypeEPv");
  __tsan_release(&handOver);
  return invoke(object, slot, type, result);
}

void QObject::deleteLater() {
  static const auto deleteLater = original<void (*)(QObject*)>("_ZN7QObject11deleteLaterEv");
  __tsan_release(&handOver);
  deleteLater(this);
}
