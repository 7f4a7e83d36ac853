#include "core/mesh/pieces.h"

#include <Eigen/Geometry>
#include <cmath>

#include "core/mesh/containment.h"

namespace handlebody {

std::vector<Piece> listPieces(const Mesh& mesh) {
  const Components parts = findComponents(mesh);
  const std::vector<int> within = surroundingComponents(mesh, parts);
  std::vector<Eigen::AlignedBox3d> boxes(within.size());
  for (int v = 0; v < mesh.vertexSlots(); ++v)
    if (mesh.isVertex(v)) boxes[parts.ofVertex[v]].extend(mesh.position(v));
  std::vector<Piece> out;
  for (std::size_t c = 0; c < within.size(); ++c) {
    Piece p;
    p.isCavity = parts.volume[c] < 0;
    p.volume = std::abs(parts.volume[c]);
    p.size = boxes[c].sizes();
    p.centre = boxes[c].center();
    p.vertices = parts.vertices[c];
    p.genus = 1 - (parts.vertices[c] - parts.faces[c] / 2) / 2;
    p.within = within[c];
    out.push_back(p);
  }
  return out;
}

TriangleSoup withoutLoosePoints(const TriangleSoup& soup) {
  std::vector<int> number(soup.points.size(), -1);
  for (const Triangle& t : soup.triangles)
    for (const int v : t) number[v] = 0;
  TriangleSoup out;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] < 0) continue;
    number[v] = static_cast<int>(out.points.size());
    out.points.push_back(soup.points[v]);
  }
  for (Triangle t : soup.triangles) {
    for (int& v : t) v = number[v];
    out.triangles.push_back(t);
  }
  return out;
}

}  // namespace handlebody
