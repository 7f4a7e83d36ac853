#include "core/evolution/painted_pins.h"

#include <algorithm>

namespace handlebody {

namespace {

//! With its rim, as for a pin.
template <typename Ball>
bool lies(const Vec3& p, const Ball& ball) {
  return (p - ball.centre).squaredNorm() <= ball.radius * ball.radius;
}

}  // namespace

std::vector<bool> heldBy(const std::vector<Pin>& pins, const std::vector<Vec3>& vertices,
                         const std::vector<bool>& held, int iteration) {
  std::vector<bool> out(vertices.size(), false);
  for (const Pin& pin : pins) {
    if (pin.iteration > iteration) continue;
    for (std::size_t v = 0; v < vertices.size(); ++v)
      if (!out[v] && (pin.iteration == iteration || held[v])) out[v] = lies(vertices[v], pin);
  }
  return out;
}

std::vector<Pin> pinsOf(const std::vector<WallBall>& stroke, const std::vector<Vec3>& vertices,
                        const std::vector<bool>& held, int iteration) {
  std::vector<bool> known = held;
  std::vector<Pin> pins;
  for (const WallBall& ball : stroke) {
    bool holdsMore = false;
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      if (known[v] || !lies(vertices[v], ball)) continue;
      known[v] = holdsMore = true;
    }
    if (holdsMore) pins.push_back({ball.centre, ball.radius, iteration});
  }
  return pins;
}

std::vector<Pin> unpinned(std::vector<Pin> pins, const std::vector<WallBall>& eraser,
                          const std::vector<Vec3>& vertices, const std::vector<bool>& held) {
  std::vector<Vec3> touched;
  for (std::size_t v = 0; v < vertices.size(); ++v)
    if (held[v] && std::any_of(eraser.begin(), eraser.end(),
                               [&](const WallBall& ball) { return lies(vertices[v], ball); }))
      touched.push_back(vertices[v]);
  std::erase_if(pins, [&](const Pin& pin) {
    return std::any_of(touched.begin(), touched.end(), [&](const Vec3& p) { return lies(p, pin); });
  });
  return pins;
}

}  // namespace handlebody
