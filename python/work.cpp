#include "python/work.h"

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <exception>
#include <future>
#include <optional>
#include <thread>

#include "core/cancellation.h"

namespace handlebody::python {

namespace py = pybind11;

namespace {

constexpr std::chrono::milliseconds kBetweenLooks{30};

//! What a handler raised, if one did.
std::optional<py::error_already_set> raisedBySignal() {
  const py::gil_scoped_acquire lock;
  if (PyErr_CheckSignals() == 0) return std::nullopt;
  return py::error_already_set();
}

}  // namespace

void withoutLock(const std::function<void()>& work) {
  std::atomic<bool> cancelled{false};
  std::optional<py::error_already_set> raised;
  {
    const py::gil_scoped_release unlocked;
    std::future<void> end = std::async(std::launch::async, [&] {
      const CancelScope scope(cancelled);
      work();
    });
    while (end.wait_for(kBetweenLooks) != std::future_status::ready && !raised)
      if (raised = raisedBySignal(); raised) cancelled = true;
    if (!raised) return end.get();
    end.wait();
  }
  throw std::move(*raised);
}

std::mutex& filesMutex() {
  static std::mutex mutex;
  return mutex;
}

}  // namespace handlebody::python
