#include "core/io/mesher_process.h"

#include <fcntl.h>
#include <spawn.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <locale>
#include <sstream>
#include <thread>

#include "core/cancellation.h"
#include "core/errors.h"

extern char** environ;

namespace handlebody {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMostSaid = 300;  // characters of what a program said

//! A folder of its own, removed with what is in it.
class WorkFolder {
 public:
  WorkFolder() : path_((fs::temp_directory_path() / "handlebody-XXXXXX").string()) {
    if (!::mkdtemp(path_.data()))
      throw OutputError("no folder for temporary files can be made: " + std::string(std::strerror(errno)) +
                        ".");
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

//! Numbers with a point, whatever the user's language.
std::vector<std::string> plainEnvironment() {
  std::vector<std::string> all{"LC_ALL=C"};
  for (char** e = environ; *e; ++e)
    if (std::strncmp(*e, "LC_", 3) != 0) all.emplace_back(*e);
  return all;
}

std::vector<char*> pointersTo(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& t : texts) pointers.push_back(t.data());
  pointers.push_back(nullptr);
  return pointers;
}

//! What waitpid says of its end; it is killed if nobody wants it any more.
int statusAtEnd(pid_t child) {
  constexpr std::chrono::milliseconds kLook(10);
  int status = 0;
  try {
    while (true) {
      const pid_t ended = ::waitpid(child, &status, WNOHANG);
      if (ended == child || (ended < 0 && errno != EINTR)) return status;
      giveUpIfCancelled();
      std::this_thread::sleep_for(kLook);
    }
  } catch (const Cancelled&) {
    ::kill(child, SIGKILL);
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    throw;
  }
}

//! Waits for its end; the exit code, minus the signal's number if one ended it, or -1000 if it did not start.
//! What it says goes to the file `log`.
int runProgram(std::vector<std::string> command, const std::string& log) {
  std::vector<std::string> environment = plainEnvironment();
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_adddup2(&files, STDOUT_FILENO, STDERR_FILENO);
  pid_t child = 0;
  const int failed = ::posix_spawn(&child, command[0].c_str(), &files, nullptr, pointersTo(command).data(),
                                   pointersTo(environment).data());
  posix_spawn_file_actions_destroy(&files);
  if (failed != 0) return -1000;
  const int status = statusAtEnd(child);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

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
  if (last.size() > kMostSaid) last.resize(kMostSaid);
  while (!last.empty() && (last.back() == '.' || last.back() == ' ')) last.pop_back();
  return last;
}

std::string faultOf(const std::string& name, int ended, const std::string& log) {
  std::string text = name;
  if (ended <= -1000)
    text += " cannot be started";
  else if (ended < 0)
    text += " was ended by signal " + std::to_string(-ended);
  else
    text += " made none (exit code " + std::to_string(ended) + ")";
  const std::string said = complaintOf(log);
  return said.empty() ? text : text + ", and said: " + said;
}

void setDigits(std::ofstream& out) {
  out.imbue(std::locale::classic());
  out.precision(std::numeric_limits<double>::max_digits10);
}

std::size_t idx(int i) { return static_cast<std::size_t>(i); }

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

MesherOutput orFault(MesherOutput out, const std::string& name, int ended, const std::string& log) {
  if (ended == 0 && !out.cells.empty()) return out;
  return {{}, {}, faultOf(name, ended, log)};
}

}  // namespace

std::optional<std::string> findProgram(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    const std::string program = (folder.empty() ? "." : folder) + "/" + name;
    if (::access(program.c_str(), X_OK) == 0 && fs::is_regular_file(program)) return program;
  }
  return std::nullopt;
}

MesherOutput runGmsh(const std::string& program, const MesherInput& input) {
  const WorkFolder folder;
  writeGmshSurface(input, folder / "surface.msh");
  writeGmshBodies(input, folder / "surface.msh", folder / "bodies.geo");
  const int ended = runProgram({program, folder / "bodies.geo", "-3", "-format", "msh22", "-nt", "1", "-v",
                                "2", "-o", folder / "out.msh"},
                               folder / "log");
  return orFault(readGmsh(folder / "out.msh"), "gmsh", ended, folder / "log");
}

MesherOutput runTetgen(const std::string& program, const MesherInput& input) {
  const WorkFolder folder;
  writeTetgenSurface(input, folder / "surface.poly");
  // The surface as it is (Y), better shapes inside (q), quiet (Q).
  const int ended = runProgram({program, "-pYqQ", folder / "surface.poly"}, folder / "log");
  return orFault(readTetgen(folder / "surface.1.node", folder / "surface.1.ele"), "TetGen", ended,
                 folder / "log");
}

}  // namespace handlebody
