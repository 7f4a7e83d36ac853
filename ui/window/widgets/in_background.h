#pragma once
// Work off the GUI thread whose result is wanted by an object that may be gone by then.

#include <QCoreApplication>
#include <QPointer>
#include <QThreadPool>
#include <utility>

namespace handlebody::ui {

//! Runs work() on a worker thread, then done(result) on the GUI thread if `receiver` still lives.
//! Precondition: called on the GUI thread; work() throws nothing.
template <typename Work, typename Done>
void inBackground(QObject* receiver, Work work, Done done) {
  QThreadPool::globalInstance()->start(
      [guard = QPointer<QObject>(receiver), work = std::move(work), done = std::move(done)]() mutable {
        auto result = work();
        // The application outlives the worker's message, and asks on its own thread whether the receiver
        // does, too.
        QMetaObject::invokeMethod(
            QCoreApplication::instance(),
            [guard = std::move(guard), done = std::move(done), result = std::move(result)]() mutable {
              if (guard) done(std::move(result));
            },
            Qt::QueuedConnection);
      });
}

}  // namespace handlebody::ui
