#include "core/io/report/clicks.h"

#include <algorithm>

#include "core/io/report/parse.h"

namespace handlebody {

namespace {

bool isBackground(const ClickText& click) { return click.option.starts_with("--background"); }

Seed inWorld(const Click& click, const Grid& grid) {
  Seed world = click.seed;
  if (!click.isInVoxels) return world;
  world.centre = grid.toWorld(world.centre);
  if (world.radius) *world.radius *= grid.meanSpacing();
  return world;
}

}  // namespace

bool hasNoSeed(const ClickTexts& texts) { return std::all_of(texts.begin(), texts.end(), isBackground); }

std::vector<Click> parseClicks(const ClickTexts& texts) {
  std::vector<Click> clicks;
  for (const ClickText& t : texts) {
    clicks.push_back({parseSeed(t.option, t.text), t.option.ends_with("-ijk")});
    clicks.back().seed.background = isBackground(t);
  }
  return clicks;
}

std::vector<Seed> seedsInWorld(const std::vector<Click>& clicks, const Grid& grid) {
  std::vector<Seed> seeds;
  for (const Click& click : clicks) seeds.push_back(inWorld(click, grid));
  std::stable_partition(seeds.begin(), seeds.end(), [](const Seed& seed) { return !seed.background; });
  return seeds;
}

}  // namespace handlebody
