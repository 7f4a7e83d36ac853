#include "core/evolution/level_field.h"

#include <algorithm>
#include <cmath>

#include "core/indices.h"

namespace handlebody {

namespace {

constexpr double kNodeDistance = 8;  // voxels (mean spacing)
// Each wider ring of the kernel counts this much less than the one within it: what is near decides, however
// little it is.
constexpr double kWider = 0.05;

//! One pass with the kernel (1, 2, 1)/4 whose taps are `step` nodes apart, along one axis; beyond the border
//! there is nothing.
void blurAxis(std::vector<double>& field, const std::array<int, 3>& n, int axis, int step) {
  std::size_t stride = 1;
  for (int a = 0; a < axis; ++a) stride *= idx(n[a]);
  const int length = n[axis];
  const std::vector<double> in = field;
  for (std::size_t at = 0; at < in.size(); ++at) {
    const int i = static_cast<int>(at / stride % idx(length));
    double sum = 0.5 * in[at];
    if (i >= step) sum += 0.25 * in[at - idx(step) * stride];
    if (i + step < length) sum += 0.25 * in[at + idx(step) * stride];
    field[at] = sum;
  }
}

//! Sum of ever wider blurs ("à trous": Holschneider et al. 1989), each with less weight.
std::vector<double> heavyTailed(std::vector<double> field, const std::array<int, 3>& n) {
  std::vector<double> total(field.size(), 0);
  const int widest = std::max({n[0], n[1], n[2]});
  double weight = 1;
  for (int step = 1;; step *= 2) {
    for (int axis = 0; axis < 3; ++axis) blurAxis(field, n, axis, step);
    for (std::size_t i = 0; i < total.size(); ++i) total[i] += weight * field[i];
    weight *= kWider;
    if (step >= widest) return total;
  }
}

}  // namespace

LevelField::LevelField(const Grid&, double level) : values_{level} {}

LevelField LevelField::between(const LevelField& a, const LevelField& b, double part) {
  LevelField out = b.values_.size() == 1 ? a : b;
  for (std::size_t i = 0; i < out.values_.size(); ++i) {
    const double from = a.values_[a.values_.size() == 1 ? 0 : i],
                 to = b.values_[b.values_.size() == 1 ? 0 : i];
    out.values_[i] = from + part * (to - from);
  }
  return out;
}

double LevelField::lowest() const { return *std::min_element(values_.begin(), values_.end()); }
double LevelField::highest() const { return *std::max_element(values_.begin(), values_.end()); }

double LevelField::interpolate(const Vec3& index) const {
  std::array<std::size_t, 3> low, next;
  std::array<double, 3> t;
  std::size_t stride = 1;
  for (std::size_t a = 0; a < 3; ++a) {
    // In this order a coordinate that is not a number becomes 0.
    const double x =
        std::min(std::max(0.0, index[static_cast<int>(a)] * perVoxel_[static_cast<int>(a)]), nodes_[a] - 1.0);
    const int cell = std::min(static_cast<int>(x), std::max(0, nodes_[a] - 2));
    t[a] = x - cell;
    low[a] = idx(cell) * stride;
    next[a] = nodes_[a] > 1 ? stride : 0;
    stride *= idx(nodes_[a]);
  }
  const auto along = [](double a, double b, double s) { return a + s * (b - a); };
  const double* p = &values_[low[0] + low[1] + low[2]];
  const double* q = p + next[2];
  return along(along(along(p[0], p[next[0]], t[0]), along(p[next[1]], p[next[1] + next[0]], t[0]), t[1]),
               along(along(q[0], q[next[0]], t[0]), along(q[next[1]], q[next[1] + next[0]], t[0]), t[1]),
               t[2]);
}

LevelField::Samples::Samples(const Grid& grid) : grid_(grid) {
  std::size_t count = 1;
  for (std::size_t a = 0; a < 3; ++a) {
    const double spacing = grid.spacing[static_cast<int>(a)];
    perNode_[static_cast<int>(a)] = kNodeDistance * grid.meanSpacing() / spacing;
    nodes_[a] = 1 + static_cast<int>(std::ceil((grid.size[a] - 1) / perNode_[static_cast<int>(a)]));
    count *= idx(nodes_[a]);
  }
  sum_.assign(count, 0);
  weight_.assign(count, 0);
}

void LevelField::Samples::add(const Vec3& index, double level, double weight) {
  std::size_t at = 0;
  for (int a = 2; a >= 0; --a) {
    const int node = static_cast<int>(index[a] / perNode_[a] + 0.5);
    at = at * idx(nodes_[a]) + idx(std::clamp(node, 0, nodes_[a] - 1));
  }
  sum_[at] += weight * level;
  weight_[at] += weight;
}

bool LevelField::Samples::empty() const {
  return std::none_of(weight_.begin(), weight_.end(), [](double w) { return w > 0; });
}

LevelField LevelField::Samples::spread() const {
  LevelField field;
  field.nodes_ = nodes_;
  field.perVoxel_ = perNode_.cwiseInverse();
  field.values_ = heavyTailed(sum_, nodes_);
  const std::vector<double> weight = heavyTailed(weight_, nodes_);
  for (std::size_t i = 0; i < weight.size(); ++i) field.values_[i] /= weight[i];
  return field;
}

}  // namespace handlebody
