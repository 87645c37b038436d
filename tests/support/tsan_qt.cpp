// SPDX-License-Identifier: GPL-3.0-or-later
// Part of every program with Qt in the thread sanitizer's build. Debian's Qt is not instrumented and locks
// with futexes, so the sanitizer does not see that a call that one thread posts happens before the other
// thread runs it. This file tells it. A queued call is known to the thread that runs it. A signal is
// known to every thread that takes a posted call later, since its receivers cannot be told here: a race may
// hide behind a signal that was emitted between its two sides.
#include <dlfcn.h>

#include <QCoreApplication>
#include <QObject>
#include <QThread>

extern "C" void __tsan_acquire(void* mark);
extern "C" void __tsan_release(void* mark);

// Debian's libraries are not instrumented and lock with futexes, so the sanitizer would take each of their own
// hand-overs for a race: Qt frees an event that another thread allocated, libproxy reads its list of proxies.
// What they do themselves, through the allocator and the string functions, is therefore not looked at. What
// our code reads and writes is, also where one of them calls it.
extern "C" const char* __tsan_default_suppressions() {
  return "called_from_lib:libQt6Core.so.6\n"
         "called_from_lib:libQt6Gui.so.6\n"
         "called_from_lib:libQt6Network.so.6\n"
         "called_from_lib:libQt6Widgets.so.6\n"
         "called_from_lib:libproxy.so.1\n"
         "called_from_lib:libglib-2.0.so.0\n"
         "race:tzset_internal\n";  // glibc's own lock
}

// QProcess starts programs by vfork, whose child shares this memory: the sanitizer takes the parent for the child of
// a fork.
extern "C" const char* __tsan_default_options() { return "die_after_fork=0"; }

// Qt's own hook for debuggers (private/qobject_p.h).
struct QSignalSpyCallbackSet {
  void (*signalBegin)(QObject* sender, int signal, void** arguments);
  void (*slotBegin)(QObject* receiver, int method, void** arguments);
  void (*signalEnd)(QObject* sender, int signal);
  void (*slotEnd)(QObject* receiver, int method);
};
Q_CORE_EXPORT void qt_register_signal_spy_callbacks(QSignalSpyCallbackSet* callbacks);

namespace {

char emitted;

QSignalSpyCallbackSet spy{
    [](QObject*, int, void**) { __tsan_release(&emitted); },
    nullptr,
    nullptr,
    nullptr,
};

// Before each event of any thread. The event itself is not looked at: reading it would be the first race.
bool received(void**) {
  __tsan_acquire(QThread::currentThread());
  __tsan_acquire(&emitted);
  return false;  // the event goes on to its receiver
}

[[maybe_unused]] const bool hooked = [] {
  qt_register_signal_spy_callbacks(&spy);
  return QInternal::registerCallback(QInternal::EventNotifyCallback, received);
}();

// A call on its way to another thread. Whoever lets go of it last, poster or receiver, destroys it, and the count of
// its holders is Qt's own.
class Handed : public QtPrivate::QSlotObjectBase {
 public:
  explicit Handed(QSlotObjectBase* call) : QSlotObjectBase(run), m_call(call) {}

 private:
  static void run(int which, QSlotObjectBase* self, QObject* receiver, void** arguments, bool*) {
    auto* const handed = static_cast<Handed*>(self);
    __tsan_acquire(self);
    if (which == Call) {
      handed->m_call->call(receiver, arguments);
      __tsan_release(self);
    } else if (which == Destroy) {
      handed->m_call->destroyIfLastRef();
      delete handed;
    }
  }

  QSlotObjectBase* m_call;  // one of its references is this one's
};

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
  auto* const handed = new Handed(slot);
  __tsan_release(handed);
  return invoke(object, handed, type, result);
}

void QObject::deleteLater() {
  static const auto deletion = original<void (*)(QObject*)>("_ZN7QObject11deleteLaterEv");
  __tsan_release(thread());
  deletion(this);
}
