// Vetoes and limits of the topology on the paper's phantoms.

#include "core/evolution/held_changes.h"

#include "core/mesh/topology.h"
#include "tests/experiments/experiment_support.h"
#include "tests/support/wall_support.h"

using namespace handlebody;
using namespace handlebody::testing;

namespace {

ActiveContour begun(const Phantom& phantom, const Constraints& constraints = {}) {
  return {phantom.volume, {{phantom.seed, phantom.seedRadius}}, {}, constraints};
}

std::vector<Event> run(ActiveContour& contour) {
  std::vector<Event> events;
  while (contour.stopReason() == StopReason::running)
    for (Event& e : contour.step().events) events.push_back(std::move(e));
  return events;
}

//! mm from p to the mesh.
double distanceTo(const Mesh& mesh, const Vec3& p, double limit) {
  double least = limit;
  for (const Triangle& t : mesh.faces()) {
    if (t[0] < 0) continue;
    const Vec3& a = mesh.position(t[0]);
    if ((a - p).norm() > least + 6) continue;
    least = std::min(least, bruteDistance(p, a, mesh.position(t[1]), mesh.position(t[2])));
  }
  return least;
}

}  // namespace

TEST_CASE("genus3 with one handle vetoed is of genus 2, elsewhere the same surface", "[veto]") {
  Phantom phantom = makePhantom("genus3");
  // On one of its four arcs, so that the fronts come around to three places: in the crossing at which the
  // phantom's own seed lies they would meet in one, as one handle of four.
  phantom.seed = Vec3(78.5, 49.5, 51);
  phantom.seedRadius = 4;
  ActiveContour free = begun(phantom);
  const std::vector<Event> events = run(free);
  const auto raises = [](const Event& e) {
    return changesTopology(e.kind) && e.after.genus == e.before.genus + 1;
  };
  REQUIRE(std::count_if(events.begin(), events.end(), raises) == 3);
  const Event last = *std::find_if(events.rbegin(), events.rend(), raises);
  ActiveContour vetoed = begun(phantom, {{}, {{last.iteration, last.location}}, {}});
  run(vetoed);
  const Certificate c = certify(vetoed.mesh().compact());
  CHECK(c.passes());
  CHECK(c.components == 1);
  CHECK(c.genus == std::vector<int>{2});
  REQUIRE(vetoed.held().size() == 1);

  // The arcs are some 14 mm thick: from the middle of the gap its caps reach no further.
  constexpr double kReach = 14;
  double largest = 0, elsewhere = 0;
  for (int v = 0; v < vetoed.mesh().vertexSlots(); ++v) {
    if (!vetoed.mesh().isVertex(v)) continue;
    const Vec3& p = vetoed.mesh().position(v);
    const double d = distanceTo(free.mesh(), p, 30);
    largest = std::max(largest, d);
    if ((p - last.location).norm() > kReach) elsewhere = std::max(elsewhere, d);
  }
  std::cout << "genus3 without the handle of iteration " << last.iteration << ": largest distance "
            << elsewhere << " mm further than " << kReach << " mm from there, " << largest << " mm in all\n";
  CHECK(elsewhere < 1);  // a voxel
}

TEST_CASE("the cube of genus 5 is as tunnelled as it may be, and no more", "[veto]") {
  const int most = GENERATE(0, 2);
  const Phantom phantom = makePhantom("cube");
  ActiveContour contour = begun(phantom, {{}, {}, {{}, most}});
  const std::vector<Event> events = run(contour);
  const Certificate c = certify(contour.mesh().compact());
  CHECK(c.passes());
  int genus = 0;
  for (const int g : c.genus) genus += g;
  CHECK(genus == most);
  int held = 0;
  for (const Event& e : events) {
    CHECK(e.after.genus <= most);
    held += e.held.has_value();
  }
  const double dice = overlap(phantom, contour.mesh().compact()).dice;
  std::cout << "cube with genus " << most << ": " << stopReasonName(contour.stopReason()) << " after "
            << contour.iteration() << " iterations, " << held << " changes held, Dice " << dice << '\n';
  CHECK(held >= 5 - most);
  CHECK(dice > 0.95);
}
