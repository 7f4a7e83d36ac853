#include "core/mesh/smaller_components.h"

#include "tests/support/catch.h"
#include "tests/support/mesh_zoo.h"

using namespace handlebody;

namespace {

constexpr double kLongest = 1;  // mm, of an edge: the margin is twice that
const Vec3 kPart(10, 0, 0);     // a ball of radius 1 beside one of radius 5 at the origin

//! A mesh of both, and what is known of it.
struct Scene {
  Mesh before{zoo::both(zoo::ball(5, Vec3(0, 0, 0)), zoo::ball(1, kPart))};
  Mesh mesh = before;
  VertexMarks touched = VertexMarks(static_cast<std::size_t>(before.vertexSlots()), 0);
  SmallerComponents smaller;

  Scene() { smaller.know(findComponents(before)); }
  int nearest(const Vec3& place) const {
    int best = 0;
    for (int v = 0; v < mesh.vertexSlots(); ++v)
      if ((mesh.position(v) - place).norm() < (mesh.position(best) - place).norm()) best = v;
    return best;
  }
  void move(int v, const Vec3& by) {
    mesh.setPosition(v, mesh.position(v) + by);
    touched[v] = 1;
  }
  bool areKnownAfter() {
    smaller.follow({before, mesh, touched, kLongest});
    return smaller.areKnown();
  }
};

}  // namespace

TEST_CASE("what moves far from the smaller components leaves them known") {
  Scene scene;
  CHECK(scene.areKnownAfter());
  scene.move(scene.nearest(Vec3(-5, 0, 0)), Vec3(-0.5, 0, 0));
  scene.move(scene.nearest(Vec3(5, 0, 0)), Vec3(0.5, 0, 0));  // 3.5 mm before the other
  CHECK(scene.areKnownAfter());
}

TEST_CASE("a smaller component that moves is not known any more") {
  Scene scene;
  scene.move(scene.nearest(kPart), Vec3(0.01, 0, 0));
  CHECK_FALSE(scene.areKnownAfter());
}

TEST_CASE("a smaller component that something comes near, or that is passed, is not known any more") {
  Scene near, passed, made;
  near.move(near.nearest(Vec3(5, 0, 0)), Vec3(2.5, 0, 0));
  CHECK_FALSE(near.areKnownAfter());
  passed.move(passed.nearest(Vec3(5, 0, 0)), Vec3(20, 0, 0));  // it comes to rest far behind
  CHECK_FALSE(passed.areKnownAfter());
  const int fresh = made.mesh.addVertex(kPart + Vec3(0, 2, 0));
  made.touched.resize(static_cast<std::size_t>(fresh) + 1, 1);
  CHECK_FALSE(made.areKnownAfter());
}

TEST_CASE("of a single component there is nothing to come near, and nothing is known unless it was told") {
  const Mesh mesh(zoo::ball(5, Vec3(0, 0, 0)));
  const VertexMarks all(static_cast<std::size_t>(mesh.vertexSlots()), 1);
  SmallerComponents smaller;
  CHECK_FALSE(smaller.areKnown());
  smaller.know(findComponents(mesh));
  smaller.follow({mesh, mesh, all, kLongest});
  CHECK(smaller.areKnown());
  smaller.forget();
  CHECK_FALSE(smaller.areKnown());
}
