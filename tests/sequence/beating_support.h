#pragma once
// The beating phantom, grown in one frame and carried through the others.

#include <algorithm>
#include <chrono>
#include <functional>
#include <utility>
#include <vector>

#include "core/io/report/result.h"
#include "core/sequence/over_time.h"
#include "core/sequence/volume_curve.h"
#include "core/solid/rasterize.h"
#include "sample_volumes/beating.h"

namespace handlebody::test {

inline double seconds(std::chrono::steady_clock::time_point since) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - since).count();
}

//! Dark balls on bright ground, 40 voxels of 1 mm to each side.
inline Volume balls(const std::vector<std::pair<Vec3, double>>& all) {
  Grid grid;
  grid.size = {40, 40, 40};
  void* buffer = nullptr;
  Volume volume = makeVolume(grid, VoxelType::uint8, &buffer);
  auto* to = static_cast<std::uint8_t*>(buffer);
  for (int z = 0; z < 40; ++z)
    for (int y = 0; y < 40; ++y)
      for (int x = 0; x < 40; ++x) {
        double d = 1e9;
        for (const auto& [centre, radius] : all) d = std::min(d, (Vec3(x, y, z) - centre).norm() - radius);
        *to++ = static_cast<std::uint8_t>(120 + 60 * std::clamp(d, -1.0, 1.0));
      }
  return volume;
}

inline const Vec3 kMiddle(20, 20, 20);  //!< of those volumes

inline double ball(double radius) { return 4.0 / 3 * 3.14159265358979 * radius * radius * radius; }

//! A ball in the middle whose core is darker than the rest of it: a click there means the core. 200 outside,
//! 150 in the ball, 90 in the core.
inline Volume ballWithCore(double radius, double core) {
  const Volume whole = balls({{kMiddle, radius}}), inner = balls({{kMiddle, core}});
  void* buffer = nullptr;
  const Volume image = makeVolume(whole.grid, VoxelType::uint8, &buffer);
  for (std::size_t i = 0; i < whole.grid.voxelCount(); ++i)
    static_cast<std::uint8_t*>(buffer)[i] = static_cast<std::uint8_t>(
        200 - (180 - whole.data<std::uint8_t>()[i]) * 50 / 120 - (180 - inner.data<std::uint8_t>()[i]) / 2);
  return image;
}

//! Frame 0 is the first, all others are the second.
inline std::function<Volume(int)> framesOf(const Volume& first, const Volume& next) {
  return [first, next](int frame) { return frame == 0 ? first : next; };
}

//! Grown from the seeds in one frame, as `segment` does.
struct GrownFrame {
  FrameResult result;
  OverTimeSettings settings;
};

inline GrownFrame growIn(Volume volume, int frame, const Request& request) {
  const auto begin = std::chrono::steady_clock::now();
  ActiveContour contour(std::move(volume), request.seeds, request.parameters, request.constraints);
  while (contour.stopReason() == StopReason::running) contour.step();
  GrownFrame grown;
  const CertifiedMesh made = certifiedForExport(contour.mesh().compact());
  grown.result.mesh = made.mesh;
  grown.result.frame = frame;
  grown.result.volume = made.certificate.volume;
  grown.result.components = made.certificate.components;
  for (const int g : made.certificate.genus) grown.result.genus += g;
  grown.result.stopped = contour.stopReason();
  grown.result.seconds = seconds(begin);
  grown.settings = {contour.request(), contour.parameters().edgeLength, contour.parameters().smoothing, true};
  return grown;
}

inline FrameCarrier::Hooks hooksOf(std::function<Volume(int)> load) {
  return {std::move(load), [](const TriangleSoup& mesh) { return certifiedForExport(mesh).mesh; }};
}

inline bool has(const FrameResult& r, FrameFault fault) {
  for (const ToldFault& f : r.faults)
    if (f.fault == fault) return true;
  return false;
}

//! What is told of a fault; FindingKind::none if there is none of that kind.
inline Finding toldOf(const FrameResult& r, FrameFault fault) {
  for (const ToldFault& f : r.faults)
    if (f.fault == fault) return f.finding;
  return {};
}

//! Dice of a mesh and a label map, on the map's voxels.
inline double diceOf(const TriangleSoup& mesh, const Volume& truth) {
  const Volume mine = rasterize(mesh, truth.grid);
  double a = 0, b = 0, both = 0;
  for (std::size_t i = 0; i < truth.grid.voxelCount(); ++i) {
    const bool m = mine.data<std::uint8_t>()[i] != 0, t = truth.data<std::uint8_t>()[i] != 0;
    a += m;
    b += t;
    both += m && t;
  }
  return 2 * both / (a + b);
}

inline VolumeCurve curveOf(const std::vector<FrameResult>& frames) {
  std::vector<VolumePoint> points;
  for (const FrameResult& r : frames) points.push_back({r.frame, {}, r.volume, r.isTrusted()});
  return volumeCurve(points);
}

}  // namespace handlebody::test
