#include "core/sequence/volume_curve.h"

#include "core/io/report/over_time_report.h"
#include "tests/support/catch.h"

using namespace handlebody;

namespace {

std::vector<VolumePoint> pointsOf(const std::vector<double>& volumes) {
  std::vector<VolumePoint> points;
  for (const double v : volumes) {
    VolumePoint p;
    p.frame = static_cast<int>(points.size());
    p.time = 40.0 * p.frame;
    p.volume = v;
    points.push_back(p);
  }
  return points;
}

}  // namespace

TEST_CASE(
    "end-diastole has the largest volume, end-systole the smallest, and the fraction is of the largest") {
  const VolumeCurve c = volumeCurve(pointsOf({90e3, 120e3, 60e3, 48e3, 110e3}));
  REQUIRE(c.endDiastole == 1u);
  REQUIRE(c.endSystole == 3u);
  CHECK(c.strokeVolume == Approx(72e3));
  CHECK(c.ejectionFraction == Approx(0.6));
}

TEST_CASE("frames that are not trusted or have no surface do not count") {
  std::vector<VolumePoint> points = pointsOf({100e3, 300e3, 10e3, 50e3});
  points[1].isTrusted = false;
  points[2].volume.reset();
  const VolumeCurve c = volumeCurve(points);
  CHECK(c.endDiastole == 0u);
  CHECK(c.endSystole == 3u);
  CHECK(c.ejectionFraction == Approx(0.5));
  CHECK(c.points.size() == 4);
  points[3].isTrusted = false;
  const VolumeCurve one = volumeCurve(points);
  CHECK_FALSE(one.endDiastole.has_value());
  CHECK(one.strokeVolume == 0);
}

TEST_CASE("the table has a row for each frame, and quotes what went wrong") {
  OverTimeReport report;
  std::vector<VolumePoint> points = pointsOf({100e3, 40e3, 70e3});
  points[2].isTrusted = false;
  points[2].time.reset();
  report.curve = volumeCurve(points);
  for (int f = 0; f < 3; ++f) {
    FrameResult r;
    r.frame = f;
    if (f > 0) r.from = f - 1;
    report.frames.push_back(r);
  }
  report.frames[2].faults.push_back(
      {FrameFault::jumped, {FindingKind::other, {{"text", std::string("a \"jump\", said so")}}}});
  const std::string text = curveCsv(report);
  CHECK_THAT(text, Catch::Matchers::StartsWith("frame,time_ms,volume_ml,phase,trusted,"));
  CHECK_THAT(text, Catch::Matchers::Contains("\n0,0,100,end-diastole,yes,"));
  CHECK_THAT(text, Catch::Matchers::Contains("\n1,40,40,end-systole,yes,"));
  CHECK_THAT(text, Catch::Matchers::Contains("\n2,,70,,no,"));
  CHECK_THAT(text, Catch::Matchers::EndsWith(",\"a \"\"jump\"\", said so\"\n"));
}

TEST_CASE("the plot marks both phases, and crosses what is not trusted") {
  OverTimeReport report;
  std::vector<VolumePoint> points = pointsOf({100e3, 40e3, 70e3, 90e3});
  report.curve = volumeCurve(points);
  const std::string whole = curveSvg(report);
  CHECK_THAT(whole, Catch::Matchers::Contains("ejection fraction 60 %"));
  CHECK_THAT(whole, Catch::Matchers::Contains("end-diastole: 100 ml, frame 0"));
  CHECK_THAT(whole, Catch::Matchers::Contains("end-systole: 40 ml, frame 1"));
  CHECK_THAT(whole, Catch::Matchers::Contains("time, ms"));
  CHECK(whole.find("l8 8m0 -8l-8 8") == std::string::npos);
  points[1].isTrusted = false;
  points[1].time.reset();
  report.curve = volumeCurve(points);
  const std::string crossed = curveSvg(report);
  CHECK_THAT(crossed, Catch::Matchers::Contains("end-systole: 70 ml, frame 2"));
  CHECK_THAT(crossed, Catch::Matchers::Contains("l8 8m0 -8l-8 8"));
  CHECK_THAT(crossed, Catch::Matchers::Contains(">frame</text>"));
}
