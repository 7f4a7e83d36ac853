#include "tests/bench/clicks/labelled_case.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>

#include "core/errors.h"
#include "core/indices.h"
#include "core/io/formats/volume_io.h"
#include "core/object/distance.h"

namespace handlebody::bench {

namespace {

constexpr double kDeepEnough = 0.4;  // of the deepest voxel: where a user clicks first

using Cell = std::array<int, 3>;
Cell cellOf(const Grid& g, std::size_t i) {
  const std::size_t nx = idx(g.size[0]), ny = idx(g.size[1]);
  return {static_cast<int>(i % nx), static_cast<int>(i / nx % ny), static_cast<int>(i / (nx * ny))};
}
std::size_t at(const Grid& g, const Cell& c) {
  return (idx(c[2]) * idx(g.size[1]) + idx(c[1])) * idx(g.size[0]) + idx(c[0]);
}
Vec3 placeOf(const Grid& g, const Cell& c) { return g.toWorld(Vec3(c[0], c[1], c[2])); }

//! Voxels of a part and the depth (mm) of each in it: the grid's border counts as outside.
struct Part {
  std::vector<std::size_t> voxels;
  std::vector<float> depth;
};

Part depthsOf(const Grid& g, std::vector<std::size_t> voxels) {
  Cell low{std::numeric_limits<int>::max(), std::numeric_limits<int>::max(), std::numeric_limits<int>::max()},
      high{-1, -1, -1};
  for (const std::size_t v : voxels) {
    const Cell c = cellOf(g, v);
    for (std::size_t a = 0; a < 3; ++a) low[a] = std::min(low[a], c[a]), high[a] = std::max(high[a], c[a]);
  }
  std::array<int, 3> size{};
  for (std::size_t a = 0; a < 3; ++a) size[a] = high[a] - low[a] + 3;
  const auto inBox = [&](std::size_t v) {
    const Cell c = cellOf(g, v);
    return (idx(c[2] - low[2] + 1) * idx(size[1]) + idx(c[1] - low[1] + 1)) * idx(size[0]) +
           idx(c[0] - low[0] + 1);
  };
  std::vector<std::uint8_t> others(idx(size[0]) * idx(size[1]) * idx(size[2]), 1);
  for (const std::size_t v : voxels) others[inBox(v)] = 0;
  const std::vector<float> distance = distanceTo(size, g.spacing, others);
  Part out{std::move(voxels), {}};
  for (const std::size_t v : out.voxels) out.depth.push_back(distance[inBox(v)]);
  return out;
}

//! The largest part of the voxels where `wrong` is 1, connected through faces. Clears `wrong`.
std::vector<std::size_t> largestPart(const Grid& g, Mask& wrong) {
  std::vector<std::size_t> best, part;
  for (std::size_t start = 0; start < wrong.size(); ++start) {
    if (!wrong[start]) continue;
    part.assign(1, start);
    wrong[start] = 0;
    for (std::size_t k = 0; k < part.size(); ++k) {
      const Cell c = cellOf(g, part[k]);
      for (std::size_t a = 0; a < 3; ++a)
        for (const int step : {-1, 1}) {
          Cell n = c;
          n[a] += step;
          if (n[a] < 0 || n[a] >= g.size[a] || !wrong[at(g, n)]) continue;
          wrong[at(g, n)] = 0;
          part.push_back(at(g, n));
        }
    }
    if (part.size() > best.size()) best = part;
  }
  return best;
}

}  // namespace

std::vector<LabelledCase> readCases(const std::string& path) {
  std::ifstream file(path);
  const nlohmann::json list = nlohmann::json::parse(file, nullptr, false);
  if (!file || !list.is_array()) throw InputError(path + ": not a list of cases.");
  const auto folder = std::filesystem::path(path).parent_path();
  std::vector<LabelledCase> out;
  for (const auto& c : list)
    out.push_back({c.at("name"), c.value("grade", "clear"),
                   (folder / c.at("volume").get<std::string>()).string(),
                   (folder / c.at("label").get<std::string>()).string(), c.value("value", 0)});
  return out;
}

LabelledVolume readLabelled(const LabelledCase& c) {
  LabelledVolume out{readVolume(c.volumePath), {}};
  const Volume label = readVolume(c.labelPath);
  const Grid &g = out.volume.grid, &l = label.grid;
  out.truth.resize(g.voxelCount());
  visitVoxels(label, [&](const auto* values) {
    for (std::size_t i = 0; i < out.truth.size(); ++i) {
      const Vec3 index = l.toIndex(placeOf(g, cellOf(g, i)));
      if (!l.contains(index)) continue;
      Cell n{};
      for (std::size_t a = 0; a < 3; ++a)
        n[a] =
            std::clamp(static_cast<int>(std::lround(index[static_cast<Eigen::Index>(a)])), 0, l.size[a] - 1);
      const double value = static_cast<double>(values[at(l, n)]);
      out.truth[i] = c.value > 0 ? std::lround(value) == c.value : value > 0;
    }
  });
  return out;
}

std::vector<Vec3> firstClicks(const LabelledVolume& v, int most, unsigned seed) {
  const Grid& g = v.volume.grid;
  std::vector<std::size_t> voxels;
  for (std::size_t i = 0; i < v.truth.size(); ++i)
    if (v.truth[i]) voxels.push_back(i);
  if (voxels.empty()) return {};
  const Part object = depthsOf(g, std::move(voxels));
  const float enough =
      static_cast<float>(kDeepEnough) * *std::max_element(object.depth.begin(), object.depth.end());
  std::vector<Vec3> places;
  for (std::size_t i = 0; i < object.voxels.size(); ++i)
    if (object.depth[i] >= enough) places.push_back(placeOf(g, cellOf(g, object.voxels[i])));
  std::mt19937 random(seed);
  std::vector<Vec3> out;
  for (int k = 0; k < most && !places.empty(); ++k) {
    const std::size_t i = random() % places.size();
    out.push_back(places[i]);
    places.erase(places.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return out;
}

bool nextClick(const LabelledVolume& v, const Mask& result, UserClick& click) {
  const Grid& g = v.volume.grid;
  std::vector<std::size_t> largest;
  for (const bool missed : {true, false}) {
    Mask wrong(v.truth.size());
    for (std::size_t i = 0; i < wrong.size(); ++i)
      wrong[i] = missed ? v.truth[i] && !result[i] : !v.truth[i] && result[i];
    std::vector<std::size_t> part = largestPart(g, wrong);
    if (part.size() <= largest.size()) continue;
    largest = std::move(part);
    click.isInside = missed;
  }
  if (largest.empty()) return false;
  const Part part = depthsOf(g, std::move(largest));
  const auto deepest = std::max_element(part.depth.begin(), part.depth.end()) - part.depth.begin();
  click.place = placeOf(g, cellOf(g, part.voxels[deepest]));
  return true;
}

double diceOf(const Mask& a, const Mask& b) {
  double both = 0, all = 0;
  for (std::size_t i = 0; i < a.size(); ++i) both += a[i] && b[i], all += (a[i] != 0) + (b[i] != 0);
  return 2 * both / std::max(1.0, all);
}

}  // namespace handlebody::bench
