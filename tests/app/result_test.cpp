// What a user is warned of.

#include "core/io/report/result.h"

#include "tests/support/catch.h"
#include "tests/support/mesh_zoo.h"

using namespace handlebody;

namespace {

const Vec3 kCentre(50, 50, 50);

//! A run from a seed of 5 mm in the middle of 100³ voxels.
RunReport reportOf(StopReason stopped) {
  RunReport report;
  report.stopped = stopped;
  report.volume.grid.size = {100, 100, 100};
  ResolvedParameters resolved;
  resolved.seeds = {{kCentre, 5.0}};
  resolved.edgeLength = 2;
  report.session.resolved = resolved;
  return report;
}

TriangleSoup sphere(double radius) { return zoo::moved(zoo::scaled(zoo::sphere(4), radius), kCentre); }

bool mentions(const std::vector<Finding>& findings, const char* word) {
  return sentence(findings).find(word) != std::string::npos;
}

}  // namespace

TEST_CASE("a surface that has grown and converged gives no doubts") {
  CHECK(resultWarnings(reportOf(StopReason::converged), sphere(20)).empty());
}

TEST_CASE("a surface that has contracted from an over-grown start gives no doubts") {
  RunReport report = reportOf(StopReason::converged);
  report.session.resolved->seeds[0].radius = 40;
  CHECK(resultWarnings(report, sphere(20)).empty());
}

TEST_CASE("a surface that rests because it was frozen or got stuck is doubted, and for the right reason") {
  CHECK(resultWarnings(reportOf(StopReason::frozen), sphere(20)).size() == 1);
  CHECK(mentions(resultWarnings(reportOf(StopReason::frozen), sphere(20)), "would still move"));
  CHECK(mentions(resultWarnings(reportOf(StopReason::stuck), sphere(20)), "stuck"));
}

TEST_CASE("a surface that is still at its seed is doubted, with the curvature named where it is the cause") {
  RunReport report = reportOf(StopReason::converged);
  CHECK(mentions(resultWarnings(report, sphere(5.2)), "hardly grew"));
  CHECK_FALSE(mentions(resultWarnings(report, sphere(5.2)), "--curvature"));
  report.session.resolved->curvature = 3;  // holds fronts of 3 · 2 mm
  CHECK(
      mentions(resultWarnings(report, sphere(5.2)), "--curvature holds every front of a radius below 6 mm"));
}

TEST_CASE("a click in the background is not where the surface started") {
  RunReport report = reportOf(StopReason::converged);
  report.session.resolved->seeds.push_back({kCentre + Vec3(30, 0, 0), {}, true});
  CHECK(mentions(resultWarnings(report, sphere(5.2)), "hardly grew"));
  CHECK(resultWarnings(report, sphere(20)).empty());
  report.session.resolved->seeds.back() = {kCentre, 20.0, true};
  CHECK(resultWarnings(report, sphere(20)).empty());
}

TEST_CASE("a close choice is doubted, with what the next candidate holds") {
  RunReport report = reportOf(StopReason::converged);
  report.candidates.resize(3);
  report.candidates[0].volume = 4510;
  report.candidates[0].score = 0.618;
  report.candidates[1].volume = 1234567;
  CHECK(resultWarnings(report, sphere(20)).empty());
  report.isCloseChoice = true;
  CHECK(sentences(resultWarnings(report, sphere(20))) ==
        std::vector<std::string>{
            "the choice among 3 objects is close (expected overlap with the one that is meant: "
            "Dice 0.62): the next candidate holds 1235 ml where this one holds 4.51 ml; "
            "see --candidate"});
}

TEST_CASE("a choice that is the only one, or was made by hand, is not doubted") {
  RunReport report = reportOf(StopReason::converged);
  report.isCloseChoice = true;
  CHECK(resultWarnings(report, sphere(20)).empty());
  report.candidates.resize(1);
  CHECK(resultWarnings(report, sphere(20)).empty());
  report.candidates.resize(2);
  report.session.resolved->candidate = 2;
  CHECK(resultWarnings(report, sphere(20)).empty());
}

TEST_CASE(
    "what is to be known of the files of walls and starts is told once, and anonymously without names") {
  RunReport report = reportOf(StopReason::converged);
  const std::vector<Finding> told{
      {FindingKind::ofFile, {{"file", std::string("/doe/w.nrrd")}}, FindingKind::axesTakenAsLps}};
  report.session.constraints.walls.map = WallMap{"/doe/w.nrrd", "ab", nullptr, told};
  ParameterChange later;
  later.constraints = report.session.constraints;
  report.session.changes = {later};
  report.warnings = resultWarnings(report, sphere(20));
  REQUIRE(report.warnings.size() == 1);
  CHECK(mentions(report.warnings, "/doe/w.nrrd: The header does not say"));
  const RunReport shown = anonymous(report);
  CHECK_FALSE(mentions(shown.warnings, "/doe"));  // the header "does not say"
  CHECK(mentions(shown.warnings, "The header does not say"));
}
