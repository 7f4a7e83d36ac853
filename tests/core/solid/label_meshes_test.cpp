// Several objects of one label map become meshes together.

#include "core/collision/body_contact.h"
#include "core/collision/certify.h"
#include "core/solid/label_mesh.h"
#include "core/solid/rasterize.h"
#include "tests/core/solid/voxel_topology.h"
#include "tests/support/catch.h"

using namespace handlebody;
using namespace handlebody::testing;

namespace {

//! Every voxel of a box has one of the labels 1 … `count` or none: blobs that touch each other.
std::vector<Mask> touching(unsigned seed, int count, int n) {
  std::mt19937 random(seed);
  const auto any = [&](int end) { return static_cast<int>(random() % static_cast<unsigned>(end)); };
  Mask labels;
  labels.grid.size = {n, n, n};
  labels.grid.spacing = seed % 2 == 0 ? Vec3(1, 1, 1) : Vec3(0.7, 0.9, 2.5);
  labels.inside.assign(static_cast<std::size_t>(n * n * n), 0);
  for (int i = 0; i < 4 * count; ++i) {
    const Vec3 centre(any(n), any(n), any(n));
    const double radius = 1 + 0.4 * any(8);
    for (int z = 0; z < n; ++z)
      for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x)
          if ((Vec3(x, y, z) - centre).norm() <= radius)
            labels.inside[labels.at(x, y, z)] = static_cast<std::uint8_t>(i % (count + 1));
  }
  std::vector<Mask> masks;
  for (int label = 1; label <= count; ++label) {
    Mask mask = labels;
    for (auto& v : mask.inside) v = v == label ? 1 : 0;
    if (mask.count() > 0) masks.push_back(std::move(mask));
  }
  return masks;
}

void requireApart(const std::vector<LabelMesh>& made) {
  for (std::size_t j = 1; j < made.size(); ++j)
    for (std::size_t i = 0; i < j; ++i) REQUIRE(bodyContact(made[i].mesh, made[j].mesh) == BodyContact::none);
}

//! Voxels (of `mask`) whose centres lie on the other side of the mesh than the mask says, as a part of it.
double wrongVoxels(const Mask& mask, const TriangleSoup& mesh) {
  const Volume drawn = rasterize(mesh, mask.grid);
  const auto* in = drawn.data<std::uint8_t>();
  double wrong = 0;
  for (std::size_t i = 0; i < mask.inside.size(); ++i) wrong += (in[i] != 0) != (mask.inside[i] != 0);
  return wrong / static_cast<double>(mask.count());
}

}  // namespace

TEST_CASE("labels that touch become certified meshes that do not meet, each with its own topology",
          "[solid][label-meshes]") {
  for (unsigned seed = 0; seed < 24; ++seed) {
    INFO(seed);
    const std::vector<Mask> masks = touching(seed, 2 + static_cast<int>(seed % 4), 11);
    const std::vector<LabelMesh> made = meshesOf(masks, {});
    REQUIRE(made.size() == masks.size());
    requireApart(made);
    for (std::size_t i = 0; i < made.size(); ++i) {
      const VoxelTopology counted = voxelTopology(masks[i]);
      const Certificate c = certify(made[i].mesh);
      REQUIRE(c.boundsBody());
      REQUIRE(c.cavities == counted.cavities);
      REQUIRE(c.components == counted.components + counted.cavities);
      REQUIRE(tunnelsOf(c) == counted.tunnels);
      REQUIRE(made[i].farthest <= kMaxApart);
    }
  }
}

TEST_CASE("an object within the cavity of another becomes a mesh within its mesh", "[solid][label-meshes]") {
  Mask shell;
  shell.grid.size = {21, 21, 21};
  Mask core = shell;
  for (int z = 0; z < 21; ++z)
    for (int y = 0; y < 21; ++y)
      for (int x = 0; x < 21; ++x) {
        const double r = (Vec3(x, y, z) - Vec3(10, 10, 10)).norm();
        shell.inside.push_back(r < 8 && r >= 4.5 ? 1 : 0);
        core.inside.push_back(r < 4.5 ? 1 : 0);
      }
  const std::vector<LabelMesh> made = meshesOf({shell, core}, {});
  requireApart(made);
  CHECK(made[0].certificate.cavities == 1);
  CHECK(made[1].certificate.components == 1);
  // What a gap of a fifth of a voxel may cost besides what smoothing does.
  const std::vector<Mask> masks{shell, core};
  for (std::size_t i = 0; i < 2; ++i) {
    const Certificate& c = made[i].certificate;
    CHECK(wrongVoxels(masks[i], made[i].mesh) <
          wrongVoxels(masks[i], meshOf(masks[i], {}).mesh) + 0.2 * c.area / c.volume);
  }
}

TEST_CASE("one label alone is the mesh that it is without others", "[solid][label-meshes]") {
  const std::vector<Mask> masks = touching(3, 1, 12);
  REQUIRE(masks.size() == 1);
  const LabelMesh alone = meshOf(masks[0], {});
  const LabelMesh first = meshesOf(masks, {})[0];
  CHECK(first.mesh.triangles == alone.mesh.triangles);
  CHECK(first.mesh.points == alone.mesh.points);
}
