#include "core/measure/centre_line.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/cancellation.h"
#include "core/measure/ball_path.h"
#include "core/measure/section_area.h"
#include "core/mesh/topology.h"
#include "core/phase.h"

namespace handlebody {

namespace {

constexpr int kRounds = 4;  // of centring and smoothing
constexpr int kCentringSteps = 20;
constexpr double kFirstStep = 0.3;  // of the radius; halved where it does not help
constexpr double kPointsPerRadius = 4;
constexpr double kBallsInVolume = 500'000;  // lattice points that a body may have at first
constexpr double kCellsPerRadius = 3;       // where the way begins and ends

double lengthOf(const std::vector<Vec3>& line) {
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i) length += (line[i] - line[i - 1]).norm();
  return length;
}

//! The same line with n + 1 points, evenly spaced.
std::vector<Vec3> resampled(const std::vector<Vec3>& line, int n) {
  const double step = lengthOf(line) / n;
  std::vector<Vec3> out{line.front()};
  double before = 0;
  const auto next = [&] { return static_cast<double>(out.size()) * step; };
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double piece = (line[i] - line[i - 1]).norm();
    while (static_cast<int>(out.size()) < n && piece > 0 && next() <= before + piece)
      out.push_back(line[i - 1] + (next() - before) / piece * (line[i] - line[i - 1]));
    before += piece;
  }
  out.push_back(line.back());
  return out;
}

//! A parabola through the points around one, by least squares with the weights of a bell.
struct Parabola {
  Vec3 place, direction;
};

Parabola fit(const std::vector<Vec3>& line, int at, double step, double width) {
  const int reach = std::max(2, static_cast<int>(std::ceil(2.5 * width / step)));
  const int n = static_cast<int>(line.size());
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero(), right = Eigen::Matrix3d::Zero();
  for (int i = std::max(0, at - reach); i <= std::min(n - 1, at + reach); ++i) {
    const double t = (i - at) * step / width;
    const double weight = std::exp(-t * t / 2);
    const Vec3 powers(1, t, t * t);
    normal += weight * powers * powers.transpose();
    right += weight * powers * (line[i] - line[at]).transpose();
  }
  const Eigen::Matrix3d found = normal.ldlt().solve(right);
  const Vec3 direction = found.row(1).transpose();
  return {line[at] + found.row(0).transpose(), direction.normalized()};
}

//! The line while it is made.
class Line {
 public:
  Line(InscribedBalls& balls, std::vector<Vec3> points) : balls_(balls), points_(std::move(points)) {}

  void improve() {
    resample();
    smooth();
    for (int round = 0; round < kRounds; ++round) {
      giveUpIfCancelled();
      resample();
      centre();
      smooth();
    }
    resample();
  }
  const std::vector<Vec3>& points() const { return points_; }
  double step() const { return step_; }
  Parabola at(int i) const { return fit(points_, i, step_, width(i)); }

 private:
  void resample() {
    const double length = lengthOf(points_);
    measure();
    std::vector<double> sorted = radii_;
    std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2),
                     sorted.end());
    const double wanted = sorted[sorted.size() / 2] / kPointsPerRadius;
    const int n = static_cast<int>(std::clamp(std::ceil(length / wanted), 4.0, kMaxLinePoints - 1.0));
    points_ = resampled(points_, n);
    step_ = length / n;
    measure();
  }
  void measure() {
    radii_.clear();
    for (const Vec3& p : points_) radii_.push_back(balls_.radius(p));
  }
  double width(int i) const { return std::max(step_, 0.5 * radii_[i]); }

  void smooth() {
    std::vector<Vec3> smoothed;
    for (int i = 0; i < static_cast<int>(points_.size()); ++i) smoothed.push_back(at(i).place);
    for (std::size_t i = 0; i < points_.size(); ++i)  // not out of the object
      if ((smoothed[i] - points_[i]).norm() < radii_[i]) points_[i] = smoothed[i];
    measure();
  }
  //! Every point to where the ball is largest, at right angles to the line.
  void centre() {
    std::vector<Vec3> directions;
    for (int i = 0; i < static_cast<int>(points_.size()); ++i) directions.push_back(at(i).direction);
    for (std::size_t i = 0; i < points_.size(); ++i) centreOne(points_[i], directions[i], radii_[i]);
  }
  void centreOne(Vec3& p, const Vec3& direction, double& radius) {
    double step = kFirstStep * radius;
    for (int k = 0; k < kCentringSteps; ++k) {
      Vec3 away = p - balls_.foot(p);
      away -= away.dot(direction) * direction;
      const double length = away.norm();
      if (!(length > 1e-9 * radius)) return;
      const Vec3 moved = p + std::min(step, radius / 2) / length * away;
      const double larger = balls_.radius(moved);
      if (larger > radius) {
        p = moved;
        radius = larger;
      } else {
        step /= 2;
      }
    }
  }

  InscribedBalls& balls_;
  std::vector<Vec3> points_;
  std::vector<double> radii_;
  double step_ = 1;
};

CentreLine lineOf(const TriangleSoup& mesh, const Line& line, InscribedBalls& balls) {
  CentreLine out;
  const std::vector<Vec3>& points = line.points();
  for (int i = 0; i < static_cast<int>(points.size()); ++i) {
    giveUpIfCancelled();
    if (i > 0) out.length += (points[i] - points[i - 1]).norm();
    CentreLinePoint p;
    p.place = points[i];
    p.along = out.length;
    p.direction = line.at(i).direction;
    p.radius = balls.radius(p.place);
    p.area = sectionArea(mesh, p.place, p.direction);
    out.points.push_back(p);
  }
  return out;
}

}  // namespace

double CentreLinePoint::equivalentDiameter() const {
  return 2 * std::sqrt(area.value_or(0) / std::numbers::pi);
}

const char* centreLineFaultText(CentreLineFault fault) {
  switch (fault) {
    case CentreLineFault::firstOutside:
      return "the first point lies outside of the object";
    case CentreLineFault::secondOutside:
      return "the second point lies outside of the object";
    case CentreLineFault::samePlace:
      return "the two points lie in the same place of the object";
    case CentreLineFault::tooLongAndThin:
      return "the way between them is too long and thin to be searched";
    case CentreLineFault::noWay:
      return "there is no way from one to the other inside of the object";
    default:
      return "";
  }
}

CentreLine centreLine(const TriangleSoup& mesh, const Vec3& from, const Vec3& to) {
  const Phase phase("centre line");
  InscribedBalls balls(mesh);
  if (!balls.isInside(from)) return {{}, 0, CentreLineFault::firstOutside};
  if (!balls.isInside(to)) return {{}, 0, CentreLineFault::secondOutside};
  const Vec3 first = balls.medialCentre(from), last = balls.medialCentre(to);
  const double thinner = std::min(balls.radius(first), balls.radius(last));
  if ((last - first).norm() < thinner) return {{}, 0, CentreLineFault::samePlace};
  const double spacing =
      std::max(thinner / kCellsPerRadius, std::cbrt(std::abs(signedVolume(Mesh(mesh))) / kBallsInVolume));
  const BallPath path = findBallPath(balls, first, last, std::min(spacing, thinner));
  if (path.points.empty()) return {{}, 0, path.fault};
  Line line(balls, path.points);
  line.improve();
  return lineOf(mesh, line, balls);
}

}  // namespace handlebody
