#include "core/evolution/passage_disc.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "core/indices.h"
#include "core/object/rays.h"

namespace handlebody {

namespace {

constexpr double kSample = 0.5;       // voxels between samples in a plane
constexpr double kReach = 4;          // radii of the passage: how far a section is followed
constexpr double kReachVoxels = 5;    // and so many voxels more
constexpr double kAround = 1;         // voxels of the disc around the section
constexpr double kShift = 3;          // voxels along the normal: where the smallest section is looked for
constexpr double kDirections = 0.22;  // between neighbours on the unit sphere
constexpr double kNearStart = 2;      // voxels from the plane's middle to a place of the object in it
constexpr double kRounding = 1e-3;    // mm, and of the normal's components

//! What of the object hangs together with the middle of a plane.
struct Section {
  double area;    // mm²
  Vec3 middle;    // mm
  double radius;  // mm: from there to the furthest sample
};

class Sections {
 public:
  Sections(const ObjectImage& image, double radius) : image_(image) {
    voxel_ = image.volume().grid().meanSpacing();
    step_ = kSample * voxel_;
    half_ = static_cast<int>(std::ceil((kReach * radius + kReachVoxels * voxel_) / step_));
    side_ = 2 * half_ + 1;
  }
  double voxel() const { return voxel_; }
  //! None if the object is not met near the point, or as soon as the area exceeds `most`. A section that goes
  //! on beyond what is followed has the area of all of it.
  std::optional<Section> at(const Vec3& point, const Vec3& normal, double most);

 private:
  enum class Sample : std::uint8_t { unknown, inside, outside };  // of the object

  Vec3 place(int i, int j) const { return point_ + step_ * ((i - half_) * u_ + (j - half_) * v_); }
  bool isIn(int i, int j) {
    Sample& sample = samples_[idx(j) * idx(side_) + idx(i)];
    if (sample == Sample::unknown) sample = image_.inside(place(i, j)) > 0 ? Sample::inside : Sample::outside;
    return sample == Sample::inside;
  }
  std::optional<std::array<int, 2>> begin();

  const ObjectImage& image_;
  double voxel_, step_;
  int half_, side_;
  Vec3 point_, u_, v_;
  std::vector<Sample> samples_;
  std::vector<unsigned char> taken_;  // yes or no
};

//! The sample of the object that is nearest to the middle.
std::optional<std::array<int, 2>> Sections::begin() {
  const int reach = std::min(half_, static_cast<int>(kNearStart / kSample));
  std::optional<std::array<int, 2>> best;
  int nearest = reach * reach + 1;
  for (int j = -reach; j <= reach; ++j)
    for (int i = -reach; i <= reach; ++i)
      if (i * i + j * j < nearest && isIn(half_ + i, half_ + j)) {
        nearest = i * i + j * j;
        best = {half_ + i, half_ + j};
      }
  return best;
}

std::optional<Section> Sections::at(const Vec3& point, const Vec3& normal, double most) {
  point_ = point;
  u_ = normal.unitOrthogonal();
  v_ = normal.cross(u_);
  samples_.assign(idx(side_) * idx(side_), Sample::unknown);
  taken_.assign(samples_.size(), 0);
  const auto first = begin();
  if (!first) return std::nullopt;
  std::vector<std::array<int, 2>> all{*first};
  taken_[idx((*first)[1]) * idx(side_) + idx((*first)[0])] = 1;
  const double each = step_ * step_;
  Vec3 sum(0, 0, 0);
  for (std::size_t k = 0; k < all.size(); ++k) {
    const auto [i, j] = all[k];
    sum += place(i, j);
    if (static_cast<double>(all.size()) * each > most) return std::nullopt;
    for (const auto& [di, dj] : {std::array{1, 0}, std::array{-1, 0}, std::array{0, 1}, std::array{0, -1}}) {
      const int x = i + di, y = j + dj;
      if (x < 0 || y < 0 || x >= side_ || y >= side_) return std::nullopt;
      unsigned char& taken = taken_[idx(y) * idx(side_) + idx(x)];
      if (taken || !isIn(x, y)) continue;
      taken = 1;
      all.push_back({x, y});
    }
  }
  Section section{static_cast<double>(all.size()) * each, sum / static_cast<double>(all.size()), 0};
  for (const auto& [i, j] : all)
    section.radius = std::max(section.radius, (place(i, j) - section.middle).norm());
  return section;
}

double rounded(double x) { return std::round(x / kRounding) * kRounding; }

WallDisc discOf(const Section& section, const Vec3& normal, double around) {
  WallDisc disc{section.middle, normal, rounded(section.radius + around)};
  for (int a = 0; a < 3; ++a) {
    disc.centre[a] = rounded(disc.centre[a]);
    disc.normal[a] = rounded(disc.normal[a]);
  }
  return disc;
}

}  // namespace

WallDisc discAcross(const ObjectImage& image, const Passage& passage) {
  Sections sections(image, passage.radius);
  const double voxel = sections.voxel();
  const Vec3 behind = (passage.widest - passage.place).normalized();
  Section best{std::numeric_limits<double>::infinity(), passage.place, kReach * passage.radius};
  Vec3 normal = behind.norm() > 0 ? behind : Vec3(0, 0, 1);
  const auto look = [&](const Vec3& point, const Vec3& n) {
    const auto found = sections.at(point, n, best.area * (1 - 1e-9));
    if (!found || !(found->area < best.area)) return;
    best = *found;
    normal = n;
  };
  for (const Vec3& n : directionsOverSphere(kDirections))
    if (n.dot(behind) >= 0) look(passage.place, n);
  // From the middle outwards, so that of equal sections the nearest is taken.
  const Vec3 along = normal, middle = best.middle;
  for (double shift = kSample; shift <= kShift; shift += kSample)
    for (const double s : {shift, -shift}) look(middle + s * voxel * along, along);
  for (const double tilt : {0.12, 0.06}) {
    const Vec3 around = normal, point = best.middle, u = around.unitOrthogonal(), v = around.cross(u);
    for (int k = 0; k < 8; ++k) {
      const double angle = k * 0.785398;
      look(point, (around + tilt * (std::cos(angle) * u + std::sin(angle) * v)).normalized());
    }
  }
  return discOf(best, normal, kAround * voxel);
}

}  // namespace handlebody
