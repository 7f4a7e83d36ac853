#include "core/io/report/clicks.h"

#include "core/errors.h"
#include "tests/support/catch.h"

using namespace handlebody;

namespace {

//! Turned a quarter about z, with voxels of 2 mm.
Grid turnedGrid() {
  Grid grid;
  grid.size = {10, 10, 10};
  grid.spacing = Vec3(2, 2, 2);
  grid.origin = Vec3(100, 0, 0);
  grid.direction << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  return grid;
}

}  // namespace

TEST_CASE("clicks come inside first, then in the background, in mm before in voxels", "[cli]") {
  ClickTexts texts;
  texts.voxelBackground = {"1,2,3,1.5", "4,5,6"};
  texts.background = {"-1,-2,-3", "1,1,1,7"};
  texts.voxelSeeds = {"0,1,0"};
  texts.seeds = {"9,9,9,2"};
  const std::vector<Seed> seeds = seedsInWorld(parseClicks(texts), turnedGrid());
  const std::vector<Seed> expected{{{9, 9, 9}, 2.0},       {{98, 0, 0}, {}},        {{-1, -2, -3}, {}, true},
                                   {{1, 1, 1}, 7.0, true}, {{96, 2, 6}, 3.0, true}, {{90, 8, 12}, {}, true}};
  CHECK(seeds == expected);
}

TEST_CASE("a click that is no place is refused by the name of its option", "[cli]") {
  using List = std::vector<std::string> ClickTexts::*;
  const std::pair<List, std::string> lists[] = {{&ClickTexts::seeds, "--seed: "},
                                                {&ClickTexts::voxelSeeds, "--seed-ijk: "},
                                                {&ClickTexts::background, "--background: "},
                                                {&ClickTexts::voxelBackground, "--background-ijk: "}};
  for (const auto& [list, option] : lists)
    for (const char* text : {"", "1,2", "1,2,3,4,5", "1,2,3,0", "1,2,3,-1", "1,nan,3", "1,2,inf", "a,b,c"}) {
      INFO(option << text);
      ClickTexts texts;
      texts.seeds = {"1,2,3"};
      (texts.*list).push_back(text);
      CHECK_THROWS_AS(parseClicks(texts), UsageError);
      CHECK_THROWS_WITH(parseClicks(texts), Contains(option));
    }
}

TEST_CASE("the background alone is nowhere to start", "[cli]") {
  ClickTexts texts;
  texts.background = {"1,2,3"};
  texts.voxelBackground = {"1,2,3"};
  CHECK(texts.hasNoSeed());
  texts.voxelSeeds = {"1,2,3"};
  CHECK_FALSE(texts.hasNoSeed());
}
