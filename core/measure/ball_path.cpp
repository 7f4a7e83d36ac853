#include "core/measure/ball_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <queue>
#include <unordered_map>

#include "core/cancellation.h"

namespace handlebody {

namespace {

constexpr int kFinerLattices = 3;
constexpr std::int64_t kReach = 1 << 20;  // lattice points on either side of the start

struct Ball {
  std::array<int, 3> cell;
  double radius;
  double cost = -1;  // of the way to it; below 0: none yet
  int before = -1;   // on that way
  bool isDone = false;
};

class Search {
 public:
  Search(InscribedBalls& balls, const Vec3& from, const Vec3& to, double spacing)
      : balls_(balls), from_(from), to_(to), spacing_(spacing) {}

  //! Index of the last ball of the way, or -1.
  int run() {
    reach(ballAt({0, 0, 0}), 0, -1);
    while (!waiting_.empty() && !isFull()) {
      const auto [cost, i] = waiting_.top();
      waiting_.pop();
      if (at(i).isDone) continue;
      at(i).isDone = true;
      if ((centre(at(i).cell) - to_).norm() <= spacing_) return i;
      giveUpIfCancelled();
      spread(i);
    }
    return -1;
  }
  bool isFull() const { return static_cast<int>(all_.size()) > kMaxBalls; }
  std::vector<Vec3> wayTo(int last) const {
    std::vector<Vec3> way{to_};
    for (int i = last; i >= 0; i = all_[i].before) way.push_back(centre(all_[i].cell));
    std::reverse(way.begin(), way.end());
    return way;
  }

 private:
  using Cell = std::array<int, 3>;
  Ball& at(int i) { return all_[i]; }
  Vec3 centre(const Cell& c) const { return from_ + spacing_ * Vec3(c[0], c[1], c[2]); }
  int ballAt(const Cell& c) {
    const std::int64_t key = ((c[2] + kReach) * 2 * kReach + (c[1] + kReach)) * 2 * kReach + (c[0] + kReach);
    const auto [found, isNew] = index_.try_emplace(key, static_cast<int>(all_.size()));
    if (isNew) all_.push_back({c, balls_.radius(centre(c))});
    return found->second;
  }
  void reach(int i, double cost, int before) {
    Ball& b = at(i);
    if (b.isDone || (b.cost >= 0 && b.cost <= cost)) return;
    b.cost = cost;
    b.before = before;
    waiting_.push({cost, i});
  }
  void spread(int i) {
    const Ball here = at(i);
    for (int k = 0; k < 27; ++k) {
      const Cell step{k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1};
      if (k == 13) continue;
      const double length = spacing_ * Vec3(step[0], step[1], step[2]).norm();
      const int j = ballAt({here.cell[0] + step[0], here.cell[1] + step[1], here.cell[2] + step[2]});
      const double radius = at(j).radius;
      if (!(here.radius + radius > length * (1 + 1e-9))) continue;
      const double each = 1 / (here.radius * here.radius) + 1 / (radius * radius);
      if (std::isfinite(each)) reach(j, here.cost + length * each / 2, i);
    }
  }

  using Waiting = std::pair<double, int>;
  InscribedBalls& balls_;
  Vec3 from_, to_;
  double spacing_;
  std::vector<Ball> all_;
  std::unordered_map<std::int64_t, int> index_;
  std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> waiting_;
};

}  // namespace

BallPath findBallPath(InscribedBalls& balls, const Vec3& from, const Vec3& to, double spacing) {
  for (int finer = 0; finer <= kFinerLattices; ++finer, spacing /= 2) {
    Search search(balls, from, to, spacing);
    const int last = search.run();
    if (last >= 0) return {search.wayTo(last), {}};
    if (search.isFull()) return {{}, CentreLineFault::tooLongAndThin};
  }
  return {{}, CentreLineFault::noWay};
}

}  // namespace handlebody
