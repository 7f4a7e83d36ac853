#include "core/mesh/topology.h"

#include <algorithm>
#include <numeric>

#include "core/indices.h"
#include "core/mesh/component_volume.h"
#include "core/mesh/union_find.h"

namespace handlebody {

namespace {

//! The vertices reached from v, v first.
std::vector<int> flood(const Mesh& mesh, int v, std::vector<int>& label, int value) {
  std::vector<int> reached{v};
  label[v] = value;
  for (std::size_t i = 0; i < reached.size(); ++i)
    mesh.forEachNeighbour(reached[i], [&](int w) {
      if (label[w] == value) return;
      label[w] = value;
      reached.push_back(w);
    });
  return reached;
}

//! Face by face, in the order of memory: far quicker than a walk from neighbour to neighbour.
UnionFind joinedByFaces(const Mesh& mesh) {
  std::vector<int> lower(mesh.vertexSlots());
  std::iota(lower.begin(), lower.end(), 0);
  for (const Triangle& t : mesh.faces()) {
    if (t[0] < 0) continue;
    const int lowest = std::min({t[0], t[1], t[2]});
    for (const int v : t) {
      int& l = lower[v];
      l = std::min(l, lowest);
    }
  }
  UnionFind parts(std::move(lower));
  for (const Triangle& t : mesh.faces()) {
    if (t[0] < 0) continue;
    parts.join(t[0], t[1]);
    parts.join(t[0], t[2]);
  }
  return parts;
}

}  // namespace

int countComponents(const Mesh& mesh, std::span<const int> joined) {
  UnionFind parts = joinedByFaces(mesh);
  for (const int v : joined) parts.join(joined[0], v);
  int n = 0;
  for (int v = 0; v < mesh.vertexSlots(); ++v) n += mesh.isVertex(v) && parts.find(v) == v;
  return n;
}

TopologyNumbers topologyNumbers(const Mesh& mesh) {
  TopologyNumbers n;
  n.components = countComponents(mesh);
  n.euler = mesh.vertexCount() - mesh.faceCount() / 2;  // E = 3F / 2 on a closed mesh
  n.genus = (2 * n.components - n.euler) / 2;
  return n;
}

Components findComponents(const Mesh& mesh) {
  UnionFind parts = joinedByFaces(mesh);
  Components c;
  c.ofVertex.assign(idx(mesh.vertexSlots()), -1);
  std::vector<int> first;
  for (int v = 0; v < mesh.vertexSlots(); ++v) {
    if (!mesh.isVertex(v)) continue;
    const int lowest = parts.find(v);
    if (lowest == v) {
      c.ofVertex[v] = c.count();
      c.vertices.push_back(0);
      c.box.emplace_back();
      first.push_back(v);
    }
    const int part = c.ofVertex[v] = c.ofVertex[lowest];
    ++c.vertices[part];
    c.box[part].extend(mesh.position(v));
  }
  for (const auto& box : c.box) c.extent.push_back(box.sizes().maxCoeff());
  c.faces.assign(c.vertices.size(), 0);
  c.volume.assign(c.vertices.size(), 0);
  for (int f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isFace(f)) continue;
    const Triangle& t = mesh.face(f);
    const int part = c.ofVertex[t[0]];
    ++c.faces[part];
    c.volume[part] +=
        volumeTerm(mesh.position(first[part]), mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2]));
  }
  return c;
}

double signedVolume(const Mesh& mesh) {
  double volume = 0;
  for (const Triangle& t : mesh.faces()) {
    if (t[0] < 0) continue;
    const Vec3 &a = mesh.position(t[0]), &b = mesh.position(t[1]), &c = mesh.position(t[2]);
    volume += a.dot((b - a).cross(c - a)) / 6;
  }
  return volume;
}

void deleteComponent(Mesh& mesh, int v) {
  std::vector<int> label(mesh.vertexSlots(), 0);
  const std::vector<int> part = flood(mesh, v, label, 1);
  std::vector<int> faces;
  for (int w : part) mesh.forEachOutgoing(w, [&](int h) { faces.push_back(Mesh::faceOf(h)); });
  sortUnique(faces);
  mesh.removeFaces(faces);
  for (int w : part) mesh.removeVertex(w);
}

}  // namespace handlebody
