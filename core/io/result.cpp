#include "core/io/result.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "core/collision/certify.h"

namespace handlebody {

namespace {

constexpr double kHardlyGrown = 1.5;  // times the volume of the seeds
constexpr double kMuchBorder = 0.15;  // part of the vertices

TriangleSoup roundedToSingle(TriangleSoup mesh) {
  // Not p.cast<float>().cast<double>(): Eigen 3.4 vectorises that to nothing.
  for (Vec3& p : mesh.points)
    for (double& x : p) x = static_cast<float>(x);
  return mesh;
}

void requirePass(const Certificate& c) {
  if (c.passes()) return;
  const auto word = [](bool yes) { return yes ? "yes" : "no"; };
  throw std::runtime_error(std::string("the mesh failed its certificate and nothing was written (closed: ") +
                           word(c.closed) + ", manifold: " + word(c.manifold) +
                           ", oriented: " + word(c.oriented) +
                           ", self-intersections: " + std::to_string(c.selfIntersections) + ").");
}

}  // namespace

CertifiedMesh certifiedForExport(TriangleSoup mesh) {
  CertifiedMesh out{roundedToSingle(std::move(mesh)), {}};
  out.certificate = certify(out.mesh);
  requirePass(out.certificate);
  return out;
}

std::vector<std::string> doubts(const RunReport& report, const TriangleSoup& mesh) {
  std::vector<std::string> out;
  double seeds = 0;
  for (const Seed& s : report.session.resolved->seeds)
    seeds += 4.0 / 3.0 * std::numbers::pi * std::pow(*s.radius, 3);
  if (report.mesh.volume < kHardlyGrown * seeds)
    out.push_back(
        "the surface hardly grew beyond its seed: look at --object and --range, and whether --curvature "
        "holds so "
        "small a seed");
  double onBorder = 0;
  for (const Vec3& p : mesh.points) {
    const Vec3 index = report.volume.grid.toIndex(p);
    for (int a = 0; a < 3; ++a)
      if (std::min(index[a], report.volume.grid.size[static_cast<std::size_t>(a)] - 1 - index[a]) < 0) {
        onBorder += 1;
        break;
      }
  }
  const double part = onBorder / static_cast<double>(mesh.points.size());
  if (part > kMuchBorder)
    out.push_back(std::to_string(static_cast<int>(100 * part)) +
                  " % of the surface lies on the border of the volume: the object is cut off there, or the "
                  "surface leaked");
  return out;
}

void writeResults(const TriangleSoup& mesh, const Grid& grid, const std::vector<std::string>& paths,
                  CoordinateSpace space) {
  std::optional<Volume> label;
  for (const std::string& path : paths) {
    if (isMeshPath(path)) {
      writeMesh(mesh, path, space);
      continue;
    }
    if (!label) label = rasterize(mesh, grid);
    writeVolume(*label, path);
  }
}

}  // namespace handlebody
