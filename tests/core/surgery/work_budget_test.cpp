// Surgery within a budget of work: what does not fit waits, and the same fits every time.
#include "core/work_budget.h"

#include "tests/core/surgery/adaptation_support.h"
#include "tests/support/catch.h"

using namespace handlebody;
using namespace handlebody::testing;

namespace {

struct Round {
  Mesh mesh{meridians(2, -0.02)};
  AdaptationResult result;
  std::size_t left = 0;

  explicit Round(std::size_t units) {
    WorkBudget work(units);
    AdaptationSettings settings;
    settings.work = &work;
    std::vector<unsigned char> touched;
    result = adaptOnce(mesh, intersections(mesh), settings, touched);
    left = work.left();
  }
};

bool sameFaces(const Mesh& a, const Mesh& b) {
  return std::equal(a.faces().begin(), a.faces().end(), b.faces().begin(), b.faces().end()) &&
         std::equal(a.positions().begin(), a.positions().end(), b.positions().begin(), b.positions().end());
}

constexpr std::size_t kPlenty = 1'000'000'000;

}  // namespace

TEST_CASE("a budget counts down to nothing and can be raised to a least") {
  WorkBudget work(10);
  work.spend(4);
  CHECK(work.left() == 6);
  work.spend(60);
  CHECK(work.isSpent());
  work.allowAtLeast(3);
  CHECK(work.left() == 3);
  CHECK(work.all() == 10);
}

TEST_CASE("places for which no work is left wait, and the mesh is as it was") {
  const Round plenty(kPlenty), none(0);
  REQUIRE(plenty.result.conflicts.empty());
  REQUIRE(plenty.result.events.size() >= 2);
  CHECK(none.result.events.empty());
  CHECK(none.result.conflicts.size() >= 2);
  for (const Conflict& t : none.result.conflicts) CHECK(t.waits);
  CHECK(sameFaces(none.mesh, Mesh(meridians(2, -0.02))));
}

TEST_CASE("what is done within a budget is the same every time, and more of it is done with more") {
  const std::size_t needed = kPlenty - Round(kPlenty).left;
  REQUIRE(needed > 1000);
  std::size_t last = 0;
  bool some = false;
  for (std::size_t part = 0; part <= 8; ++part) {
    const Round one(needed * part / 8 + 1), other(needed * part / 8 + 1);
    CHECK(sameFaces(one.mesh, other.mesh));
    CHECK(one.left == other.left);
    CHECK(one.result.events.size() >= last);
    last = one.result.events.size();
    some = some || (!one.result.events.empty() && !one.result.conflicts.empty());
  }
  CHECK(some);
}
