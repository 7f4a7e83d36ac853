#include "core/threads.h"

#include <array>
#include <atomic>
#include <chrono>
#include <future>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

#include "core/cancellation.h"
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

TEST_CASE("several threads do the work") {
  std::set<std::thread::id> who;
  std::mutex guard;
  std::atomic<int> arrived{0};
  forEachOnThreads(3, 3, [&](std::size_t) {
    {
      const std::lock_guard lock(guard);
      who.insert(std::this_thread::get_id());
    }
    ++arrived;
    while (arrived < 3) std::this_thread::yield();  // each waits for the others
  });
  CHECK(who.size() == 3);
}

TEST_CASE("work within work, from many threads at the same time, is done once") {
  std::atomic<int> calls{0};
  std::vector<std::future<void>> callers;
  for (int c = 0; c < 6; ++c)
    callers.push_back(std::async(std::launch::async, [&] {
      for (int again = 0; again < 50; ++again)
        forEachOnThreads(5, 3, [&](std::size_t) { forEachOnThreads(7, 4, [&](std::size_t) { ++calls; }); });
    }));
  for (std::future<void>& c : callers) c.get();
  CHECK(calls == 6 * 50 * 5 * 7);
}

TEST_CASE("who finds all helpers busy does the work alone, and waits for none of them") {
  using namespace std::chrono_literals;
  std::atomic<bool> release{false};
  std::atomic<int> busy{0};
  // As many pieces that do not end as there can be helpers, whatever other cases have asked for.
  constexpr int kThreads = 64;
  auto others = std::async(std::launch::async, [&] {
    forEachOnThreads(kThreads, kThreads, [&](std::size_t) {
      ++busy;
      while (!release) std::this_thread::sleep_for(1ms);
    });
  });
  while (busy < kThreads) std::this_thread::sleep_for(1ms);
  auto alone = std::async(std::launch::async, [] {
    int calls = 0;  // of one thread only
    forEachOnThreads(100, kThreads, [&](std::size_t) { ++calls; });
    return calls;
  });
  const bool ended = alone.wait_for(20s) == std::future_status::ready;
  release = true;
  REQUIRE(ended);
  CHECK(alone.get() == 100);
  others.get();
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
