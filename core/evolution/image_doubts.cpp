#include "core/evolution/image_doubts.h"

#include <cstdio>

namespace handlebody {

namespace {

constexpr double kNoEdge = 0.25;  // of the step from the object to its boundary
constexpr double kMuch = 0.1;     // of the surface

template <typename... Numbers>
std::string sentence(const char* format, Numbers... numbers) {
  char text[400];
  std::snprintf(text, sizeof text, format, numbers...);
  return text;
}

}  // namespace

double partWithoutEdge(const Mesh& mesh, const ObjectImage& image) {
  const Grid& grid = image.volume().grid();
  const double reach = grid.meanSpacing();
  double without = 0, all = 0;
  for (int f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isFace(f)) continue;
    const Triangle& t = mesh.face(f);
    const Vec3 area = mesh.areaVector(f);
    const double size = area.norm();
    if (!(size > 0)) continue;
    const Vec3 middle = (mesh.position(t[0]) + mesh.position(t[1]) + mesh.position(t[2])) / 3;
    const Vec3 beyond = middle + reach * area / size;
    if (!grid.contains(grid.toIndex(beyond))) continue;
    all += size;
    const double within = image.insideByIntensity(middle - reach * area / size);
    if (within - image.insideByIntensity(beyond) < kNoEdge) without += size;
  }
  return all > 0 ? without / all : 0;
}

std::vector<std::string> imageDoubts(const Mesh& mesh, const ObjectImage& image) {
  std::vector<std::string> out;
  if (const NeckCut* neck = image.neck())
    out.push_back(sentence(
        "the surface is held %s %.3g mm%s: behind it the same intensities go on for at least %.3g ml, in "
        "front "
        "of it they fill %.3g ml; where that belongs to the object, put a seed there too, or give --range, "
        "which holds nothing back",
        neck->widens ? "where its structure grows wider than a radius of"
        : neck->hole ? "at a hole of radius"
                     : "at a neck of radius",
        neck->neckRadius, neck->hole ? " in a thin wall" : "", neck->cutVolume / 1000,
        neck->keptVolume / 1000));
  const double part = partWithoutEdge(mesh, image);
  if (part > kMuch)
    out.push_back(
        sentence("%.0f %% of the surface lies where the image shows no edge: the object may go on "
                 "there, or the surface leaked",
                 100 * part));
  return out;
}

}  // namespace handlebody
