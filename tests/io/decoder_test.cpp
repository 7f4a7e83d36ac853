// The child process that decodes DICOM: whatever it does, the reader answers with one sentence.

#include <sys/wait.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "core/cancellation.h"
#include "core/io/meshes/mesh_io.h"
#include "core/io/report/compared.h"
#include "core/io/report/start_surface.h"
#include "core/io/report/wall_map.h"
#include "tests/io/dicom_test_support.h"
#include "tests/io/mesh_test_support.h"

using namespace handlebody;
using namespace handlebody::test;

namespace {

//! In one line that begins with the path and holds `cause`, whether read or inspected.
void expectRefused(const DecoderSettings& decoder, const std::string& path, const std::string& cause) {
  expectInputError(path, cause, false, decoder);
}

double secondsOf(const std::function<void()>& f) {
  const auto start = std::chrono::steady_clock::now();
  f();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::string folderCalled(const TemporaryFolder& folder, const std::string& name) {
  writeSeries(folder / name, evenStack(3));
  return folder / name;
}

//! From the moment at which a reading that hangs is cancelled until it has ended.
double secondsToCancel(const std::string& path, const DecoderSettings& decoder,
                       std::chrono::milliseconds wait) {
  using Clock = std::chrono::steady_clock;
  std::atomic<bool> cancelled = false;
  Clock::time_point at;
  std::thread user([&] {
    std::this_thread::sleep_for(wait);
    at = Clock::now();
    cancelled = true;
  });
  const CancelScope scope(cancelled);
  CHECK_THROWS_AS(loadVolume(path, {.decoder = decoder}), Cancelled);
  const Clock::time_point end = Clock::now();
  user.join();
  return std::chrono::duration<double>(end - at).count();
}

void expectNoChildren() {
  INFO("no child process is left behind, not even as a zombie");
  CHECK(waitpid(-1, nullptr, WNOHANG) == -1);
}

}  // namespace

TEST_CASE("a DICOM decoder that dies is a sentence with the file it worked on") {
  const TemporaryFolder folder;
  const DecoderSettings decoder{MISBEHAVING_DECODER};
  const std::string crash = folderCalled(folder, "crash");
  expectRefused(decoder, crash, "broke down on " + crash + "/slice-7 (signal: Aborted)");
  expectRefused(decoder, folderCalled(folder, "leave"), "exit code 9");
  expectNoChildren();
}

TEST_CASE("a DICOM decoder that hangs is stopped when patience is over") {
  const TemporaryFolder folder;
  const DecoderSettings decoder{MISBEHAVING_DECODER, 0.2};
  const std::string path = folderCalled(folder, "hang");
  const double seconds =
      secondsOf([&] { CHECK_THROWS_AS(readVolume(path, {.decoder = decoder}), InputError); });
  CHECK(seconds >= 0.2);
  CHECK(seconds < 10);
  expectRefused(decoder, path, "got stuck on " + path + "/slice-7");
  expectNoChildren();
}

TEST_CASE("a DICOM decoder that computes without end has patience of the processor's time") {
  const TemporaryFolder folder;
  const DecoderSettings decoder{MISBEHAVING_DECODER, 0.3};
  const std::string path = folderCalled(folder, "spin");
  expectRefused(decoder, path, "got stuck on " + path + "/slice-7");
  expectNoChildren();
}

TEST_CASE("a DICOM decoder that is kept from computing is waited for longer") {
  const TemporaryFolder folder;
  // It sleeps for more than that, as one that is not given a processor.
  const DecoderSettings decoder{MISBEHAVING_DECODER, 0.5};
  const std::string path = folderCalled(folder, "slow");
  CHECK_THROWS_WITH(readVolume(path, {.decoder = decoder}), Contains("it was slow"));
  expectNoChildren();
}

TEST_CASE("a DICOM decoder has no more memory than the image needs") {
  const TemporaryFolder folder;
  const DecoderSettings decoder{MISBEHAVING_DECODER};
  const std::string path = folderCalled(folder, "eat");
  std::string message;
  try {
    readVolume(path, {.decoder = decoder});
  } catch (const InputError& error) {
    message = error.what();
  }
  const auto at = message.find("ate ");
  INFO(message);
  REQUIRE(at != std::string::npos);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  CHECK(std::stoi(message.substr(at + 4)) <= 512);
#endif
}

TEST_CASE("answers without meaning are refused") {
  const TemporaryFolder folder;
  const DecoderSettings decoder{MISBEHAVING_DECODER};
  expectRefused(decoder, folderCalled(folder, "nonsense"), "without meaning");
  expectRefused(decoder, folderCalled(folder, "noise"), "broke down");
}

TEST_CASE("without its decoder DICOM is refused, and the message names the program") {
  const TemporaryFolder folder;
  const DecoderSettings decoder{folder / "nothing-here"};
  expectRefused(decoder, folderCalled(folder, "series"), "the decoder " + (folder / "nothing-here"));
}

TEST_CASE("what belongs to a session is decoded as its volume") {
  const TemporaryFolder folder;
  const DecoderSettings decoder{folder / "nothing-here"};
  const std::string series = folderCalled(folder, "series"), mesh = folder / "mesh.vtp";
  writeMesh(sphere(Vec3(1, 2, 3), 4, 1), mesh);
  Session session;
  session.volume.selection.decoder = decoder;
  session.constraints.walls.map = WallMap{series, {}, nullptr};
  session.constraints.start.emplace().path = mesh;
  CHECK_THROWS_WITH(loadWalls(session, obliqueGrid()), Contains(decoder.program));
  CHECK_THROWS_WITH(loadStarts(session), Contains(decoder.program));
  std::vector<Finding> warnings;
  for (const std::string& path : {series, mesh})
    CHECK_THROWS_WITH(readCompared(path, {}, warnings, decoder), Contains(decoder.program));
}

TEST_CASE("a reading that is cancelled ends at once and leaves no process") {
  const TemporaryFolder folder;
  const DecoderSettings decoder{MISBEHAVING_DECODER, 30};
  writeBytes(folder / "hang.tif", std::string("II*\0\0\0\0\0", 8));  // libtiff cannot be told to stop
  for (const std::string& path : {folderCalled(folder, "hang"), folder / "hang.tif"}) {
    INFO(path);
    // The shortest of three: other programs make it longer, never shorter. Who looks once a second ends more
    // than half a second late each time.
    double shortest = 1e9;
    for (const int wait : {200, 300, 400}) {
      shortest = std::min(shortest, secondsToCancel(path, decoder, std::chrono::milliseconds(wait)));
      expectNoChildren();
    }
    CHECK(shortest < 0.5);
  }
}

TEST_CASE("progress never falls, and ends at 1") {
  const TemporaryFolder folder;
  writeSeries(folder / "series", evenStack(40));
  writeVolume(randomVolume(obliqueGrid(), VoxelType::int16), folder / "v.nii.gz");
  for (const std::string& path : {folder / "series", folder / "v.nii.gz"}) {
    std::vector<double> parts;
    loadVolume(path, {}, [&](double part) { parts.push_back(part); });
    REQUIRE_FALSE(parts.empty());
    CHECK(std::is_sorted(parts.begin(), parts.end()));
    CHECK(parts.front() >= 0);
    CHECK(parts.back() == 1);
  }
}

TEST_CASE("a cancelled flag ends the reading of every format") {
  const TemporaryFolder folder;
  const std::vector<const char*> names{"v.nii", "v.nii.gz", "v.nrrd", "v.mha", "series"};
  for (std::size_t i = 0; i + 1 < names.size(); ++i)
    writeVolume(randomVolume(obliqueGrid(), VoxelType::int16), folder / names[i]);
  writeSeries(folder / names.back(), evenStack(3));
  const std::atomic<bool> cancelled = true;
  const CancelScope scope(cancelled);
  for (const char* name : names) {
    INFO(name);
    CHECK_THROWS_AS(loadVolume(folder / name), Cancelled);
    expectNoChildren();
  }
}

TEST_CASE("paths with quotes, spaces, semicolons and bytes that are not UTF-8 are only names") {
  const TemporaryFolder folder;
  const std::string name = "it's; rm -rf $HOME \"x\" \xff\xfe\n`id`";
  writeSeries(folder / name, evenStack(3));
  CHECK(readVolume(folder / name).grid.size[2] == 3);
}

TEST_CASE("VTP meshes are read by the child process, whose death and hang are sentences") {
  const TemporaryFolder folder;
  const std::string path = folder / "mesh.vtp";
  writeMesh(sphere(Vec3(1, 2, 3), 4, 1), path);
  CHECK(readMesh(path).triangles.size() == 32);
  CHECK_THROWS_AS(readMesh(path, {folder / "nothing-here"}), InputError);
  // Blocks of compressed data that claim to be larger than any memory.
  std::string bytes = readBytes(path);
  const auto data = bytes.find('_', bytes.find("<AppendedData"));
  REQUIRE(data != std::string::npos);
  for (std::size_t i = 1; i < 200; ++i) bytes[data + i] = '\xff';
  writeBytes(path, bytes);
  CHECK_THROWS_AS(readMesh(path), InputError);
  expectNoChildren();
}
