// The beating phantom as a whole: docs/time.md has its figures.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <map>

#include "core/sequence/drift.h"
#include "tests/sequence/beating_support.h"
#include "tests/support/catch.h"

using namespace handlebody;
using namespace handlebody::test;

namespace {

struct Figures {
  double leastDice = 1;
  double single = 0, carried = 0;  // processor seconds: of the frame that is grown, of one that is carried
  double ejection = 0;
  bool sameTopology = true, allTrusted = true;
};

double secondsBetween(std::clock_t a, std::clock_t b) { return static_cast<double>(b - a) / CLOCKS_PER_SEC; }

Figures figuresOf(const BeatingPhantom& phantom) {
  const int last = phantom.options().frames - 1;
  std::map<int, Volume> images;
  for (int f = 0; f <= last; ++f) images[f] = phantom.image(f);  // not part of the time
  const std::clock_t begin = std::clock();
  const GrownFrame grown = growIn(images.at(0), 0, {{{phantom.seed()}}, {}, {}});
  const std::clock_t middle = std::clock();
  const FrameCarrier carrier(grown.settings, hooksOf([&](int f) { return images.at(f); }));
  std::vector<FrameResult> frames = carryThrough(carrier, grown.result, last);
  const std::clock_t end = std::clock();
  frames.insert(frames.begin(), grown.result);
  Figures out;
  out.single = secondsBetween(begin, middle);
  out.carried = secondsBetween(middle, end) / last;
  for (const FrameResult& r : frames) {
    out.allTrusted = out.allTrusted && r.isTrusted();
    out.sameTopology = out.sameTopology && r.components == 1 && r.genus == 0;
    out.leastDice = std::min(out.leastDice, diceOf(r.mesh, phantom.truth(r.frame)));
  }
  out.ejection = curveOf(frames).ejectionFraction;
  FrameResult beside = frames.back();
  beside.shownIn = last;
  beside.frame = -1;
  const FrameResult back = carrier.carry(beside, 0);
  const Drift drift = driftBetween(grown.result.mesh, back.mesh, grown.settings.edgeLength);
  std::printf(
      "ejection %.0f %% %s: found %.2f %%, least Dice %.4f, first frame %.2f s, each other %.2f s, "
      "around the cycle Dice %.4f, %.3f mm\n",
      100 * phantom.sampledEjection(), phantom.options().speckle ? "speckle" : "noise", 100 * out.ejection,
      out.leastDice, out.single, out.carried, drift.dice, drift.mean);
  std::fflush(stdout);
  return out;
}

}  // namespace

TEST_CASE("twenty frames with an ejection fraction of 30 to 70 per cent, in noise and in speckle",
          "[.][time-slow]") {
  // A fifth of it takes half a minute; HANDLEBODY_BEATING=all makes the table of docs/time.md.
  const bool isWhole = std::getenv("HANDLEBODY_BEATING") != nullptr;
  for (const bool speckle : {false, true})
    for (const double ejection : {0.3, 0.4, 0.5, 0.6, 0.7}) {
      if (!isWhole && ejection != (speckle ? 0.5 : 0.7)) continue;
      BeatingOptions options;
      options.ejection = ejection;
      options.speckle = speckle;
      options.image.spacing = Vec3::Constant(1.5);
      const BeatingPhantom phantom(options);
      const Figures f = figuresOf(phantom);
      INFO("ejection " << ejection << (speckle ? ", speckle" : ", noise"));
      CHECK(std::abs(f.ejection - ejection) < 0.02);
      CHECK(f.leastDice >= 0.97);
      CHECK(f.sameTopology);
      CHECK(f.allTrusted);
      CHECK(f.carried <= 2 * f.single);
    }
}
