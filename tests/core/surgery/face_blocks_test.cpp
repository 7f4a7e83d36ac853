#include "core/surgery/face_blocks.h"

#include <random>
#include <set>

#include "tests/support/catch.h"
#include "tests/support/mesh_zoo.h"

using namespace handlebody;

namespace {

Eigen::AlignedBox3d boxOf(const Mesh& mesh, int f) {
  Eigen::AlignedBox3d box;
  for (const int v : mesh.face(f)) box.extend(mesh.position(v));
  return box;
}

//! No face that meets the box is left out, and none comes twice.
void expectAllFound(const Mesh& mesh, const FaceBlocks& blocks, const Eigen::AlignedBox3d& box) {
  std::vector<int> listed;
  blocks.forEachNear(mesh, box, [&](int f) { listed.push_back(f); });
  const std::set<int> found(listed.begin(), listed.end());
  CHECK(found.size() == listed.size());
  for (int f = 0; f < mesh.faceSlots(); ++f)
    if (mesh.isFace(f) && boxOf(mesh, f).intersects(box)) CHECK(found.count(f) == 1);
}

}  // namespace

TEST_CASE("blocks know every face near a place, also after it has moved or was made") {
  const bool isSorted = GENERATE(false, true);
  Mesh mesh(zoo::sphere(12));
  FaceBlocks blocks(mesh);
  if (isSorted) blocks.sortByPlace(mesh);
  std::mt19937 random(3);
  const auto uniform = [&] { return 2 * static_cast<double>(random()) / 4294967296.0 - 1; };
  for (int round = 0; round < 40; ++round) {
    const int v = static_cast<int>(random() % static_cast<unsigned>(mesh.vertexSlots()));
    const double x = uniform(), y = uniform();
    mesh.setPosition(v, mesh.position(v) + 2 * Vec3(x, y, uniform()));
    std::vector<int> changed{v};
    if (round % 4 == 0) changed.push_back(mesh.splitEdge(mesh.outgoing(v), 3 * mesh.position(v)));
    blocks.includeAround(mesh, changed);
    const double a = uniform(), b = uniform();
    const Vec3 middle(a, b, uniform());
    expectAllFound(mesh, blocks, {middle - Vec3::Constant(0.2), middle + Vec3::Constant(0.2)});
  }
}

TEST_CASE("blocks leave out most of a large mesh in order") {
  const Mesh mesh(zoo::sphere(40));
  const FaceBlocks blocks(mesh);
  int listed = 0;
  const Vec3 place = mesh.position(0);
  blocks.forEachNear(mesh, {place - Vec3::Constant(0.01), place + Vec3::Constant(0.01)},
                     [&](int) { ++listed; });
  CHECK(listed > 0);
  CHECK(listed < mesh.faceCount() / 4);
}

TEST_CASE("blocks that are sorted by place leave out most of a mesh whose faces lie anywhere in memory") {
  TriangleSoup soup = zoo::sphere(40);
  std::shuffle(soup.triangles.begin(), soup.triangles.end(), std::mt19937(5));
  const Mesh mesh(soup);
  FaceBlocks blocks(mesh);
  blocks.sortByPlace(mesh);
  int listed = 0;
  const Vec3 place = mesh.position(0);
  const Eigen::AlignedBox3d box(place - Vec3::Constant(0.01), place + Vec3::Constant(0.01));
  blocks.forEachNear(mesh, box, [&](int) { ++listed; });
  CHECK(listed > 0);
  CHECK(listed < mesh.faceCount() / 20);
  expectAllFound(mesh, blocks, box);
}
