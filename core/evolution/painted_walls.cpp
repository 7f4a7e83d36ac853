#include "core/evolution/painted_walls.h"

#include <algorithm>

#include "core/evolution/wall_disc.h"

namespace handlebody {

namespace {

constexpr double kApart = 0.5;       // radii between two balls of a stroke
constexpr double kStandsOut = 0.25;  // radii: what stands out less of a ball that is there adds nothing

//! True if nearly all of `ball` lies in `other`.
bool liesIn(const WallBall& ball, const WallBall& other) {
  const double free = other.radius - (1 - kStandsOut) * ball.radius;
  return free >= 0 && (ball.centre - other.centre).squaredNorm() <= free * free;
}

}  // namespace

void drawTo(std::vector<WallBall>& stroke, const Vec3& to, double radius) {
  if (stroke.empty()) {
    stroke.push_back({to, radius});
    return;
  }
  const double step = kApart * std::min(radius, stroke.back().radius);
  const Vec3 way = to - stroke.back().centre;
  const double length = way.norm();
  const Vec3 from = stroke.back().centre;
  const int balls = static_cast<int>(length / step);
  for (int i = 1; i <= balls; ++i) stroke.push_back({from + (i * step / length) * way, radius});
}

WallList painted(WallList walls, const std::vector<WallBall>& stroke) {
  for (const WallBall& ball : stroke)
    if (std::none_of(walls.balls.begin(), walls.balls.end(),
                     [&](const WallBall& other) { return liesIn(ball, other); }))
      walls.balls.push_back(ball);
  return walls;
}

WallList erased(WallList walls, const std::vector<WallBall>& eraser) {
  std::erase_if(walls.balls, [&](const WallBall& wall) {
    return std::any_of(eraser.begin(), eraser.end(), [&](const WallBall& e) {
      const double reach = wall.radius + e.radius;
      return (wall.centre - e.centre).squaredNorm() <= reach * reach;
    });
  });
  std::erase_if(walls.discs, [&](const WallDisc& wall) {
    const DiscShape shape(wall);
    return std::any_of(eraser.begin(), eraser.end(),
                       [&](const WallBall& e) { return shape.distance(e.centre) <= e.radius; });
  });
  return walls;
}

std::vector<WallBall> reachingInto(const Grid& grid, std::vector<WallBall> stroke) {
  std::erase_if(stroke, [&](const WallBall& ball) {
    Vec3 index = grid.toIndex(ball.centre);
    for (int a = 0; a < 3; ++a) index[a] = std::clamp(index[a], -0.5, grid.size[a] - 0.5);
    return (grid.toWorld(index) - ball.centre).norm() >= ball.radius;
  });
  return stroke;
}

int coveredSeed(const std::vector<Seed>& seeds, const std::vector<WallBall>& walls, double room) {
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    const Seed& seed = seeds[i];
    if (seed.background) continue;
    const double needed = std::min(seed.radius.value_or(room), room);
    for (const WallBall& wall : walls)
      if ((wall.centre - seed.centre).norm() - wall.radius < needed) return static_cast<int>(i);
  }
  return -1;
}

}  // namespace handlebody
