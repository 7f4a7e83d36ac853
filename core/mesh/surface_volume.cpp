#include "core/mesh/surface_volume.h"

#include "core/indices.h"
#include "core/mesh/topology.h"

namespace handlebody {

double SurfaceVolume::follow(const Mesh& mesh, VertexMarkSpan touched) {
  const auto isTouched = [&](int v) { return idx(v) < touched.size() && touched[idx(v)] != 0; };
  const auto faces = mesh.faces();
  const std::size_t known = shares_.size();
  shares_.resize(faces.size(), 0.0);
  double volume = 0;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const Triangle& t = faces[f];
    if (t[0] < 0) {
      shares_[f] = 0;
      continue;
    }
    if (f >= known || isTouched(t[0]) || isTouched(t[1]) || isTouched(t[2])) shares_[f] = enclosedBy(mesh, t);
    volume += shares_[f];
  }
  return volume;
}

}  // namespace handlebody
