#include "core/threads.h"

#include <array>
#include <atomic>
#include <stdexcept>
#include <thread>

#include "tests/support/catch.h"

using namespace handlebody;

TEST_CASE("each piece of work is done once, with any number of threads") {
  for (const int threads : {-1, 1, 3, 50}) {
    std::array<std::atomic<int>, 40> calls{};
    forEachOnThreads(calls.size(), threads, [&](std::size_t i) { ++calls[i]; });
    for (const auto& c : calls) CHECK(c == 1);
  }
  forEachOnThreads(0, 4, [](std::size_t) { FAIL("there is nothing to do"); });
}

TEST_CASE("ranges cover all once, and none is smaller than it pays") {
  for (const int threads : {-1, 1, 3, 50})
    for (const std::size_t n : {1, 9, 10, 39, 40}) {
      std::array<std::atomic<int>, 40> calls{};
      std::atomic<int> small{0}, ranges{0};
      forRangesOnThreads(n, threads, 10, [&](std::size_t from, std::size_t to) {
        ++ranges;
        small += to - from < 10;
        for (std::size_t i = from; i < to; ++i) ++calls[i];
      });
      for (std::size_t i = 0; i < calls.size(); ++i) CHECK(calls[i] == (i < n ? 1 : 0));
      CHECK((n < 10 ? ranges == 1 : small == 0));
    }
}

TEST_CASE("no number of threads asks for all that there are") {
  CHECK(threadCount(3) == 3);
  CHECK(threadCount(0) == static_cast<int>(std::thread::hardware_concurrency()));
}

TEST_CASE("what a piece of work throws arrives, whichever thread it was on") {
  for (const int threads : {1, 4})
    for (const std::size_t bad : {0, 17, 39})
      CHECK_THROWS_AS(forEachOnThreads(40, threads,
                                       [&](std::size_t i) {
                                         if (i == bad) throw std::runtime_error("bad");
                                       }),
                      std::runtime_error);
}

TEST_CASE("every thread that helps is cancelled") {
  const std::atomic<bool> cancelled{true};
  const CancelScope scope(cancelled);
  std::atomic<int> done{0};
  CHECK_THROWS_AS(forEachOnThreads(100, 4,
                                   [&](std::size_t) {
                                     giveUpIfCancelled();
                                     ++done;
                                   }),
                  Cancelled);
  CHECK(done == 0);
}

TEST_CASE("work that is not to be cancelled is not, on any thread, though what it is a part of is") {
  const std::atomic<bool> cancelled{true};
  const CancelScope scope(cancelled);
  {
    const CancelScope never(nullptr);
    CHECK_NOTHROW(forEachOnThreads(100, 4, [](std::size_t) { giveUpIfCancelled(); }));
  }
  CHECK_THROWS_AS(giveUpIfCancelled(), Cancelled);
}
