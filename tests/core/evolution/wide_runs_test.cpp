#include "core/evolution/wide_runs.h"

#include <random>

#include "core/indices.h"
#include "tests/support/catch.h"

using namespace handlebody;

namespace {

constexpr std::array<int, 3> kSize{9, 8, 7};

std::size_t cellAt(int x, int y, int z) { return (idx(z) * idx(kSize[1]) + idx(y)) * idx(kSize[0]) + idx(x); }

//! Widths from 1 to 3 in three of five cells, the outermost layer left out.
std::vector<float> randomWidths(std::mt19937& random) {
  std::vector<float> width(cellAt(0, 0, kSize[2]), 0.0f);
  std::uniform_int_distribution<int> draw(-1, 3);
  for (int z = 1; z < kSize[2] - 1; ++z)
    for (int y = 1; y < kSize[1] - 1; ++y)
      for (int x = 1; x < kSize[0] - 1; ++x)
        width[cellAt(x, y, z)] = static_cast<float>(std::max(0, draw(random)));
  return width;
}

//! The same cell by cell.
bool allReached(const std::vector<float>& width, std::uint32_t start, double least, Touching touching) {
  std::vector<bool> isReached(width.size(), false);
  std::vector<std::size_t> front;
  const auto isWide = [&](std::size_t c) { return static_cast<double>(width[c]) >= least; };
  const auto enter = [&](std::size_t c) {
    if (isReached[c] || !isWide(c)) return;
    isReached[c] = true;
    front.push_back(c);
  };
  enter(start);
  while (!front.empty()) {
    const std::size_t c = front.back();
    front.pop_back();
    for (int dz = -1; dz <= 1; ++dz)
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
          if (touching == Touching::corners || std::abs(dx) + std::abs(dy) + std::abs(dz) == 1)
            enter(c + cellAt(dx + 1, dy + 1, dz + 1) - cellAt(1, 1, 1));
  }
  for (std::size_t c = 0; c < width.size(); ++c)
    if (isWide(c) && !isReached[c]) return false;
  return true;
}

}  // namespace

TEST_CASE("whether all that is wide hangs together with a start is found in runs as it is cell by cell") {
  std::mt19937 random(4);
  std::array<int, 2> held{};
  for (int run = 0; run < 400; ++run) {
    std::vector<float> width = randomWidths(random);
    if (run % 2 == 0)  // else hardly ever all of it
      for (float& w : width) w = w == 1 ? 3.0f : w;
    const auto start = static_cast<std::uint32_t>(cellAt(4, 4, 3));
    for (const Touching touching : {Touching::faces, Touching::corners})
      for (const double least : {1.0, 2.0, 3.0}) {
        CAPTURE(run, least, touching);
        const bool expected = allReached(width, start, least, touching);
        CHECK(WideRuns(kSize, width, touching).allHold(std::array{start}, least) == expected);
        held[touching == Touching::faces ? 0 : 1] += expected;
      }
  }
  CHECK(held[0] > 10);
  CHECK(held[1] > held[0]);
}
