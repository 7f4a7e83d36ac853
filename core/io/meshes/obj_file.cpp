// OBJ by hand: VTK's writer and reader keep six digits, which is not enough to keep a mesh free of
// self-intersections.

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <vector>

#include "core/io/atomic_file.h"
#include "core/io/meshes/mesh_files.h"
#include "core/told_error.h"

namespace handlebody {
namespace {

//! The shortest text that reads back as the same number, whatever the locale.
void append(std::string& text, double value) {
  char digits[32];
  const auto result = std::to_chars(digits, digits + sizeof digits, value);
  text.append(digits, result.ptr);
}

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

const char* skipBlanks(const char* at, const char* end) {
  while (at < end && isBlank(*at)) ++at;
  return at;
}

class ObjReader {
 public:
  explicit ObjReader(std::string path) : path_(std::move(path)) {}

  MeshFile read() {
    std::ifstream stream(path_, std::ios::binary);
    std::string line;
    while (std::getline(stream, line)) {
      ++line_;
      const char* end = line.data() + line.size();
      const char* at = skipBlanks(line.data(), end);
      if (at == end) continue;
      if (*at == '#' && line.find("SPACE=") != std::string::npos) file_.space = spaceIn(line);
      const bool isLetter = at + 1 == end || isBlank(at[1]);  // vt and vn are others
      if (isLetter && *at == 'v') readVertex(at + 1, end);
      if (isLetter && *at == 'f') readFace(at + 1, end);
    }
    return std::move(file_);
  }

 private:
  [[noreturn]] void refuse(const Finding& cause) const {
    throw Told<InputError>(
        Finding(FindingKind::fileRefusedInLine, {{"file", path_}, {"line", line_}}, cause));
  }

  void readVertex(const char* at, const char* end) {
    Vec3 p;
    for (int a = 0; a < 3; ++a) {
      at = skipBlanks(at, end);
      const auto result = std::from_chars(at, end, p[a]);
      if (result.ec != std::errc() || !std::isfinite(p[a])) refuse(FindingKind::vertexDamaged);
      at = result.ptr;
    }
    file_.mesh.points.push_back(p);
  }

  //! Corners are v, v/t, v//n or v/t/n; negative ones count from the end.
  void readFace(const char* at, const char* end) {
    const auto count = static_cast<long long>(file_.mesh.points.size());
    corners_.clear();
    for (at = skipBlanks(at, end); at < end; at = skipBlanks(at, end)) {
      long long v = 0;
      const auto result = std::from_chars(at, end, v);
      if (result.ec != std::errc()) refuse(FindingKind::faceDamaged);
      v = v < 0 ? count + v : v - 1;
      if (v < 0 || v >= count) refuse(FindingKind::faceVertexMissing);
      corners_.push_back(static_cast<int>(v));
      at = result.ptr;
      while (at < end && *at != ' ' && *at != '\t') ++at;
    }
    if (corners_.size() < 3) refuse(FindingKind::faceTooFewCorners);
    for (std::size_t i = 2; i < corners_.size(); ++i)
      file_.mesh.triangles.push_back({corners_[0], corners_[i - 1], corners_[i]});
  }

  std::string path_;
  MeshFile file_;
  std::vector<int> corners_;
  int line_ = 0;
};

}  // namespace

namespace {

//! Names of groups end at a blank.
std::string groupLine(std::string name) {
  std::replace(name.begin(), name.end(), ' ', '_');
  return "g " + name + "\n";
}

}  // namespace

void writeObj(const MeshFile& file, const std::string& temporary) {
  std::string text = "# " + spaceMark(file.space) + "\n# Handlebody, coordinates in mm\n";
  for (const Vec3& p : file.mesh.points) {
    text += "v";
    for (int a = 0; a < 3; ++a) {
      text += ' ';
      append(text, p[a]);
    }
    text += '\n';
  }
  std::size_t begins = 0, part = 0;  // the next group
  for (std::size_t i = 0; i < file.mesh.triangles.size(); ++i) {
    for (; part < file.parts.size() && i == begins; ++part) {
      text += groupLine(file.parts[part].name);
      begins += file.parts[part].triangles;
    }
    text += "f";
    for (int v : file.mesh.triangles[i]) text += ' ' + std::to_string(v + 1);
    text += '\n';
  }
  std::ofstream stream(temporary, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) refuseOutput(temporary, FindingKind::diskMayBeFull);
}

MeshFile readObj(const std::string& path) { return ObjReader(path).read(); }

}  // namespace handlebody
