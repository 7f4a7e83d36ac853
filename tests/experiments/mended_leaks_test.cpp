// Leaks in real volumes, mended as a user would: walls, each put up after going back to before the surface
// came in there. The same walls as options are in docs/leaks.md.

#include "core/collision/certify.h"
#include "core/evolution/history.h"
#include "tests/experiments/real_cases.h"
#include "tests/support/catch.h"
#include "tests/support/wall_support.h"

using namespace handlebody;
using namespace handlebody::testing;

namespace {

struct MendedLeak {
  const char* name;
  IntensityRange range;           // with which it leaks
  int leaked;                     // iterations after which the leak is plain
  std::vector<WallBall> walls;    // mm, LPS: one gesture each
  std::optional<double> tighter;  // upper bound at which it does not leak; none: the automatic choice
  double dice;                    // with the surface without the leak: at least
};

const double kNone = std::numeric_limits<double>::infinity();

const MendedLeak kLeaks[] = {
    {"us_vessel",
     {-kNone, 34.17},
     100,
     {{{11.3, -19.6, 126.7}, 15},
      {{0.5, -5.3, 146}, 18},
      {{-25.5, -5.5, 140.1}, 18},
      {{16.8, -12.3, 109.8}, 10},
      {{-27.3, 12, 100.7}, 22}},
     {},
     0.85},
    {"ventricle", {-kNone, 189.56}, 120, {{{312, -39, 455.5}, 6}}, {}, 0.94},
    {"trachea",
     {-kNone, -760},
     235,
     {{{61, -146.2, 703.1}, 8}, {{-45.5, -156, 725.3}, 6}, {{-46, -141, 726.4}, 8}},
     -770,
     0.94},
    {"aorta",
     {355.06, kNone},
     120,
     {{{21.3, -183.7, 654.2}, 12}, {{-17.7, -168.7, 708.2}, 12}, {{-11.7, -174.7, 747.2}, 6}},
     {},
     0.97},
};

ActiveContour begun(const RealCase& c, std::optional<IntensityRange> range) {
  Volume volume = readVolume(folder() + "/" + c.volume);
  Parameters parameters;
  parameters.object = c.object;
  parameters.range = range;
  const Seed seed{volume.grid.toWorld(c.seedIndex), c.radiusVoxels * volume.grid.meanSpacing()};
  return {std::move(volume), {seed}, parameters};
}

double diceWith(const Mesh& mesh, const Volume& label) { return dice(mesh.compact(), label); }

//! On to this iteration; how large the surface was, in mm³, when the leak alarm came first.
std::optional<double> volumeAtAlarm(History& history, int until) {
  std::optional<double> volume;
  while (history.stopReason() == StopReason::running && history.iteration() < until) {
    history.advance();
    if (!volume && !history.steps().back().leaks.empty())
      volume = certify(history.shown().mesh().compact()).volume;
  }
  return volume;
}

//! The wall where the surface is not yet in it, and on from there. Walls that came later on the way stay.
void putUp(History& history, const WallBall& wall) {
  Request request{history.seeds(), history.parameters(), history.constraints()};
  request.constraints.walls.balls.push_back(wall);
  const auto free = history.lastFree({{wall}, {}, {}, {}});
  REQUIRE(free);
  history.goTo(*free);
  history.change(request);
}

}  // namespace

TEST_CASE("a leak in a real volume is mended by at most five walls", "[real][leaks][mended]") {
  if (volumesMissing()) return;
  const MendedLeak leak = GENERATE(from_range(std::begin(kLeaks), std::end(kLeaks)));
  const RealCase& c = caseOf(leak.name);
  std::optional<IntensityRange> tight;
  if (leak.tighter) tight = IntensityRange{-kNone, *leak.tighter};
  ActiveContour meant = begun(c, tight);
  while (meant.stopReason() == StopReason::running) meant.step();
  const Volume truth = rasterize(meant.mesh().compact(), meant.grid());

  History history(begun(c, leak.range));
  const std::optional<double> alarm = volumeAtAlarm(history, leak.leaked);
  const double meantVolume = certify(meant.mesh().compact()).volume;
  INFO(leak.name);
  CHECK(alarm.value_or(kNone) < 1.05 * meantVolume);
  const double leaked = diceWith(history.shown().mesh(), truth);
  CHECK(leaked < 0.8);
  for (const WallBall& wall : leak.walls) putUp(history, wall);
  while (history.stopReason() == StopReason::running) {
    history.advance();
    REQUIRE(history.iteration() < 600);
  }
  CHECK(leak.walls.size() <= 5);
  CHECK(history.stopReason() == StopReason::converged);
  CHECK(clearance(history.shown().mesh(), leak.walls) > 0);
  const Certificate certificate = certify(history.shown().mesh().compact());
  CHECK(certificate.passes());
  const double mended = diceWith(history.shown().mesh(), truth);
  CHECK(mended >= leak.dice);
  std::cout << leak.name << ": alarm at " << alarm.value_or(kNone) / meantVolume << " of the volume, Dice "
            << leaked << " at iteration " << leak.leaked << ", after " << leak.walls.size() << " walls "
            << mended << ", " << certificate.volume / 1000 << " ml\n";
}
