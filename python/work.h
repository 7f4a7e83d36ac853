#pragma once
// Long work that Python waits for.

#include <functional>
#include <mutex>

namespace handlebody::python {

//! Calls `work` without the interpreter's lock, on a thread of its own, and returns when it has ended; what
//! it throws is thrown here. Meanwhile this thread looks for signals: where one of their handlers raises
//! (KeyboardInterrupt), the work is cancelled as by a CancelScope, and the handler's exception is thrown once
//! it has ended. Precondition: the caller holds the lock; `work` touches nothing of Python.
void withoutLock(const std::function<void()>& work);

//! Readers and writers of files are not for several threads at once. To be locked within the work.
std::mutex& filesMutex();

}  // namespace handlebody::python
