// Time points: when they were taken, and folders that hold one file for each.

#include "core/io/formats/time_axis.h"

#include "tests/io/dicom_test_support.h"
#include "tests/io/io_test_support.h"

using namespace handlebody;
using namespace handlebody::test;

namespace {

using Times = std::vector<double>;

//! 2 x 2 x 2 voxels and three frames, one axis of them at `list`.
std::string sequenceOf(const std::string& sizes, const std::string& directions, const std::string& more) {
  return "NRRD0005\ntype: uint8\ndimension: 4\nspace: left-posterior-superior\nsizes: " + sizes +
         "\nspace directions: " + directions + "\nspace origin: (0,0,0)\nencoding: raw\n" + more + "\n" +
         std::string(24, 'a');
}

Times timesOf(const std::string& path) { return readTimeAxis(path).milliseconds; }

std::vector<Slice> twoTimes(const std::function<void(Slice&, int)>& setTime) {
  std::vector<Slice> slices;
  for (int t = 0; t < 2; ++t)
    for (Slice s : evenStack(4)) {
      s.value = static_cast<std::int16_t>(s.value + 50 * t);
      s.number = static_cast<int>(slices.size());
      setTime(s, t);
      slices.push_back(s);
    }
  return slices;
}

}  // namespace

TEST_CASE("a NRRD sequence has times where its header gives a unit of time") {
  const TemporaryFolder folder;
  const std::string first = "none (1,0,0) (0,1,0) (0,0,1)", last = "(1,0,0) (0,1,0) (0,0,1) none";
  writeBytes(folder / "uneven.seq.nrrd",
             sequenceOf("3 2 2 2", first,
                        "kinds: list domain domain domain\nunits: \"s\" \"\" \"\" \"\"\n"
                        "axis 0 index type:=numeric\naxis 0 index values:=0 0.04 0.1\n"));
  CHECK(timesOf(folder / "uneven.seq.nrrd") == Times{0, 40, 100});
  CHECK(evenStep(readTimeAxis(folder / "uneven.seq.nrrd")) == 0);
  writeBytes(folder / "last.seq.nrrd",
             sequenceOf("2 2 2 3", last,
                        "kinds: domain domain domain list\nunits: \"\" \"\" \"\" \"ms\"\n"
                        "axis 3 index values:=10 20 30\n"));
  CHECK(timesOf(folder / "last.seq.nrrd") == Times{10, 20, 30});
  CHECK(evenStep(readTimeAxis(folder / "last.seq.nrrd")) == Approx(10));
}

TEST_CASE("numbers of frames without a unit, or that fall, are no times") {
  const TemporaryFolder folder;
  const std::string first = "none (1,0,0) (0,1,0) (0,0,1)";
  const auto none = [&](const std::string& more) {
    writeBytes(folder / "v.nrrd", sequenceOf("3 2 2 2", first, "kinds: list domain domain domain\n" + more));
    return inspectVolume(folder / "v.nrrd", {.frame = 0}).frames == 3 && timesOf(folder / "v.nrrd").empty();
  };
  CHECK(none("axis 0 index values:=0 1 2\n"));
  CHECK(none("labels: \"frame\" \"\" \"\" \"\"\naxis 0 index values:=0 1 2\n"));
  const std::string seconds = "units: \"s\" \"\" \"\" \"\"\naxis 0 index values:=";
  CHECK(none(seconds + "0 2 1\n"));
  CHECK(none(seconds + "0 1\n"));
  CHECK(none(seconds + "0 1 late\n"));
  CHECK(none(seconds + "0 1 1\n"));
}

TEST_CASE("a 4D NIfTI has times where its header gives a unit of time") {
  const TemporaryFolder folder;
  writeVolume(randomVolume(obliqueGrid(), VoxelType::uint8), folder / "made.nii");
  std::string bytes = readBytes(folder / "made.nii");
  bytes += bytes.substr(352) + bytes.substr(352);
  patch(bytes, 40, std::int16_t{4});
  patch(bytes, 48, std::int16_t{3});
  patch(bytes, 92, 0.05F);  // pixdim[4]
  const auto timesIn = [&](char unit) {
    patch(bytes, 123, unit);
    writeBytes(folder / "4d.nii", bytes);
    return readTimeAxis(folder / "4d.nii");
  };
  CHECK(evenStep(timesIn(2 | 8)) == Approx(50));     // s
  CHECK(evenStep(timesIn(2 | 16)) == Approx(0.05));  // ms
  CHECK(evenStep(timesIn(2 | 24)) == Approx(5e-5));  // µs
  CHECK(timesIn(2).milliseconds.empty());            // not said
  CHECK(timesIn(2 | 32).milliseconds.empty());       // Hz
  CHECK(timesIn(2 | 8).milliseconds.size() == 3);
}

TEST_CASE("DICOM time points have their trigger times, or the step of their positions in time") {
  const TemporaryFolder folder;
  writeSeries(folder / "trigger", twoTimes([](Slice& s, int t) { s.triggerTime = 12 + 35.5 * t; }));
  const TimeAxis trigger = readTimeAxis(folder / "trigger");
  CHECK(trigger.milliseconds == Times{12, 47.5});
  CHECK(trigger.source == "TriggerTime (0018,1060)");
  writeSeries(folder / "position", twoTimes([](Slice& s, int t) { s.temporalPosition = 1 + t; }));
  CHECK(timesOf(folder / "position") == Times{0, 40});
  writeSeries(folder / "same", twoTimes([](Slice& s, int) { s.triggerTime = 12; }));
  CHECK(timesOf(folder / "same").empty());
}

TEST_CASE("DICOM time points whose slices were taken further apart than half a step have no times") {
  const TemporaryFolder folder;
  // The fourth of four slices at another time than the first.
  const auto timesFor = [&](const std::string& name, double later) {
    writeSeries(folder / name, twoTimes([&](Slice& s, int t) {
                  s.triggerTime = 10 + 40 * t + (s.value % 50 == 3 ? later : 0);
                }));
    REQUIRE(inspectVolume(folder / name, {.frame = 0}).frames == 2);
    return timesOf(folder / name);
  };
  CHECK(timesFor("near", 15) == Times{10, 50});
  CHECK(timesFor("far", 25).empty());
  CHECK(timesFor("next", 40).empty());
}

TEST_CASE("a folder of volumes is one with a time point for each, in the order of their numbers") {
  const TemporaryFolder folder;
  const std::string frames = folder / "frames";
  fs::create_directories(frames);
  std::vector<Volume> volumes;
  for (const int number : {10, 9, 100}) {
    volumes.push_back(randomVolume(obliqueGrid(), VoxelType::int16, static_cast<unsigned>(number)));
    writeVolume(volumes.back(), frames + "/v" + std::to_string(number) + ".nii.gz");
  }
  writeBytes(frames + "/notes.txt", "of the scanner");
  CHECK(inspectVolume(frames).frames == 3);
  CHECK(voxelBytes(readVolume(frames, {.frame = 0})) == voxelBytes(volumes[1]));
  CHECK(voxelBytes(readVolume(frames, {.frame = 1})) == voxelBytes(volumes[0]));
  CHECK(voxelBytes(readVolume(frames, {.frame = 2})) == voxelBytes(volumes[2]));
  CHECK_THROWS_AS(readVolume(frames, {.frame = 3}), UsageError);
}

TEST_CASE("volumes of a folder that do not go together are refused, each by its name") {
  const TemporaryFolder folder;
  const std::string frames = folder / "frames";
  fs::create_directories(frames);
  writeVolume(randomVolume(obliqueGrid(), VoxelType::int16), frames + "/a.nii");
  const auto refused = [&](const Volume& other, const std::string& cause) {
    writeVolume(other, frames + "/b.nii");
    try {
      inspectVolume(frames);
      FAIL("it was opened");
    } catch (const InputError& error) {
      CHECK_THAT(error.what(), Catch::Matchers::Contains("b.nii: " + cause));
    }
  };
  Grid moved = obliqueGrid();
  moved.origin.x() += 0.5;
  refused(randomVolume(moved, VoxelType::int16), "its size, spacing or place");
  Grid larger = obliqueGrid();
  ++larger.size[2];
  refused(randomVolume(larger, VoxelType::int16), "its size, spacing or place");
  refused(randomVolume(obliqueGrid(), VoxelType::uint8), "its voxels are not of the same type");
}
