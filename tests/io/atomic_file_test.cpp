#include "core/io/atomic_file.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>

#include "app/picture/picture.h"
#include "core/io/meshes/gltf.h"
#include "core/io/meshes/mesh_io.h"
#include "tests/io/io_test_support.h"

using namespace handlebody;
using namespace handlebody::test;

namespace {

TriangleSoup tetrahedron() {
  return {{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)},
          {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

//! Everything that is written by extension, to one path.
void writeBy(const std::string& path) {
  if (isMeshPath(path))
    writeMesh(tetrahedron(), path);
  else if (isLabelMapPath(path))
    writeVolume(randomVolume(obliqueGrid(), VoxelType::uint8), path);
  else if (isPicturePath(path))
    writePicture(randomVolume(obliqueGrid(), VoxelType::uint8), tetrahedron(), path);
  else
    writeTextAtomically(path, std::string(500, 'x'));
}

const char* const kOutputs[] = {"m.stl",    "m.vtp",  "m.ply", "m.obj", "v.nii",
                                "v.nii.gz", "v.nrrd", "v.mha", "p.png", "r.json"};

//! No file may grow beyond `bytes` while this lives: a disk that is full.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) {
    getrlimit(RLIMIT_FSIZE, &before_);
    rlimit limit = before_;
    limit.rlim_cur = bytes;
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FullDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int) = nullptr;
};

//! What is written to it goes to a file while this lives.
class StandardError {
 public:
  explicit StandardError(const std::string& path) : before_(::dup(2)) {
    const int file = ::open(path.c_str(), O_CREAT | O_WRONLY, 0600);
    ::dup2(file, 2);
    ::close(file);
  }
  ~StandardError() {
    ::dup2(before_, 2);
    ::close(before_);
  }
  StandardError(const StandardError&) = delete;
  StandardError& operator=(const StandardError&) = delete;

 private:
  int before_;
};

}  // namespace

TEST_CASE("text is written whole and replaces what was there") {
  const TemporaryFolder folder;
  writeTextAtomically(folder / "r.json", "first");
  writeTextAtomically(folder / "r.json", "second");
  CHECK(readBytes(folder / "r.json") == "second");
  CHECK(folder.fileCount() == 1);
}

TEST_CASE("a name may be as long as names are") {
  const TemporaryFolder folder;
  const std::string path = folder / (std::string(251, 'a') + ".txt");
  writeTextAtomically(path, "whole");
  CHECK(readBytes(path) == "whole");
}

TEST_CASE("a link stays, and what it leads to is written") {
  const TemporaryFolder folder, other;
  writeBytes(other / "kept", "old");
  fs::create_symlink(other / "kept", folder / "a.json");
  fs::create_symlink("a.json", folder / "b.json");  // from where the link is
  fs::create_symlink(other / "new", folder / "dangling.json");
  for (const auto& [link, file] : {std::pair("b.json", "kept"), std::pair("dangling.json", "new")}) {
    INFO(link);
    writeAtomically(folder / link, [&](const std::string& temporary) {
      CHECK(fs::path(temporary).parent_path() == other.path());
      CHECK(fs::path(temporary).extension() == ".json");
      writeBytes(temporary, "text");
    });
    CHECK(fs::is_symlink(folder / link));
    CHECK(readBytes(other / file) == "text");
    CHECK_FALSE(fs::is_symlink(other / file));
  }
  CHECK(fs::is_symlink(folder / "a.json"));
  CHECK(folder.fileCount() == 3);
  CHECK(other.fileCount() == 2);
}

TEST_CASE("links that lead to no file are refused, and stay") {
  const TemporaryFolder folder;
  fs::create_symlink(folder / "missing/file", folder / "nowhere");
  fs::create_symlink("circle", folder / "circle");
  fs::create_symlink("/dev/null", folder / "device");
  fs::create_symlink(folder.path(), folder / "folder");
  for (const char* link : {"nowhere", "circle", "device", "folder"}) {
    INFO(link);
    CHECK_THROWS_AS(writeTextAtomically(folder / link, "text"), OutputError);
    CHECK(fs::is_symlink(folder / link));
  }
  CHECK(fs::is_character_file("/dev/null"));
  CHECK(folder.fileCount() == 4);
}

TEST_CASE("a file that is replaced leaves its permissions to the new one") {
  const TemporaryFolder folder;
  const std::string path = folder / "r.json";
  for (const fs::perms kept : {fs::perms(0600), fs::perms(0664), fs::perms(0444)}) {
    writeBytes(path, "old");
    fs::permissions(path, kept);
    writeAtomically(path, [&](const std::string& temporary) {
      INFO("nobody reads it while it is written who could not read it before");
      CHECK((fs::status(temporary).permissions() & fs::perms(0066) & ~kept) == fs::perms::none);
      std::ofstream(temporary) << "new";
    });
    CHECK(readBytes(path) == "new");
    CHECK(fs::status(path).permissions() == kept);
  }
}

TEST_CASE("what has the name of a temporary file already is in nobody's way, and stays") {
  const TemporaryFolder folder;
  const std::string start = ".tmp-" + std::to_string(getpid()) + "-";
  unsigned number = 0;  // of the last temporary file
  writeAtomically(folder / "r.json", [&](const std::string& temporary) {
    const std::string name = fs::path(temporary).filename().string();
    REQUIRE(name.rfind(start, 0) == 0);
    number = static_cast<unsigned>(std::stoul(name.substr(start.size())));
    writeBytes(temporary, "first");
  });
  std::vector<std::string> left;
  for (const unsigned next : {1u, 2u, 3u}) {
    left.push_back(folder / (start + std::to_string(number + next) + "-r.json"));
    writeBytes(left.back(), "of another");
  }
  writeTextAtomically(folder / "r.json", "second");
  CHECK(readBytes(folder / "r.json") == "second");
  for (const std::string& path : left) CHECK(readBytes(path) == "of another");
  CHECK(folder.fileCount() == 4);
}

TEST_CASE("a writer that throws leaves no file and keeps the old one") {
  const TemporaryFolder folder;
  writeTextAtomically(folder / "r.json", "old");
  CHECK_THROWS_AS(writeAtomically(folder / "r.json",
                                  [](const std::string& temporary) {
                                    writeBytes(temporary, "half");
                                    throw std::runtime_error("no");
                                  }),
                  std::runtime_error);
  CHECK(readBytes(folder / "r.json") == "old");
  CHECK(folder.fileCount() == 1);
}

TEST_CASE("outputs into a missing folder, onto a folder or into an unwritable one leave nothing behind") {
  const TemporaryFolder folder;
  for (const std::string name : kOutputs) {
    INFO(name);
    CHECK_THROWS_AS(writeBy(folder / ("missing/" + name)), OutputError);
    fs::create_directory(folder / name);
    CHECK_THROWS_AS(writeBy(folder / name), OutputError);
    fs::remove(folder / name);
    writeBytes(folder / "file", "");
    CHECK_THROWS_AS(writeBy(folder / ("file/" + name)), OutputError);
    fs::remove(folder / "file");
    CHECK(folder.fileCount() == 0);
    // /proc takes no files, not even root's.
    CHECK_THROWS_AS(writeBy("/proc/" + name), OutputError);
  }
}

TEST_CASE("a full disk is an error that names the file, and leaves nothing behind") {
  const TemporaryFolder folder;
  for (const std::string name : kOutputs) {
    INFO(name);
    std::string message;
    {
      const FullDisk disk(100);
      try {
        writeBy(folder / name);
      } catch (const OutputError& e) {
        message = e.what();
      }
    }
    CHECK(message.rfind(folder / name, 0) == 0);
    CHECK(folder.fileCount() == 0);
  }
}

TEST_CASE("a full disk is called that of a scene, too") {
  const TemporaryFolder folder;
  std::string message;
  {
    const FullDisk disk(100);
    try {
      writeGltf({{ObjectLabel(), tetrahedron()}}, folder / "m.gltf");
    } catch (const OutputError& e) {
      message = e.what();
    }
  }
  CHECK_THAT(message, Contains("did not reach the disk"));
  CHECK(folder.fileCount() == 0);
}

TEST_CASE("of a full disk no library says anything of its own") {
  const TemporaryFolder folder, log;
  const Volume volume = randomVolume(obliqueGrid(), VoxelType::uint8);
  for (const char* name : {"v.nii", "v.nii.gz", "v.nrrd", "v.mha"}) {
    {
      const StandardError kept(log / name);
      const FullDisk disk(100);
      CHECK_THROWS_AS(writeVolume(volume, folder / name), OutputError);
    }
    CHECK(readBytes(log / name).empty());
  }
}

TEST_CASE("unknown output extensions are usage errors") {
  const TemporaryFolder folder;
  for (const char* name : {"v.tiff", "v", "v.nii.zip", "v.gz"}) {
    CHECK_THROWS_AS(writeVolume(randomVolume(obliqueGrid(), VoxelType::uint8), folder / name), UsageError);
    CHECK_FALSE(isLabelMapPath(name));
  }
  for (const char* name : {"m.vtk", "m", "stl"}) {
    CHECK_THROWS_AS(writeMesh(tetrahedron(), folder / name), UsageError);
    CHECK_FALSE(isMeshPath(name));
  }
  for (const char* name : {"p.jpg", "p", "png", "p.png.gz"}) {
    CHECK_THROWS_AS(writePicture(randomVolume(obliqueGrid(), VoxelType::uint8), tetrahedron(), folder / name),
                    UsageError);
    CHECK_FALSE(isPicturePath(name));
  }
  CHECK(isPicturePath("A.PNG"));
  CHECK(isMeshPath("A.STL"));
  CHECK(isLabelMapPath("A.Nii.GZ"));
  CHECK(folder.fileCount() == 0);
}

TEST_CASE("why a file is not written is a finding that names it") {
  const TemporaryFolder folder;
  const std::string within = folder / "missing/file.txt";
  for (const auto& [path, kind] : {std::pair(folder.path(), FindingKind::folderHasName),
                                   std::pair(within, FindingKind::noFileOrDirectory)}) {
    Finding finding;
    std::string message;
    try {
      writeTextAtomically(path, "text");
    } catch (const OutputError& error) {
      finding = findingOf(error);
      message = error.what();
    }
    REQUIRE(finding.kind == FindingKind::fileNotWritten);
    CHECK(finding.causes.at(0).kind == kind);
    CHECK(sentence(finding) == message);
    CHECK(message.rfind(path + ": cannot be written: ", 0) == 0);
  }
}
