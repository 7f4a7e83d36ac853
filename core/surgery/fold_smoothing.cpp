#include "core/surgery/fold_smoothing.h"

#include <algorithm>
#include <optional>

#include "core/indices.h"
#include "core/surgery/closing.h"
#include "core/surgery/opening.h"

namespace handlebody {

namespace {

// Taubin's factors: pass band 1/lambda + 1/mu = 0.1 (the value of his paper), five pairs a pass.
constexpr double kLambda = 0.5;
constexpr double kMu = -0.526;
constexpr int kPairs = 5;
constexpr double kAbout = 0.1;  // of the size of the place: it hardly swells

void laplacianStep(Mesh& mesh, const std::vector<int>& vertices, double factor) {
  std::vector<Vec3> fresh;
  for (int v : vertices) {
    Vec3 sum(0, 0, 0);
    double n = 0;
    mesh.forEachNeighbour(v, [&](int w) {
      sum += mesh.position(w);
      n += 1;
    });
    fresh.push_back(mesh.position(v) + factor * (sum / n - mesh.position(v)));
  }
  for (std::size_t i = 0; i < vertices.size(); ++i) mesh.setPosition(vertices[i], fresh[i]);
}

std::vector<int> cornersOf(const Mesh& mesh, const std::vector<int>& faces) {
  std::vector<int> corners;
  for (int f : faces) corners.insert(corners.end(), mesh.face(f).begin(), mesh.face(f).end());
  sortUnique(corners);
  return corners;
}

double sizeOf(const Mesh& mesh, const std::vector<int>& vertices) {
  Eigen::AlignedBox3d box;
  for (int v : vertices) box.extend(mesh.position(v));
  return box.sizes().maxCoeff();
}

}  // namespace

bool smoothFold(Mesh& mesh, FaceBlocks& blocks, const std::vector<int>& lambda, FaceMarkSpan ignored,
                const Forbidden& forbidden, VertexMarks& touched) {
  std::vector<int> vertices = enlarge(mesh, lambda);
  std::erase_if(vertices, [&](int v) { return forbidden.isPinned(v); });
  if (vertices.empty()) return false;
  std::vector<Vec3> old;
  for (int v : vertices) old.push_back(mesh.position(v));
  Opening moved;  // the faces that move, as if they were taken out
  moved.lambda = vertices;
  for (int v : vertices) mesh.forEachOutgoing(v, [&](int h) { moved.faces.push_back(Mesh::faceOf(h)); });
  sortUnique(moved.faces);
  moved.loops.push_back(cornersOf(mesh, moved.faces));  // what lies near any of them may be hit
  Patch patch;
  patch.firstNew = mesh.vertexSlots();
  for (int f : moved.faces) patch.faces.push_back(mesh.face(f));
  const std::span<const Opening> one(&moved, 1);
  const Replaced unmoved(mesh, one, forbidden);
  const double about = kAbout * sizeOf(mesh, moved.loops[0]);
  std::optional<Surroundings> surroundings;
  for (int pass = 0; pass < kFoldPasses; ++pass) {
    for (int i = 0; i < kPairs; ++i) {
      laplacianStep(mesh, vertices, kLambda);
      laplacianStep(mesh, vertices, kMu);
    }
    if (!surroundings || !surroundings->reach(patch))
      surroundings.emplace(mesh, blocks, one, ignored, forbidden, about);
    if (surroundings->fits(patch) && !unmoved.sweepsOver(mesh, patch)) {
      blocks.includeAround(mesh, vertices);
      touched.resize(mesh.vertexSlots(), 0);
      for (int v : vertices) touched[v] = 1;
      return true;
    }
  }
  for (std::size_t i = 0; i < vertices.size(); ++i) mesh.setPosition(vertices[i], old[i]);
  return false;
}

}  // namespace handlebody
