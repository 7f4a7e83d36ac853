#include "core/io/report/clicks.h"

#include <algorithm>

#include "core/io/report/parse.h"

namespace handlebody {

namespace {

void append(std::vector<Seed>& seeds, const std::string& option, const std::vector<std::string>& texts,
            bool background) {
  for (const std::string& text : texts) {
    seeds.push_back(parseSeed(option, text));
    seeds.back().background = background;
  }
}

Seed inWorld(const Seed& voxels, const Grid& grid) {
  Seed world = voxels;
  world.centre = grid.toWorld(voxels.centre);
  if (world.radius) *world.radius *= grid.meanSpacing();
  return world;
}

}  // namespace

Clicks parseClicks(const ClickTexts& texts) {
  Clicks clicks;
  append(clicks.world, "--seed", texts.seeds, false);
  append(clicks.voxels, "--seed-ijk", texts.voxelSeeds, false);
  append(clicks.world, "--background", texts.background, true);
  append(clicks.voxels, "--background-ijk", texts.voxelBackground, true);
  return clicks;
}

std::vector<Seed> seedsInWorld(const Clicks& clicks, const Grid& grid) {
  std::vector<Seed> seeds = clicks.world;
  for (const Seed& seed : clicks.voxels) seeds.push_back(inWorld(seed, grid));
  std::stable_partition(seeds.begin(), seeds.end(), [](const Seed& seed) { return !seed.background; });
  return seeds;
}

}  // namespace handlebody
