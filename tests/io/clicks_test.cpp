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

TEST_CASE("clicks come inside first, each side in the order given, in mm or in voxels", "[cli]") {
  const ClickTexts texts{{"--background-ijk", "1,2,3,1.5"}, {"--seed-ijk", "0,1,0"},
                         {"--background", "-1,-2,-3"},      {"--seed", "9,9,9,2"},
                         {"--background-ijk", "4,5,6"},     {"--background", "1,1,1,7"}};
  const std::vector<Seed> seeds = seedsInWorld(parseClicks(texts), turnedGrid());
  const std::vector<Seed> expected{{{98, 0, 0}, {}},         {{9, 9, 9}, 2.0},        {{96, 2, 6}, 3.0, true},
                                   {{-1, -2, -3}, {}, true}, {{90, 8, 12}, {}, true}, {{1, 1, 1}, 7.0, true}};
  CHECK(seeds == expected);
}

TEST_CASE("a click that is no place is refused by the name of its option", "[cli]") {
  for (const std::string option : {"--seed", "--seed-ijk", "--background", "--background-ijk"})
    for (const char* text : {"", "1,2", "1,2,3,4,5", "1,2,3,0", "1,2,3,-1", "1,nan,3", "1,2,inf", "a,b,c"}) {
      INFO(option << text);
      const ClickTexts texts{{"--seed", "1,2,3"}, {option, text}};
      CHECK_THROWS_AS(parseClicks(texts), UsageError);
      CHECK_THROWS_WITH(parseClicks(texts), Contains(option + ": "));
    }
}

TEST_CASE("the background alone is nowhere to start", "[cli]") {
  ClickTexts texts{{"--background", "1,2,3"}, {"--background-ijk", "1,2,3"}};
  CHECK(hasNoSeed(texts));
  texts.push_back({"--seed-ijk", "1,2,3"});
  CHECK_FALSE(hasNoSeed(texts));
}
