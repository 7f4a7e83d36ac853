#include "core/evolution/restraints.h"

#include "tests/support/catch.h"
#include "tests/support/mesh_zoo.h"

using namespace handlebody;

namespace {

//! A sphere, of which the first vertex is pinned.
struct Pinned {
  Mesh mesh{zoo::sphere(4)};
  Restraints locked;
  Pinned() {
    locked.pins.choose({{mesh.position(0), 1e-3, 0}}, 0);
    locked.pins.take(mesh, 0);
  }
};

Conflict conflictAt(const Vec3& place, bool atPin) {
  Conflict t{place, 0.1, FindingKind::stillIntersects};
  t.atPin = atPin;
  return t;
}

}  // namespace

TEST_CASE("what fails rests for a while, what comes to a pin stops before it") {
  Pinned p;
  const Vec3 top = p.mesh.position(0);
  CHECK(p.locked.isHeld(p.mesh, 0));
  p.locked.lock(conflictAt(top, false), p.mesh, 0.3, 1, 5);
  CHECK(p.locked.regions.isLocked(top, 5));
  CHECK_FALSE(p.locked.pins.isLocked(top));
  Restraints atPin = Pinned().locked;
  atPin.lock(conflictAt(top, true), p.mesh, 0.3, 1, 5);
  CHECK_FALSE(atPin.regions.isLocked(top, 5));
  CHECK(atPin.pins.isLocked(top));
  CHECK(atPin.pins.list()[0].stops == 1);
}

TEST_CASE("where edges are longer, more around a place rests") {
  const Pinned p;
  const Vec3 place(5, 0, 0);
  const auto restsAt = [&](double size, double away) {
    Restraints locked;
    locked.lock(conflictAt(place, false), p.mesh, 0.3, size, 1);
    return locked.regions.isLocked(place + Vec3(away, 0, 0), 1);
  };
  CHECK(restsAt(1, 0.2));
  CHECK_FALSE(restsAt(1, 0.4));
  CHECK(restsAt(2, 0.4));
}

TEST_CASE("a step that is cancelled locks nothing") {
  Pinned p;
  const Vec3 top = p.mesh.position(0);
  p.locked.lock(conflictAt(Vec3(5, 0, 0), false), p.mesh, 0.3, 1, 1);
  const Restraints before = p.locked;
  p.locked.lock(conflictAt(top, false), p.mesh, 0.3, 1, 2);
  p.locked.lock(conflictAt(top, true), p.mesh, 0.3, 1, 2);
  p.locked.takeBack(before);
  CHECK_FALSE(p.locked.regions.isLocked(top, 2));
  CHECK_FALSE(p.locked.pins.isLocked(top));
  CHECK(p.locked.pins.list()[0].stops == 0);
  CHECK(p.locked.regions.isLocked(Vec3(5, 0, 0), 1));
  CHECK(p.locked.pins.holds(0));
}

TEST_CASE("after other forces what was rolled back moves again, and what is pinned stays") {
  Pinned p;
  const Vec3 top = p.mesh.position(0);
  p.locked.lock(conflictAt(top, false), p.mesh, 0.3, 1, 1);
  p.locked.lock(conflictAt(top, true), p.mesh, 0.3, 1, 1);
  p.locked.forgetRollbacks();
  CHECK_FALSE(p.locked.regions.any(1));
  CHECK_FALSE(p.locked.pins.isLocked(top));
  CHECK(p.locked.isHeld(p.mesh, 0));
  CHECK_FALSE(p.locked.isHeld(p.mesh, 1));
}
