#include "core/mesh/surface_volume.h"

#include <random>

#include "core/indices.h"
#include "core/mesh/topology.h"
#include "tests/support/catch.h"
#include "tests/support/mesh_zoo.h"

using namespace handlebody;

namespace {

VertexMarks marks(const Mesh& mesh, unsigned char value) {
  return VertexMarks(idx(mesh.vertexSlots()), value);
}

}  // namespace

TEST_CASE("the volume that is followed is that of the whole mesh, bit for bit") {
  Mesh mesh(zoo::sphere(6));
  SurfaceVolume volume;
  CHECK(volume.follow(mesh, marks(mesh, 0)) == signedVolume(mesh));  // nothing is known yet: all is computed
  std::mt19937 random(1);
  for (int step = 0; step < 50; ++step) {
    VertexMarks touched = marks(mesh, 0);
    for (int n = 0; n < 10; ++n) {
      const int v = static_cast<int>(random() % static_cast<unsigned>(mesh.vertexSlots()));
      mesh.setPosition(v, mesh.position(v) * (0.9 + 0.01 * n));
      touched[idx(v)] = 1;
    }
    CHECK(volume.follow(mesh, touched) == signedVolume(mesh));
  }
}

TEST_CASE("faces that are gone and new ones count as they are") {
  Mesh mesh(zoo::both(zoo::sphere(4), zoo::moved(zoo::sphere(4), Vec3(5, 0, 0))));
  SurfaceVolume volume;
  volume.follow(mesh, marks(mesh, 0));
  deleteComponent(mesh, mesh.face(0)[0]);
  CHECK(volume.follow(mesh, marks(mesh, 0)) == signedVolume(mesh));
  CHECK(signedVolume(mesh) > 0);
}

TEST_CASE("what has moved without a mark is not seen until all is forgotten") {
  Mesh mesh(zoo::sphere(4));
  SurfaceVolume volume;
  const double before = volume.follow(mesh, marks(mesh, 0));
  mesh.setPosition(0, mesh.position(0) * 2);
  CHECK(volume.follow(mesh, marks(mesh, 0)) == before);
  volume.forget();
  CHECK(volume.follow(mesh, marks(mesh, 0)) == signedVolume(mesh));
}
