#include "tests/layering/include_rules.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

namespace handlebody::test {

namespace fs = std::filesystem;

namespace {

constexpr std::array kSourceFolders{"core", "ui", "app", "python", "sample_volumes"};

struct Include {
  std::string name;
  int line;
};

using Layers = std::map<std::string, std::set<std::string>>;

// Each part and the parts under it that it may use; its own files go without saying. "core" are the files
// that lie in core itself (errors.h); core/io has rooms, each a part.
const Layers& layers() {
  static const Layers all = [] {
    Layers l;
    const auto add = [&l](const std::string& part, const std::vector<std::string>& under) {
      std::set<std::string>& reach = l[part];
      for (const std::string& u : under) {
        reach.insert(u);
        reach.insert(l.at(u).begin(), l.at(u).end());
      }
    };
    add("core", {});
    add("core/geometry", {"core"});
    add("core/volume", {"core/geometry"});
    add("core/mesh", {"core/geometry"});
    add("core/collision", {"core/mesh"});
    add("core/polish", {"core/collision"});
    add("core/handles", {"core/mesh"});
    add("core/surgery", {"core/collision", "core/handles"});
    add("core/object", {"core/volume", "core/mesh"});
    add("core/solid", {"core/collision", "core/object"});
    add("core/evolution", {"core/surgery", "core/solid"});
    add("core/measure", {"core/solid"});
    add("core/sensitivity", {"core/evolution"});
    add("core/sequence", {"core/evolution"});
    add("core/io", {"core/measure", "core/polish", "core/sensitivity", "core/sequence"});
    add("core/io/meshes", {"core/io"});
    add("core/io/formats", {"core/io/meshes"});
    add("core/io/dicom", {"core/io/formats"});
    add("core/io/decoder", {"core/io/dicom"});
    add("core/io/tetrahedra", {"core/io/meshes"});
    add("core/io/report", {"core/io/dicom", "core/io/tetrahedra"});
    add("sample_volumes", {"core/io/formats"});
    add("app/picture", {"core/io/meshes"});
    add("python", {"sample_volumes", "core/io/report", "core/io/decoder"});
    add("ui/model", {"core/io/report"});
    add("ui/view", {"ui/model"});
    add("ui/window", {"ui/view"});
    add("app", {"ui/window", "sample_volumes", "app/picture"});
    return l;
  }();
  return all;
}

bool startsWith(const std::string& text, const std::string& start) { return text.rfind(start, 0) == 0; }

bool contains(const std::set<std::string>& set, const std::string& value) { return set.count(value) > 0; }

bool isIo(const std::string& path) { return startsWith(path, "core/io/"); }

// "core/mesh/mesh.h" → "core/mesh", "core/errors.h" → "core", "core/io/report/json.h" → "core/io/report",
// "ui/view/slice_view.h" → "ui/view", "app/cli/run.h" → "app", "app/picture/picture.h" →
// "app/picture", a library of the programs; "" for other people's.
std::string partOf(const std::string& path) {
  if (isIo(path)) return path.substr(0, path.rfind('/'));
  const auto slash = path.find('/');
  if (slash == std::string::npos) return {};
  const std::string top = path.substr(0, slash);
  if (top == "tests") return top;
  if (std::find(kSourceFolders.begin(), kSourceFolders.end(), top) == kSourceFolders.end()) return {};
  if (startsWith(path, "app/picture/")) return "app/picture";
  const auto second = path.find('/', slash + 1);
  return (top == "core" || top == "ui") && second != std::string::npos ? path.substr(0, second) : top;
}

bool isHeader(const std::string& path) { return path.ends_with(".h"); }

std::vector<Include> includesOf(const std::string& text) {
  static const std::regex directive(R"(^\s*#\s*include\s*(?:["<]([^">]*)[">]|(\S+)).*)");
  std::vector<Include> found;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::smatch match;
    if (std::regex_match(line, match, directive)) found.push_back({match[1], number});  // "": a macro
  }
  return found;
}

bool isQt(const std::string& name) {
  static const std::regex qt(R"((Q\w+(/.*)?)|(q[a-z]+\.h))");
  return std::regex_match(name, qt);
}

bool isToolkit(const std::string& name) {
  return startsWith(name, "vtk") || startsWith(name, "itk") || startsWith(name, "gdcm");
}

// The standard library's headers are the ones without a folder or an extension in lower case; the compiler's
// own for vector instructions (emmintrin.h …) count with them.
bool isEigenOrStandard(const std::string& name) {
  static const std::regex standard("[a-z_0-9]+|[a-z]+intrin[.]h");
  return startsWith(name, "Eigen/") || std::regex_match(name, standard);
}

// Headers of io through which ITK, GDCM or VTK come in: those that include them, and those that include
// those.
std::set<std::string> headersThatReachToolkits(const SourceTree& sources) {
  std::set<std::string> reaching;
  for (bool grew = true; grew;) {
    grew = false;
    for (const auto& [path, text] : sources) {
      if (!isIo(path) || !isHeader(path) || contains(reaching, path)) continue;
      const auto includes = includesOf(text);
      grew |=
          std::any_of(includes.begin(), includes.end(),
                      [&](const Include& i) { return isToolkit(i.name) || contains(reaching, i.name); }) &&
          reaching.insert(path).second;
    }
  }
  return reaching;
}

std::string faultOfProjectInclude(const std::string& path, const std::string& name,
                                  const std::set<std::string>& reaching) {
  const std::string from = partOf(path), to = partOf(name);
  const auto layer = layers().find(from);
  if (layer == layers().end()) return from + " has no place in the layering yet";
  if (from != to && !contains(layer->second, to)) return from + " may not use " + to;
  if (!isIo(path) && contains(reaching, name)) return "it brings in ITK or VTK and is for core/io alone";
  return {};
}

std::string faultOfForeignInclude(const std::string& path, const std::string& name) {
  if (startsWith(path, "app/picture/") && isQt(name)) return "no Qt in what draws without a display";
  if (!startsWith(path, "core/")) return {};
  if (isQt(name)) return "no Qt in core";
  if (!isIo(path) && !isEigenOrStandard(name)) return "the engine uses Eigen and the standard library only";
  return {};
}

std::string faultOf(const SourceTree& sources, const std::string& path, const std::string& name,
                    const std::set<std::string>& reaching) {
  if (name.empty()) return "an include by macro hides what it includes";
  if (!partOf(name).empty()) return faultOfProjectInclude(path, name, reaching);
  const std::string beside = fs::path(path).parent_path().append(name).lexically_normal().generic_string();
  if (sources.count(beside) > 0) return "project files are included by their path from the top";
  return faultOfForeignInclude(path, name);
}

}  // namespace

SourceTree readSources(const std::string& root) {
  SourceTree sources;
  for (const char* folder : kSourceFolders) {
    if (!fs::exists(fs::path(root) / folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(root) / folder)) {
      const std::string extension = entry.path().extension();
      if (extension != ".h" && extension != ".cpp" && extension != ".txx") continue;
      std::ostringstream text;
      text << std::ifstream(entry.path()).rdbuf();
      sources[fs::relative(entry.path(), root).generic_string()] = text.str();
    }
  }
  return sources;
}

std::vector<std::string> brokenRules(const SourceTree& sources) {
  const std::set<std::string> reaching = headersThatReachToolkits(sources);
  std::vector<std::string> broken;
  for (const auto& [path, text] : sources)
    for (const Include& include : includesOf(text)) {
      const std::string fault = faultOf(sources, path, include.name, reaching);
      if (fault.empty()) continue;
      broken.push_back(path + ":" + std::to_string(include.line) + ": " + include.name + ": " + fault);
    }
  return broken;
}

}  // namespace handlebody::test
