#include "core/mesh/containment.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/mesh/nesting.h"

namespace handlebody {

namespace {

//! A vertex of a component, and how often the others wind around it.
struct Sample {
  Vec3 place;
  int component = -1;
  std::map<int, int> winding;
};

std::vector<Sample> samplesByHeight(const Mesh& mesh, const Components& parts) {
  std::vector<Sample> out(parts.count());
  for (int v = 0; v < mesh.vertexSlots(); ++v)
    if (const int c = parts.ofVertex[v]; c >= 0 && out[c].component < 0) out[c] = {mesh.position(v), c, {}};
  std::sort(out.begin(), out.end(),
            [](const Sample& a, const Sample& b) { return a.place.z() < b.place.z(); });
  return out;
}

}  // namespace

std::vector<int> surroundingComponents(const Mesh& mesh, const Components& parts) {
  std::vector<int> out(parts.count(), -1);
  if (parts.count() < 2) return out;
  std::vector<Sample> samples = samplesByHeight(mesh, parts);
  for (const Triangle& t : mesh.faces()) {
    if (t[0] < 0) continue;
    const Vec3 &a = mesh.position(t[0]), &b = mesh.position(t[1]), &c = mesh.position(t[2]);
    const int component = parts.ofVertex[t[0]];
    const double high = std::max({a.z(), b.z(), c.z()});
    auto s = std::lower_bound(samples.begin(), samples.end(), std::min({a.z(), b.z(), c.z()}),
                              [](const Sample& x, double z) { return x.place.z() < z; });
    for (; s != samples.end() && s->place.z() <= high; ++s)
      if (s->component != component)
        if (const int n = crossing(a, b, c, s->place); n != 0) s->winding[component] += n;
  }
  // Of those around a component the smallest is the innermost: they do not cross.
  const auto size = [&](int c) { return std::abs(parts.volume[c]); };
  for (const Sample& s : samples)
    for (const auto& [around, n] : s.winding) {
      int& best = out[s.component];
      if (n != 0 && (best < 0 || size(around) < size(best))) best = around;
    }
  return out;
}

std::vector<int> bodyOfComponents(const Components& parts, const std::vector<int>& surrounding) {
  std::vector<int> out(parts.count(), -1);
  for (int c = 0; c < parts.count(); ++c) out[c] = parts.volume[c] > 0 ? c : surrounding[c];
  return out;
}

}  // namespace handlebody
