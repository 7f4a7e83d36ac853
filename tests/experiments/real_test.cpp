// Real volumes, where the machine has them (HANDLEBODY_VOLUMES, or shared/volumes beside the sources):
// whatever the image is like, the mesh that comes out is certified.

#include <algorithm>
#include <iostream>
#include <numeric>
#include <string>
#include <vector>

#include "core/collision/certify.h"
#include "core/evolution/active_contour.h"
#include "tests/experiments/real_cases.h"
#include "tests/support/catch.h"
#include "tests/support/wall_support.h"
#ifdef HANDLEBODY_WITH_ORACLE
#include "tests/collision_oracle/oracle.h"
#endif

using namespace handlebody;
using namespace handlebody::testing;

namespace {

struct RealOutcome {
  double millilitres = 0;
  double dice = 0;  // 0 without a label
  std::vector<Finding> warnings;
};

ActiveContour begun(const RealCase& c, const Constraints& constraints = {}) {
  Volume volume = readVolume(folder() + "/" + c.volume);
  Parameters parameters;
  parameters.object = c.object;
  const Seed seed{volume.grid.toWorld(c.seedIndex), c.radiusVoxels * volume.grid.meanSpacing()};
  return {std::move(volume), {seed}, parameters, constraints};
}

//! Grows the case, expects it to converge to a certified mesh, and says what came out.
RealOutcome expectCertified(const std::string& name) {
  const RealCase& c = caseOf(name);
  ActiveContour contour = begun(c);
  while (contour.stopReason() == StopReason::running) contour.step();
  const TriangleSoup mesh = contour.mesh().compact();
  const Certificate certificate = certify(mesh);
  CHECK(certificate.passes());
  CHECK(contour.stopReason() == StopReason::converged);
#ifdef HANDLEBODY_WITH_ORACLE
  CHECK(oracle::selfIntersections(mesh).empty());
#endif
  RealOutcome out{certificate.volume / 1000, 0, contour.warnings(contour.support())};
  if (c.label) out.dice = dice(mesh, readVolume(folder() + "/" + c.label));
  std::cout << c.name << ": iterations " << contour.iteration() << ", vertices " << certificate.vertices
            << ", components " << certificate.components << ", volume " << out.millilitres << " ml";
  if (c.label) std::cout << ", Dice " << out.dice;
  std::cout << '\n';
  for (const Finding& warning : out.warnings) std::cout << "  " << sentence(warning) << '\n';
  return out;
}

bool warnsOf(const RealOutcome& o, FindingKind kind) {
  return std::any_of(o.warnings.begin(), o.warnings.end(),
                     [&](const Finding& warning) { return warning.kind == kind; });
}

}  // namespace

// Each gives a certified mesh with nothing given but the seed and the kind of object.

TEST_CASE("the spinal cord in an MR volume agrees with the manual label", "[real]") {
  if (volumesMissing()) return;
  CHECK(expectCertified("cord").dice >= 0.93);
}

TEST_CASE("the aorta in a CT angiography agrees with the label and is held at a neck, with a warning",
          "[real]") {
  if (volumesMissing()) return;
  const RealOutcome o = expectCertified("aorta");
  CHECK(o.dice >= 0.87);
  CHECK(warnsOf(o, FindingKind::heldAtNeck));
}

TEST_CASE("the aorta with walls all over its surface and no tunnel allowed keeps both",
          "[real][walls][veto]") {
  if (volumesMissing()) return;
  const RealCase& c = caseOf("aorta");
  ActiveContour free = begun(c);
  while (free.stopReason() == StopReason::running) free.step();
  const TriangleSoup surface = free.mesh().compact();
  const Certificate unbound = certify(surface);
  CHECK(std::accumulate(unbound.genus.begin(), unbound.genus.end(), 0) > 0);
  constexpr std::size_t kWalls = 30;
  const Vec3 seed = free.parameters().seeds[0].centre;
  Constraints constraints{{}, {}, {{}, 0}};
  for (std::size_t i = 0; i < kWalls; ++i) {
    const Vec3& p = surface.points[(2 * i + 1) * surface.points.size() / (2 * kWalls)];
    if ((p - seed).norm() > 12) constraints.walls.balls.push_back({p, 2.0});
  }
  REQUIRE(constraints.walls.balls.size() > kWalls / 2);

  ActiveContour bound = begun(c, constraints);
  double least = clearance(bound.mesh(), constraints.walls.balls);
  while (bound.stopReason() == StopReason::running) {
    bound.step();
    least = std::min(least, clearance(bound.mesh(), constraints.walls.balls));
  }
  const Certificate certificate = certify(bound.mesh().compact());
  CHECK(least > 0);
  CHECK(certificate.passes());
  CHECK(std::accumulate(certificate.genus.begin(), certificate.genus.end(), 0) == 0);
  CHECK(certificate.volume == Approx(unbound.volume).epsilon(0.1));
  std::cout << "aorta with " << constraints.walls.balls.size() << " walls, nearest " << least << " mm, "
            << bound.held().size() << " places held: " << certificate.volume / 1000 << " ml, "
            << unbound.volume / 1000 << " ml without\n";
}

TEST_CASE("the trachea in a CT volume has 24 ml, within 5 %", "[real]") {
  if (volumesMissing()) return;
  CHECK(expectCertified("trachea").millilitres == Approx(24).epsilon(0.05));
}

TEST_CASE("the ventricle in an MR volume has 20 to 30 ml", "[real]") {
  if (volumesMissing()) return;
  const double millilitres = expectCertified("ventricle").millilitres;
  CHECK(millilitres >= 20);
  CHECK(millilitres <= 30);
}

TEST_CASE("the vessel in an ultrasound volume is held between its walls, with a warning", "[real]") {
  // It opens into acoustic shadow as dark as itself. From seeds all over the lumen: 2.8 to 3.0 ml.
  if (volumesMissing()) return;
  const RealOutcome o = expectCertified("us_vessel");
  CHECK(o.millilitres > 2.5);
  CHECK(o.millilitres < 3.5);
  CHECK(warnsOf(o, FindingKind::heldWhereItWidens));
  CHECK(warnsOf(o, FindingKind::noEdge));
}
