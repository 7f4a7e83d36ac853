#pragma once
// One whole job on a phantom, and how far its outcome is from the truth.

#include <algorithm>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

#include "core/collision/certify.h"
#include "core/evolution/active_contour.h"
#include "core/io/meshes/mesh_io.h"
#include "sample_volumes/phantom.h"
#include "tests/support/catch.h"
#ifdef HANDLEBODY_WITH_ORACLE
#include "tests/collision_oracle/oracle.h"
#endif

namespace handlebody::testing {

struct Outcome {
  TriangleSoup mesh;
  Certificate certificate;
  int iterations = 0;
  StopReason stop = StopReason::running;
};

//! Runs to the end from the phantom's seed.
inline Outcome growWith(const Phantom& phantom, const Parameters& parameters) {
  ActiveContour contour(phantom.volume, {{phantom.seed, phantom.seedRadius}}, parameters);
  while (contour.stopReason() == StopReason::running) contour.step();
  Outcome out{contour.mesh().compact(), {}, contour.iteration(), contour.stopReason()};
  out.certificate = certify(out.mesh);
  return out;
}

//! The same; everything but the threads and the direction is automatic.
inline Outcome grow(const Phantom& phantom, int threads = 1, Direction direction = Direction::outward) {
  Parameters parameters;
  parameters.threads = threads;
  parameters.direction = direction;
  return growWith(phantom, parameters);
}

//! |distance| to the ideal surface in voxels (mean spacing) at the vertices and the middles of the faces,
//! ascending.
inline std::vector<double> distances(const Phantom& phantom, const PhantomOptions& options,
                                     const TriangleSoup& mesh) {
  std::vector<double> d;
  const auto add = [&](const Vec3& p) {
    d.push_back(std::abs(phantomDistance(phantom.name, options, p)) / phantom.volume.grid.meanSpacing());
  };
  for (const Vec3& p : mesh.points) add(p);
  for (const Triangle& t : mesh.triangles)
    add((mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]) / 3);
  std::sort(d.begin(), d.end());
  return d;
}

inline double mean(const std::vector<double>& values) {
  double sum = 0;
  for (double v : values) sum += v;
  return sum / static_cast<double>(values.size());
}

struct Overlap {
  double dice;
  double truthVolume;  // mm³
};

inline Overlap overlap(const Phantom& phantom, const TriangleSoup& mesh) {
  const Volume label = rasterize(mesh, phantom.volume.grid);
  const auto* a = label.data<std::uint8_t>();
  const auto* b = phantom.truth.data<std::uint8_t>();
  double both = 0, sum = 0, truth = 0;
  for (std::size_t i = 0; i < phantom.volume.grid.voxelCount(); ++i) {
    both += a[i] && b[i];
    sum += (a[i] != 0) + (b[i] != 0);
    truth += b[i] != 0;
  }
  return {2 * both / sum, truth * phantom.volume.grid.voxelVolume()};
}

//! What is asked of an outcome; in voxels of mean spacing.
struct Limits {
  double dice = 0.985;
  double meanDistance = 0.2;
  double distance95 = 0.5;  //!< 95 of 100 points lie closer
  double volume = 0.02;     //!< relative error
  double furthest = std::numeric_limits<double>::infinity();
};

inline std::vector<int> sorted(std::vector<int> values) {
  std::sort(values.begin(), values.end());
  return values;
}

//! Converged, certified, free of intersections by an exact method that is not ours, of the right topology,
//! and as close to the truth as asked.
inline void expectTrue(const Phantom& phantom, const PhantomOptions& options, const Outcome& o,
                       const Limits& limits, const std::string& what) {
  CHECK(o.stop == StopReason::converged);
  CHECK(o.certificate.passes());
  CHECK(sorted(o.certificate.genus) == sorted(phantom.genus));
#ifdef HANDLEBODY_WITH_ORACLE
  CHECK(oracle::selfIntersections(o.mesh).empty());
#endif
  const std::vector<double> d = distances(phantom, options, o.mesh);
  const Overlap v = overlap(phantom, o.mesh);
  const double far = d[d.size() * 95 / 100], volume = o.certificate.volume / v.truthVolume;
  CHECK(v.dice >= limits.dice);
  CHECK(mean(d) <= limits.meanDistance);
  CHECK(far <= limits.distance95);
  CHECK(d.back() <= limits.furthest);
  CHECK(std::abs(volume - 1) <= limits.volume);
  std::cout << phantom.name << ' ' << what << ": iterations " << o.iterations << ", vertices "
            << o.certificate.vertices << ", Dice " << v.dice << ", mean distance " << mean(d)
            << " voxel (95 % below " << far << ", all below " << d.back() << "), volume " << volume << '\n';
}

}  // namespace handlebody::testing
