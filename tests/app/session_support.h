#pragma once
// A session with everything in it, as a file and as JSON.

#include <limits>
#include <nlohmann/json.hpp>
#include <string>

#include "core/io/report/session.h"
#include "tests/app/temp_folder.h"
#include "tests/support/catch.h"

namespace handlebody::test {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Nothing at its default, and numbers that have no short decimal form.
inline Session unusualSession(const std::string& volume) {
  Session s;
  s.version = "1.2.3";
  s.volume = {volume, "00ff", {"1.2.840.1", 3, Vec3(0.1, 1.0 / 3.0, 7), UnevenSlices::refuse}};
  s.seeds = {{{0.1, -1.0 / 3.0, 1e-300}, 2.0 / 7.0}, {{1e300, 0, -0.0}, {}}, {{-7, 1e-3, 0.1}, 0.6, true}};
  s.requested.object = ObjectKind::bright;
  s.requested.range = IntensityRange{-kInfinity, 100.0 / 3.0};
  s.requested.candidate = 3;
  s.requested.smoothing = 0.7;
  s.requested.edgeLength = 1.0 / 9.0;
  s.requested.direction = Direction::both;
  s.requested.balloon = 0.3;
  s.requested.curvature = 0.6;
  s.requested.maxIterations = 17;
  s.requested.threads = 2;
  s.space = CoordinateSpace::ras;
  s.polish = true;
  Parameters later = s.requested;
  later.range = IntensityRange{-3, kInfinity};
  later.candidate = 2;
  later.smoothing.reset();
  later.balloon = 1.0 / 7.0;
  s.constraints = {{{{{1.0 / 3.0, -2, 1e-7}, 0.3}}, WallMap{volume + ".walls.mha", "ab12", nullptr}},
                   {{7, {0.1, 0.2, 1.0 / 3.0}}},
                   {4, 0}};
  s.changes = {{0, later, {}, {}},
               {9, s.requested, {{{{1, 2.0 / 3.0, 3}, {}}, {{4, 5, 6}, 0.1, true}}}, {}},
               {11, s.requested, {}, Constraints{{{{{4, 5, 6}, 7}}, {}}, {}, {{}, 2}}},
               {12, s.requested, {}, Constraints{}}};
  s.stopAt = 12;
  s.view = R"({"zoom":1.5})";
  return s;
}

inline nlohmann::json validJson() {
  const TempFolder folder;
  writeSession(unusualSession(folder / "v.mha"), folder / "s.json");
  return nlohmann::json::parse(readBytes(folder / "s.json"));
}

}  // namespace handlebody::test
