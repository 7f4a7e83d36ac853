#include "core/solid/surface_distance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/cancellation.h"
#include "core/collision/closest_point.h"
#include "core/phase.h"
#include "core/threads.h"

namespace handlebody {

namespace {

using Corners = std::array<Vec3, 3>;

constexpr std::size_t kChunk = 1024;  // triangles or points at a time

Corners cornersOf(const TriangleSoup& mesh, std::size_t triangle) {
  const Triangle& t = mesh.triangles[triangle];
  return {mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]};
}

double areaOf(const Corners& c) { return (c[1] - c[0]).cross(c[2] - c[0]).norm() / 2; }

//! Calls f(piece) for the pieces of a triangle; ends early where f returns false.
template <typename F>
void forPieces(const Corners& triangle, double h, F&& f) {
  std::vector<Corners> waiting{triangle};
  while (!waiting.empty()) {
    const Corners c = waiting.back();
    waiting.pop_back();
    const std::array<double, 3> squared{(c[1] - c[0]).squaredNorm(), (c[2] - c[1]).squaredNorm(),
                                        (c[0] - c[2]).squaredNorm()};
    const auto i =
        static_cast<std::size_t>(std::max_element(squared.begin(), squared.end()) - squared.begin());
    const Vec3 &a = c[i], &b = c[(i + 1) % 3], &apex = c[(i + 2) % 3], middle = (a + b) / 2;
    // Of a damaged file: so far out that no number lies between the ends.
    const bool isWhole = middle == a || middle == b;
    if (squared[i] <= h * h || isWhole) {
      if (!f(c)) return;
      continue;
    }
    waiting.push_back({a, middle, apex});
    waiting.push_back({middle, b, apex});
  }
}

struct Sample {
  double distance, area;
};

std::size_t chunksOf(std::size_t n) { return (n + kChunk - 1) / kChunk; }

//! The samples of each chunk of triangles, one chunk behind the other.
std::vector<Sample> takeSamples(const TriangleSoup& from, const ClosestPoint& to, double h, int threads) {
  std::vector<std::vector<Sample>> chunks(chunksOf(from.triangles.size()));
  forEachOnThreads(chunks.size(), threads, [&](std::size_t chunk) {
    int hint = -1;
    const std::size_t end = std::min((chunk + 1) * kChunk, from.triangles.size());
    for (std::size_t t = chunk * kChunk; t < end; ++t) {
      giveUpIfCancelled();
      forPieces(cornersOf(from, t), h, [&](const Corners& c) {
        chunks[chunk].push_back({to.distance((c[0] + c[1] + c[2]) / 3, &hint), areaOf(c)});
        return true;
      });
    }
  });
  std::vector<Sample> all;
  for (auto& chunk : chunks) {
    all.insert(all.end(), chunk.begin(), chunk.end());
    std::vector<Sample>().swap(chunk);
  }
  return all;
}

std::vector<double> distancesOf(const TriangleSoup& mesh, const ClosestPoint& to, int threads) {
  std::vector<double> distances(mesh.points.size());
  forEachOnThreads(chunksOf(distances.size()), threads, [&](std::size_t chunk) {
    giveUpIfCancelled();
    int hint = -1;
    const std::size_t end = std::min((chunk + 1) * kChunk, distances.size());
    for (std::size_t v = chunk * kChunk; v < end; ++v) distances[v] = to.distance(mesh.points[v], &hint);
  });
  return distances;
}

//! The extremes over the vertices that belong to a triangle.
void addVertices(const TriangleSoup& mesh, const std::vector<double>& distances, DirectedDistances& d) {
  for (const Triangle& t : mesh.triangles)
    for (const int v : t) {
      d.smallest = std::min(d.smallest, distances[v]);
      d.largest = std::max(d.largest, distances[v]);
    }
}

}  // namespace

double areaOf(const TriangleSoup& mesh) {
  double area = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) area += areaOf(cornersOf(mesh, t));
  return area;
}

std::size_t countSamples(const TriangleSoup& mesh, double h, std::size_t most) {
  const double largestPiece = std::sqrt(3) / 4 * h * h;  // equilateral
  if (areaOf(mesh) > static_cast<double>(most) * largestPiece) return most + 1;
  std::size_t n = 0;
  for (std::size_t t = 0; t < mesh.triangles.size() && n <= most; ++t) {
    giveUpIfCancelled();
    forPieces(cornersOf(mesh, t), h, [&](const Corners&) { return ++n <= most; });
  }
  return n;
}

DirectedDistances directedDistances(const TriangleSoup& from, const TriangleSoup& to, double h, int threads) {
  const ClosestPoint nearest(to);
  std::vector<Sample> samples = takeSamples(from, nearest, h, threads);
  std::sort(samples.begin(), samples.end(), [](const Sample& a, const Sample& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.area < b.area;
  });
  DirectedDistances d;
  d.samples = samples.size();
  d.smallest = samples.front().distance;
  d.largest = samples.back().distance;
  double moment = 0;
  for (const Sample& s : samples) {
    d.area += s.area;
    moment += s.area * s.distance;
  }
  d.mean = moment / d.area;
  double below = 0;
  for (const Sample& s : samples) {
    d.percentile95 = s.distance;
    below += s.area;
    if (below >= 0.95 * d.area) break;
  }
  addVertices(from, distancesOf(from, nearest, threads), d);
  return d;
}

std::vector<double> vertexDistances(const TriangleSoup& mesh, const TriangleSoup& to, bool isSigned,
                                    int threads) {
  const Phase phase("distances");
  const ClosestPoint nearest(to);
  std::vector<double> distances = distancesOf(mesh, nearest, threads);
  if (!isSigned) return distances;
  forEachOnThreads(chunksOf(distances.size()), threads, [&](std::size_t chunk) {
    giveUpIfCancelled();
    const std::size_t end = std::min((chunk + 1) * kChunk, distances.size());
    for (std::size_t v = chunk * kChunk; v < end; ++v)
      if (distances[v] > 0 && nearest.windingNumber(mesh.points[v]) > 0) distances[v] = -distances[v];
  });
  return distances;
}

}  // namespace handlebody
