#include "core/io/tetrahedra/mesher_process.h"

#include <stdlib.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <limits>
#include <locale>
#include <sstream>

#include "core/cancellation.h"
#include "core/indices.h"
#include "core/io/atomic_file.h"
#include "core/io/tetrahedra/limited_program.h"
#include "core/io/tetrahedra/tetrahedra.h"
#include "core/phase.h"
#include "core/told_error.h"

namespace handlebody {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMaxSaid = 300;  // characters of what a program said

[[noreturn]] void refuseTemporary(int error) {
  throw Told<OutputError>(Finding(FindingKind::noTemporaryFolder, {}, systemFinding(error)));
}

//! Throws OutputError where TMPDIR, or what stands for it, is no folder.
fs::path temporaryFolder() {
  std::error_code failed;
  fs::path folder = fs::temp_directory_path(failed);
  if (failed) refuseTemporary(failed.value());
  return folder;
}

//! A folder of its own, removed with what is in it.
class WorkFolder {
 public:
  WorkFolder() : path_((temporaryFolder() / "handlebody-XXXXXX").string()) {
    if (!::mkdtemp(path_.data())) refuseTemporary(errno);
  }
  ~WorkFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
  std::string operator/(const std::string& name) const { return path_ + "/" + name; }

 private:
  std::string path_;
};

//! The first line that tells of an error, else the last one.
std::string complaintOf(const std::string& log) {
  std::ifstream in(log);
  std::string line, last;
  while (std::getline(in, line)) {
    const bool isError = line.find("rror") != std::string::npos;
    if (line.find_first_not_of(" \t\r-") == std::string::npos) continue;
    last = line;
    if (isError) break;
  }
  if (last.size() > kMaxSaid) last.resize(kMaxSaid);
  while (!last.empty() && (last.back() == '.' || last.back() == ' ')) last.pop_back();
  return last;
}

std::string faultOf(const std::string& name, const ProgramEnd& end, double seconds, const std::string& log) {
  std::ostringstream text;
  text << name;
  if (!end.isStarted)
    text << " cannot be started";
  else if (end.isTooLong)
    text << " was ended after " << seconds << " s, the time limit";
  else if (end.signal != 0)
    text << " was ended by signal " << end.signal;
  else
    text << " made none (exit code " << end.exitCode << ")";
  const std::string said = complaintOf(log);
  return said.empty() ? text.str() : text.str() + ", and said: " + said;
}

void setDigits(std::ofstream& out) {
  out.imbue(std::locale::classic());
  out.precision(std::numeric_limits<double>::max_digits10);
}

void writeGmshSurface(const MesherInput& in, const std::string& path) {
  std::ofstream out(path);
  setDigits(out);
  out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" << in.mesh.points.size() << "\n";
  for (std::size_t i = 0; i < in.mesh.points.size(); ++i) {
    const Vec3& p = in.mesh.points[i];
    out << i + 1 << " " << p.x() << " " << p.y() << " " << p.z() << "\n";
  }
  out << "$EndNodes\n$Elements\n" << in.mesh.triangles.size() << "\n";
  for (std::size_t f = 0; f < in.mesh.triangles.size(); ++f) {
    const Triangle& t = in.mesh.triangles[f];
    const int surface = in.component[f] + 1;
    out << f + 1 << " 2 2 " << surface << " " << surface << " " << t[0] + 1 << " " << t[1] + 1 << " "
        << t[2] + 1 << "\n";
  }
  out << "$EndElements\n";
}

void writeGmshBodies(const MesherInput& in, const std::string& surface, const std::string& path) {
  std::ofstream out(path);
  out << "Merge \"" << surface << "\";\n";
  for (std::size_t b = 0; b < in.bodies.size(); ++b) {
    std::string loops;
    for (const int c : in.bodies[b]) {
      out << "Surface Loop(" << c + 1 << ") = {" << c + 1 << "};\n";
      loops += (loops.empty() ? "" : ", ") + std::to_string(c + 1);
    }
    out << "Volume(" << b + 1 << ") = {" << loops << "};\nPhysical Volume(" << b + 1 << ") = {" << b + 1
        << "};\n";
  }
}

//! Moves on behind a line. False at the end.
bool findLine(std::istream& in, const std::string& wanted) {
  std::string line;
  while (std::getline(in, line))
    if (line == wanted || line == wanted + "\r") return true;
  return false;
}

//! gmsh numbers nodes as it likes.
MesherOutput readGmsh(const std::string& path) {
  MesherOutput out;
  std::ifstream in(path);
  std::size_t count = 0;
  if (!findLine(in, "$Nodes") || !(in >> count)) return out;
  std::vector<int> place;  // of a node's number
  for (std::size_t i = 0; i < count; ++i) {
    std::size_t number = 0;
    Vec3 p;
    if (!(in >> number >> p.x() >> p.y() >> p.z()) || number > 100 * count + 100) return out;
    if (place.size() <= number) place.resize(number + 1, -1);
    place[number] = static_cast<int>(out.points.size());
    out.points.push_back(p);
  }
  if (!findLine(in, "$Elements") || !(in >> count)) return out;
  for (std::size_t i = 0; i < count; ++i) {
    giveUpIfCancelled();
    int number = 0, type = 0, tags = 0, tag = 0;
    if (!(in >> number >> type >> tags)) return out;
    for (int t = 0; t < tags; ++t) in >> tag;
    if (type != 4) {
      std::string rest;
      std::getline(in, rest);
      continue;
    }
    std::array<int, 4> cell{};
    for (int& v : cell) {
      std::size_t node = 0;
      if (!(in >> node) || node >= place.size() || place[node] < 0) return out;
      v = place[node];
    }
    out.cells.push_back(cell);
  }
  return out;
}

void writeTetgenSurface(const MesherInput& in, const std::string& path) {
  std::ofstream out(path);
  setDigits(out);
  out << in.mesh.points.size() << " 3 0 0\n";
  for (std::size_t i = 0; i < in.mesh.points.size(); ++i) {
    const Vec3& p = in.mesh.points[i];
    out << i << " " << p.x() << " " << p.y() << " " << p.z() << "\n";
  }
  out << in.mesh.triangles.size() << " 0\n";
  for (const Triangle& t : in.mesh.triangles) out << "1\n3 " << t[0] << " " << t[1] << " " << t[2] << "\n";
  out << in.holes.size() << "\n";
  for (std::size_t i = 0; i < in.holes.size(); ++i) {
    const Vec3& p = in.holes[i];
    out << i << " " << p.x() << " " << p.y() << " " << p.z() << "\n";
  }
  out << "0\n";
}

MesherOutput readTetgen(const std::string& nodes, const std::string& cells) {
  MesherOutput out;
  std::ifstream in(nodes);
  std::size_t count = 0;
  int dimension = 0, attributes = 0, markers = 0;
  if (!(in >> count >> dimension >> attributes >> markers)) return out;
  std::string rest;
  for (std::size_t i = 0; i < count; ++i) {
    std::size_t number = 0;
    Vec3 p;
    if (!(in >> number >> p.x() >> p.y() >> p.z()) || number != i) return out;
    std::getline(in, rest);
    out.points.push_back(p);
  }
  std::ifstream elements(cells);
  if (!(elements >> count >> dimension >> attributes)) return out;
  for (std::size_t i = 0; i < count; ++i) {
    giveUpIfCancelled();
    std::size_t number = 0;
    std::array<int, 4> cell{};
    elements >> number >> cell[0] >> cell[1] >> cell[2] >> cell[3];
    for (const int v : cell)
      if (!elements || v < 0 || idx(v) >= out.points.size()) return {};
    std::getline(elements, rest);
    out.cells.push_back(cell);
  }
  return out;
}

bool isDone(const ProgramEnd& end) { return !end.isTooLong && end.exitCode == 0; }

}  // namespace

void requireTemporaryFolder() { const WorkFolder folder; }

std::optional<std::string> findProgram(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    const std::string program = (folder.empty() ? "." : folder) + "/" + name;
    if (::access(program.c_str(), X_OK) == 0 && fs::is_regular_file(program)) return program;
  }
  return std::nullopt;
}

MesherOutput runGmsh(const std::string& program, const MesherInput& input, double seconds) {
  const Phase phase("tetrahedra by gmsh");
  const WorkFolder folder;
  writeGmshSurface(input, folder / "surface.msh");
  writeGmshBodies(input, folder / "surface.msh", folder / "bodies.geo");
  const ProgramEnd end = runLimited({program, folder / "bodies.geo", "-3", "-format", "msh22", "-nt", "1",
                                     "-v", "2", "-o", folder / "out.msh"},
                                    folder / "log", seconds);
  MesherOutput out;
  if (isDone(end)) out = readGmsh(folder / "out.msh");
  if (out.cells.empty()) out.fault = faultOf("gmsh", end, seconds, folder / "log");
  return out;
}

MesherOutput runTetgen(const std::string& program, const MesherInput& input, double seconds) {
  const Phase phase("tetrahedra by TetGen");
  const WorkFolder folder;
  writeTetgenSurface(input, folder / "surface.poly");
  // The surface as it is (Y), better shapes inside (q), quiet (Q).
  const ProgramEnd end = runLimited({program, "-pYqQ", folder / "surface.poly"}, folder / "log", seconds);
  MesherOutput out;
  if (isDone(end)) out = readTetgen(folder / "surface.1.node", folder / "surface.1.ele");
  if (out.cells.empty()) out.fault = faultOf("TetGen", end, seconds, folder / "log");
  return out;
}

}  // namespace handlebody
