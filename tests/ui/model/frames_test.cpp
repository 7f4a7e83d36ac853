// Frames of a volume over time: which one is shown, kept in memory and grown in.

#include "tests/ui/model/time_support.h"

using namespace handlebody;
using namespace handlebody::ui;

TEST_CASE("another frame is shown with its own voxels, and the growth stays where it is",
          "[document][time]") {
  const BeatingFile heart;
  Document document;
  REQUIRE(growInFrame(document, heart));
  const auto surface = document.snapshot();
  REQUIRE(showFrame(document, 2));
  VolumeSelection second;
  second.frame = 2;
  const Volume there = readVolume(heart.path.toStdString(), second);
  const std::size_t bytes = there.grid.voxelCount() * bytesPerVoxel(there.type);
  REQUIRE(document.volume().grid.size == there.grid.size);
  CHECK(std::memcmp(document.volume().voxels.get(), there.voxels.get(), bytes) == 0);
  CHECK(document.time().grownFrame() == 0);
  CHECK(document.snapshot() == nullptr);  // it has not been carried there
  REQUIRE(showFrame(document, 0));
  CHECK(document.snapshot() == surface);
}

TEST_CASE("the times of the frames are those of the file", "[document][time]") {
  const BeatingFile heart;
  Document document;
  REQUIRE(openAndWait(document, heart.path));
  REQUIRE(document.time().frameCount() == BeatingFile::kFrames);
  for (int f = 0; f < BeatingFile::kFrames; ++f) {
    REQUIRE(document.time().timeOf(f).has_value());
    CHECK(std::abs(*document.time().timeOf(f) - 200 * f) < 1e-3);
  }
}

TEST_CASE("frames are kept within a bound of memory", "[document][time]") {
  const BeatingFile heart;
  Document document;
  REQUIRE(openAndWait(document, heart.path));
  const Volume& v = document.volume();
  const double frame = static_cast<double>(v.grid.voxelCount() * bytesPerVoxel(v.type));
  document.time().store().setBound(3.5 * frame);
  for (int i = 0; i < 2 * BeatingFile::kFrames; ++i) {
    REQUIRE(showFrame(document, (2 * i) % BeatingFile::kFrames));
    CHECK(document.time().store().bytes() <= 3.5 * frame);
  }
}

TEST_CASE("playing shows one frame after the other, round to the first", "[document][time]") {
  const BeatingFile heart;
  Document document;
  REQUIRE(openAndWait(document, heart.path));
  std::vector<int> shown;
  QObject::connect(&document.time(), &TimeSeries::shownChanged,
                   [&] { shown.push_back(document.time().shownFrame()); });
  document.time().play(true);
  REQUIRE(waitFor([&] { return shown.size() >= 6; }));
  document.time().play(false);
  for (std::size_t i = 0; i < 6; ++i) CHECK(shown[i] == static_cast<int>(i + 1) % BeatingFile::kFrames);
  const std::size_t seen = shown.size();
  waitMilliseconds(500);
  CHECK(shown.size() <= seen + 1);  // one was on its way
}

TEST_CASE("a frame that cannot be read says why, and the shown one stays", "[document][time]") {
  const BeatingFile heart;
  Document document;
  REQUIRE(openAndWait(document, heart.path));
  QFile::remove(heart.path);
  document.time().show(3);
  REQUIRE(waitFor([&] { return !document.time().error().isEmpty(); }));
  CHECK(document.time().error().contains("heart.nii.gz"));
  CHECK(document.time().shownFrame() == 0);
}

TEST_CASE("the first click in another frame makes that the one it is grown in", "[document][time]") {
  const BeatingFile heart;
  Document document;
  REQUIRE(growInFrame(document, heart, 3));
  CHECK(document.time().grownFrame() == 3);
  CHECK(document.selection().frame == 3);
}

TEST_CASE("what is changed is what is seen: in another frame than the growth's edits are refused",
          "[document][time]") {
  const BeatingFile heart;
  Document document;
  QString said;
  QObject::connect(&document, &Document::refused, [&](const QString& why) { said = why; });
  REQUIRE(growInFrame(document, heart));
  REQUIRE(showFrame(document, 2));
  document.addSeed({heart.seed + Vec3(3, 0, 0), {}});
  CHECK(document.seeds().size() == 1);
  CHECK(said.contains("Frame 2"));
  document.goTo(1);  // but the timeline of the growth leads back to its frame
  CHECK(document.time().shownFrame() == 0);
  CHECK(waitFor([&] { return document.iteration() == 1; }));
}

TEST_CASE("growing in another frame moves the clicks there, and can be undone", "[document][time]") {
  const BeatingFile heart;
  Document document;
  REQUIRE(growInFrame(document, heart));
  const TriangleSoup there = document.snapshot()->mesh;
  REQUIRE(showFrame(document, 2));
  document.growInShownFrame();
  CHECK(document.time().grownFrame() == 2);
  CHECK(document.state() != GrowthState::finished);
  REQUIRE(runToEnd(document));
  CHECK_FALSE(isSame(document.snapshot()->mesh, there));
  document.undoStack()->undo();
  REQUIRE(waitFor([&] { return document.time().grownFrame() == 0; }));
  REQUIRE(runToEnd(document));
  CHECK(isSame(document.snapshot()->mesh, there));
}

TEST_CASE("a frame to grow in is given up where another one is wanted before it is shown",
          "[document][time]") {
  const BeatingFile heart;
  Document document;
  QString said;
  QObject::connect(&document, &Document::refused, [&](const QString& why) { said = why; });
  REQUIRE(growInFrame(document, heart));
  document.time().store().setBound(0);  // so that the two used last are kept alone
  REQUIRE(showFrame(document, 2));
  document.growInShownFrame();
  REQUIRE(runToEnd(document));
  REQUIRE(showFrame(document, 3));
  REQUIRE(showFrame(document, 1));
  REQUIRE_FALSE(document.time().store().kept(0));
  document.undoStack()->undo();
  document.time().show(2);
  CHECK(said.contains("still grown in frame 2"));
  CHECK(document.isModified());
  const auto grown = document.snapshot();
  REQUIRE(showFrame(document, 0));  // only to look at it
  REQUIRE(showFrame(document, 2));
  CHECK(document.time().grownFrame() == 2);
  CHECK(document.snapshot() == grown);
}

TEST_CASE("a frame that is wanted is shown also where another file that is opened meanwhile is none",
          "[document][time]") {
  const BeatingFile heart;
  Document document;
  bool hasFailed = false;
  QObject::connect(&document, &Document::openFailed, [&] { hasFailed = true; });
  REQUIRE(growInFrame(document, heart));
  document.time().store().setBound(0);
  REQUIRE(showFrame(document, 1));
  REQUIRE(showFrame(document, 2));
  REQUIRE_FALSE(document.time().store().kept(3));
  document.time().show(3);
  document.open(heart.path + QStringLiteral(".absent.nrrd"));
  REQUIRE(waitFor([&] { return hasFailed; }));
  CHECK(waitFor([&] { return document.time().shownFrame() == 3; }));
}
