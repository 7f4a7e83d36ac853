#include "core/surgery/local_smoothing.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <vector>

#include "core/indices.h"
#include "core/mesh/marks.h"

namespace handlebody {

namespace {

// Taubin's factors: pass band 1/lambda + 1/mu = 0.1 (the value of his paper).
constexpr double kLambda = 0.5;
constexpr double kMu = -0.526;
constexpr int kPairs = 15;
constexpr int kVolumeSteps = 6;  // of Newton's method, on a polynomial of third degree
// Parts of the smoothing that are tried.
constexpr std::array<double, 4> kParts{1, 0.5, 0.25, 0.1};

struct WeightedVertex {
  int vertex;
  double weight;  // 0 … 1
};

std::vector<WeightedVertex> verticesIn(const Mesh& mesh, const Vec3& centre, double radius) {
  std::vector<WeightedVertex> out;
  for (int v = 0; v < mesh.vertexSlots(); ++v) {
    if (!mesh.isVertex(v)) continue;
    const double t = (mesh.position(v) - centre).norm() / radius;
    if (t < 1) out.push_back({v, (1 - t * t) * (1 - t * t)});
  }
  return out;
}

void laplacianStep(Mesh& mesh, const std::vector<WeightedVertex>& vertices, double factor) {
  std::vector<Vec3> fresh;
  for (const auto& [v, weight] : vertices) {
    Vec3 sum(0, 0, 0);
    double n = 0;
    mesh.forEachNeighbour(v, [&](int w) {
      sum += mesh.position(w);
      n += 1;
    });
    fresh.push_back(mesh.position(v) + factor * weight * (sum / n - mesh.position(v)));
  }
  for (std::size_t i = 0; i < vertices.size(); ++i) mesh.setPosition(vertices[i].vertex, fresh[i]);
}

//! Six times the derivative of the enclosed volume by the vertex's place.
Vec3 areaAround(const Mesh& mesh, int v) {
  Vec3 sum(0, 0, 0);
  mesh.forEachOutgoing(v, [&](int h) { sum += mesh.areaVector(Mesh::faceOf(h)); });
  return sum;
}

//! Six times the volume between a place and the faces around the vertices, each counted once.
double volumeOver(const Mesh& mesh, const std::vector<int>& faces, const Vec3& origin) {
  double sum = 0;
  for (const int f : faces) {
    const Triangle& t = mesh.face(f);
    sum += (mesh.position(t[0]) - origin)
               .dot((mesh.position(t[1]) - origin).cross(mesh.position(t[2]) - origin));
  }
  return sum;
}

std::vector<int> facesAround(const Mesh& mesh, const std::vector<WeightedVertex>& vertices) {
  FaceMarks isThere(idx(mesh.faceSlots()), 0);
  for (const WeightedVertex& w : vertices)
    mesh.forEachOutgoing(w.vertex, [&](int h) { isThere[Mesh::faceOf(h)] = 1; });
  std::vector<int> faces;
  for (int f = 0; f < mesh.faceSlots(); ++f)
    if (isThere[f] != 0) faces.push_back(f);
  return faces;
}

//! Moves the vertices along their normals, each by its weight, until the volume is right.
void restoreVolume(Mesh& mesh, const std::vector<WeightedVertex>& vertices, const std::vector<int>& faces,
                   const Vec3& origin, double wanted) {
  for (int step = 0; step < kVolumeSteps; ++step) {
    std::vector<Vec3> direction;
    double slope = 0;
    for (const auto& [v, weight] : vertices) {
      const Vec3 area = areaAround(mesh, v);
      const double length = area.norm();
      direction.push_back(length > 0 ? Vec3(weight / length * area) : Vec3(0, 0, 0));
      slope += weight * length;
    }
    if (!(slope > 0)) return;
    const double by = (wanted - volumeOver(mesh, faces, origin)) / slope;
    for (std::size_t i = 0; i < vertices.size(); ++i)
      mesh.setPosition(vertices[i].vertex, mesh.position(vertices[i].vertex) + by * direction[i]);
  }
}

}  // namespace

TouchedMesh smoothedHere(const Mesh& mesh, const Vec3& centre, double radius) {
  const std::vector<WeightedVertex> vertices = verticesIn(mesh, centre, radius);
  if (vertices.empty()) return refused(mesh, FindingKind::noVertexInBall);
  const std::vector<int> faces = facesAround(mesh, vertices);
  const double wanted = volumeOver(mesh, faces, centre);
  Mesh smooth = mesh;
  for (int i = 0; i < kPairs; ++i) {
    laplacianStep(smooth, vertices, kLambda);
    laplacianStep(smooth, vertices, kMu);
  }
  TouchedMesh out;
  for (const double part : kParts) {
    Mesh some = mesh;
    for (const WeightedVertex& w : vertices)
      some.setPosition(
          w.vertex, mesh.position(w.vertex) + part * (smooth.position(w.vertex) - mesh.position(w.vertex)));
    restoreVolume(some, vertices, faces, centre, wanted);
    out = certifiedEdit(mesh, std::move(some));
    if (out.isDone()) return out;
  }
  return out;
}

}  // namespace handlebody
