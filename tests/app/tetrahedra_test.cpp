// Tetrahedra by gmsh and TetGen, where they are installed.

#include <signal.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <sstream>
#include <thread>

#include "core/cancellation.h"
#include "core/errors.h"
#include "core/io/report/result.h"
#include "core/io/tetrahedra/mesher_process.h"
#include "core/io/tetrahedra/tetrahedra.h"
#include "core/mesh/shapes.h"
#include "core/mesh/topology.h"
#include "tests/app/refusal.h"
#include "tests/app/run_cli.h"
#include "tests/support/catch.h"

using namespace handlebody;
using namespace handlebody::test;

namespace {

//! Only these programs are found while it lives.
class OnlyPrograms {
 public:
  OnlyPrograms(const TempFolder& folder, const std::vector<std::string>& names)
      : before_(std::getenv("PATH")) {
    const std::string bin = folder / "bin";
    std::filesystem::create_directory(bin);
    for (const std::string& name : names)
      std::filesystem::create_symlink(*findProgram(name), bin + "/" + name);
    setenv("PATH", bin.c_str(), 1);
  }
  ~OnlyPrograms() { setenv("PATH", before_.c_str(), 1); }
  OnlyPrograms(const OnlyPrograms&) = delete;
  OnlyPrograms& operator=(const OnlyPrograms&) = delete;

 private:
  std::string before_;
};

//! A ball with two cavities, one of which holds another ball.
TriangleSoup nested() {
  TriangleSoup all;
  const auto add = [&](const Vec3& centre, double radius, bool isCavity) {
    const TriangleSoup s = icosphere(centre, radius, radius / 3);
    const int first = static_cast<int>(all.points.size());
    all.points.insert(all.points.end(), s.points.begin(), s.points.end());
    for (Triangle t : s.triangles) {
      if (isCavity) std::swap(t[1], t[2]);
      all.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    }
  };
  add(Vec3(0, 0, 0), 10, false);
  add(Vec3(4, 0, 0), 3, true);
  add(Vec3(-4, 0, 0), 4, true);
  add(Vec3(-4, 0, 0), 2, false);
  return all;
}

double volumeOf(const Tetrahedra& t, std::size_t cell) {
  const auto p = [&](std::size_t c) { return t.points[t.cells[cell][c]]; };
  return (p(1) - p(0)).cross(p(2) - p(0)).dot(p(3) - p(0)) / 6;
}

//! Faces of one cell alone.
std::size_t boundaryFaces(const Tetrahedra& t) {
  std::map<std::array<int, 3>, int> faces;
  for (const auto& c : t.cells)
    for (std::size_t left = 0; left < 4; ++left) {
      std::array<int, 3> face{};
      for (std::size_t i = 0, n = 0; i < 4; ++i)
        if (i != left) face[n++] = c[i];
      std::sort(face.begin(), face.end());
      ++faces[face];
    }
  return static_cast<std::size_t>(
      std::count_if(faces.begin(), faces.end(), [](const auto& f) { return f.second == 1; }));
}

}  // namespace

TEST_CASE("each program fills a body around its cavities and leaves the surface as it is", "[tetrahedra]") {
  const TriangleSoup mesh = nested();
  const double volume = signedVolume(Mesh(mesh));
  bool any = false;
  for (const char* program : {"gmsh", "tetgen"}) {
    if (!findProgram(program)) continue;
    any = true;
    INFO(program);
    const TempFolder folder;
    const OnlyPrograms only(folder, {program});
    const Tetrahedra made = fillWithTetrahedra({{{}, mesh}});
    double filled = 0, least = 1;
    for (std::size_t i = 0; i < made.cells.size(); ++i) {
      filled += volumeOf(made, i);
      least = std::min(least, volumeOf(made, i));
    }
    CHECK(least > 0);
    CHECK(filled == Approx(volume).epsilon(1e-6));
    CHECK(boundaryFaces(made) == mesh.triangles.size());
  }
  if (!any) WARN("skipped: neither gmsh nor TetGen is installed");
}

TEST_CASE("tetrahedra are written in three formats, and gmsh reads its own", "[cli][tetrahedra]") {
  if (!tetrahedraFault().empty()) {
    WARN("skipped: neither gmsh nor TetGen is installed");
    return;
  }
  const TempFolder folder;
  const PhantomFile phantom = makePhantomFile(folder);
  const Outcome outcome = runCli({"segment", phantom.path, "--seed", phantom.seed, "--object-name",
                                  "my organ", "-o", folder / "o.msh", "-o", folder / "o.vtu", "-o",
                                  folder / "o.inp", "-o", folder / "o.stl", "--edge-length", "4", "--quiet"});
  INFO(outcome.err);
  REQUIRE(outcome.exitCode == 0);
  const std::string msh = readBytes(folder / "o.msh"), vtu = readBytes(folder / "o.vtu"),
                    inp = readBytes(folder / "o.inp");
  CHECK_THAT(msh, Contains("3 1 \"my organ\""));
  CHECK_THAT(inp, Contains("*ELEMENT, TYPE=C3D4, ELSET=OBJECT_1_MY_ORGAN"));
  const auto numberAfter = [](const std::string& text, const std::string& mark) {
    std::istringstream in(text.substr(text.find(mark) + mark.size()));
    std::size_t n = 0;
    in >> n;
    return n;
  };
  const std::size_t cells = numberAfter(msh, "$Elements\n");
  CHECK(cells > 100);
  CHECK_THAT(vtu, Contains("NumberOfCells=\"" + std::to_string(cells) + "\""));
  CHECK_THAT(vtu, Contains("NumberOfPoints=\"" + std::to_string(numberAfter(msh, "$Nodes\n")) + "\""));
}

TEST_CASE("without a program one sentence says which ones there are", "[cli][tetrahedra]") {
  const TempFolder folder;
  const PhantomFile phantom = makePhantomFile(folder);
  const TempFolder programs;
  const OnlyPrograms none(programs, {});
  requireRefusal(folder, {"segment", phantom.path, "--seed", phantom.seed, "-o", folder / "o.msh"}, 2,
                 "gmsh");
  CHECK_THROWS_AS(fillWithTetrahedra({{{}, nested()}}), OutputError);
}

namespace {

//! A program that never ends, with a child that does not either, whose number goes to the file "child".
class HangingGmsh {
 public:
  HangingGmsh() : before_(std::getenv("PATH")) {
    const char* temporary = std::getenv("TMPDIR");
    if (temporary) temporary_ = temporary;
    std::filesystem::create_directory(folder_ / "bin");
    std::filesystem::create_directory(folder_ / "tmp");
    writeBytes(folder_ / "bin/gmsh",
               "#!/bin/sh\n/bin/sleep 600 &\necho $! > " + (folder_ / "child") + "\nwait\n");
    std::filesystem::permissions(folder_ / "bin/gmsh", std::filesystem::perms::owner_all);
    setenv("PATH", (folder_ / "bin").c_str(), 1);
    setenv("TMPDIR", (folder_ / "tmp").c_str(), 1);
  }
  ~HangingGmsh() {
    setenv("PATH", before_.c_str(), 1);
    temporary_ ? setenv("TMPDIR", temporary_->c_str(), 1) : unsetenv("TMPDIR");
  }
  HangingGmsh(const HangingGmsh&) = delete;
  HangingGmsh& operator=(const HangingGmsh&) = delete;

  bool hasBegun() const {
    return std::filesystem::exists(folder_ / "child") && !readBytes(folder_ / "child").empty();
  }
  //! Neither its child nor a file of its is left.
  bool isGone() const {
    const std::string child = "/proc/" + std::to_string(std::stoi(readBytes(folder_ / "child")));
    for (int i = 0; i < 200 && std::filesystem::exists(child); ++i) {
      const std::string state = readBytes(child + "/stat");
      if (state.find(") Z ") != std::string::npos) break;  // ended, and nobody has asked how
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    const bool isRunning =
        std::filesystem::exists(child) && readBytes(child + "/stat").find(") Z ") == std::string::npos;
    return !isRunning && files() == 0;
  }

 private:
  //! Temporary ones, besides the tests' own folders.
  int files() const {
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder_ / "tmp"))
      count += entry.path().filename().string().rfind("handlebody-test-", 0) != 0;
    return count;
  }

  TempFolder folder_;
  std::string before_;
  std::optional<std::string> temporary_;
};

}  // namespace

TEST_CASE("a program that hangs is killed at the time limit, with its children and files", "[tetrahedra]") {
  const HangingGmsh gmsh;
  std::string said;
  try {
    fillWithTetrahedra({{{}, nested()}}, 1.0);
  } catch (const OutputError& error) {
    said = error.what();
  }
  CHECK_THAT(said, Contains("gmsh was ended after 1 s, the time limit"));
  REQUIRE(gmsh.hasBegun());
  CHECK(gmsh.isGone());
}

TEST_CASE("a program that hangs is killed when somebody cancels", "[tetrahedra]") {
  const HangingGmsh gmsh;
  std::atomic<bool> cancelled{false};
  std::jthread stopRequest([&] {
    while (!gmsh.hasBegun()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    cancelled = true;
  });
  const CancelScope scope(cancelled);
  CHECK_THROWS_AS(fillWithTetrahedra({{{}, nested()}}, 600), Cancelled);
  CHECK(gmsh.isGone());
}

TEST_CASE("an interrupt ends a run whose mesher hangs, and nothing is written", "[cli][tetrahedra]") {
  const HangingGmsh gmsh;
  const TempFolder folder;
  const PhantomFile phantom = makePhantomFile(folder);
  RunningCli run({"segment", phantom.path, "--seed", phantom.seed, "-o", folder / "m.stl", "-o",
                  folder / "m.msh", "--edge-length", "4", "--quiet"});
  while (!gmsh.hasBegun()) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  ::kill(run.process(), SIGINT);
  CHECK(run.wait().exitCode == -SIGINT);
  CHECK(gmsh.isGone());
  CHECK_FALSE(std::filesystem::exists(folder / "m.stl"));
}

TEST_CASE("at a terminal it is told which program works and for how long", "[cli][tetrahedra][progress]") {
  const HangingGmsh gmsh;
  const TempFolder folder;
  const PhantomFile phantom = makePhantomFile(folder, "sphere.mha", {"--truth", folder / "truth.mha"});
  for (const std::vector<std::string>& command :
       {std::vector{std::string("mesh"), folder / "truth.mha"},
        {"segment", phantom.path, "--seed", phantom.seed, "--edge-length", "4"}}) {
    INFO(command[0]);
    std::vector<std::string> arguments = command;
    arguments.insert(arguments.end(), {"-o", folder / "m.msh", "--mesher-seconds", "1.8"});
    const Outcome outcome = runCliAtTerminal(arguments);
    CHECK(outcome.exitCode == 2);
    CHECK_THAT(outcome.err, Contains("\r\033[Ktetrahedra by gmsh, 1 s\r\033[K"));
    CHECK_THAT(outcome.err, Contains("\r\033[Khandlebody-cli: "));  // a line of its own
  }
}

namespace {

//! While it lives there is one program, which fails.
class FailingGmsh {
 public:
  FailingGmsh() : before_(std::getenv("PATH")) {
    writeBytes(folder_ / "gmsh", "#!/bin/sh\necho 'Error   : no luck today'\nexit 1\n");
    std::filesystem::permissions(folder_ / "gmsh", std::filesystem::perms::owner_all);
    const std::string folder = std::filesystem::path(folder_ / "gmsh").parent_path().string();
    setenv("PATH", folder.c_str(), 1);
  }
  ~FailingGmsh() { setenv("PATH", before_.c_str(), 1); }
  FailingGmsh(const FailingGmsh&) = delete;
  FailingGmsh& operator=(const FailingGmsh&) = delete;

 private:
  TempFolder folder_;
  std::string before_;
};

//! Temporary files are to lie in this folder while it lives.
class TemporaryIn {
 public:
  explicit TemporaryIn(const std::string& folder) {
    if (const char* before = std::getenv("TMPDIR")) before_ = before;
    setenv("TMPDIR", folder.c_str(), 1);
  }
  ~TemporaryIn() { before_ ? setenv("TMPDIR", before_->c_str(), 1) : unsetenv("TMPDIR"); }
  TemporaryIn(const TemporaryIn&) = delete;
  TemporaryIn& operator=(const TemporaryIn&) = delete;

 private:
  std::optional<std::string> before_;
};

}  // namespace

TEST_CASE("that there is no folder for temporary files is told before the work", "[tetrahedra]") {
  const FailingGmsh gmsh;
  const TempFolder folder;
  const TemporaryIn none(folder / "missing");
  const char* const told = "no folder for temporary files can be made";
  CHECK_THROWS_WITH(fillWithTetrahedra({{{}, nested()}}), Contains(told));
  CHECK_THROWS_AS(fillWithTetrahedra({{{}, nested()}}), OutputError);
  CHECK_THROWS_WITH(checkResult("o.msh", {}), Contains("o.msh: ") && Contains(told));
  CHECK_THROWS_AS(checkResult("o.msh", {}), UsageError);
  CHECK_NOTHROW(checkResult("o.stl", {}));
}

TEST_CASE("session and report of a growth whose tetrahedra fail are written", "[cli][tetrahedra]") {
  const FailingGmsh gmsh;
  const TempFolder folder;
  const PhantomFile phantom = makePhantomFile(folder);
  const Outcome outcome =
      runCli({"segment", phantom.path, "--seed", phantom.seed, "-o", folder / "m.msh", "--session",
              folder / "s.json", "--report", folder / "r.json", "--edge-length", "4", "--quiet"});
  CHECK(outcome.exitCode == 2);
  CHECK_THAT(outcome.err, Contains("no luck today"));
  CHECK(nlohmann::json::parse(readBytes(folder / "r.json")).contains("mesh"));
  const Outcome again = runCli({"replay", folder / "s.json", "-o", folder / "m.stl", "--quiet"});
  CHECK(again.exitCode == 0);
  CHECK_FALSE(std::filesystem::exists(folder / "m.msh"));
}

TEST_CASE("a program that fails is named with what it said", "[tetrahedra]") {
  std::string said;
  {
    const FailingGmsh gmsh;
    try {
      fillWithTetrahedra({{{}, nested()}});
    } catch (const OutputError& error) {
      said = error.what();
    }
  }
  CHECK_THAT(said, Contains("'Object'"));
  CHECK_THAT(said, Contains("no luck today"));
}
