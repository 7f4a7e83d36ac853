#include "core/mesh/topology.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace handlebody {

namespace {

//! The vertices reached from v, v first.
std::vector<int> flood(const Mesh& mesh, int v, std::vector<int>& label, int value) {
  std::vector<int> reached{v};
  label[static_cast<std::size_t>(v)] = value;
  for (std::size_t i = 0; i < reached.size(); ++i)
    mesh.forEachNeighbour(reached[i], [&](int w) {
      if (label[static_cast<std::size_t>(w)] == value) return;
      label[static_cast<std::size_t>(w)] = value;
      reached.push_back(w);
    });
  return reached;
}

}  // namespace

Components findComponents(const Mesh& mesh) {
  Components c;
  c.ofVertex.assign(static_cast<std::size_t>(mesh.vertexSlots()), -1);
  for (int v = 0; v < mesh.vertexSlots(); ++v) {
    if (!mesh.isVertex(v) || c.ofVertex[static_cast<std::size_t>(v)] >= 0) continue;
    const std::vector<int> part = flood(mesh, v, c.ofVertex, c.count());
    Eigen::AlignedBox3d box;
    for (int w : part) box.extend(mesh.position(w));
    c.vertices.push_back(static_cast<int>(part.size()));
    c.extent.push_back(box.sizes().maxCoeff());
  }
  c.faces.assign(c.vertices.size(), 0);
  c.volume.assign(c.vertices.size(), 0);
  for (int f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isFace(f)) continue;
    const auto part = static_cast<std::size_t>(c.ofVertex[static_cast<std::size_t>(mesh.face(f)[0])]);
    ++c.faces[part];
    c.volume[part] += mesh.position(mesh.face(f)[0]).dot(mesh.areaVector(f)) / 6;
  }
  return c;
}

void deleteComponent(Mesh& mesh, int v) {
  std::vector<int> label(static_cast<std::size_t>(mesh.vertexSlots()), 0);
  const std::vector<int> part = flood(mesh, v, label, 1);
  std::vector<int> faces;
  for (int w : part) mesh.forEachOutgoing(w, [&](int h) { faces.push_back(Mesh::faceOf(h)); });
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  mesh.removeFaces(faces);
  for (int w : part) mesh.removeVertex(w);
}

}  // namespace handlebody
