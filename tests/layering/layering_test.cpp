// The dependency rule, on the project itself and on small trees that break it.

#include <algorithm>
#include <cctype>
#include <sstream>

#include "tests/layering/include_rules.h"
#include "tests/support/catch.h"

using namespace handlebody::test;

namespace {

SourceTree including(const std::string& path, const std::string& include) {
  return {{path, "#pragma once\n#include " + include + "\n"}};
}

//! The lines of a source in which a text names an option of the command line; not what is in comments, nor
//! a command that is told with its options.
std::string namedOptions(const std::string& source) {
  std::string found;
  std::istringstream lines(source);
  for (std::string line; std::getline(lines, line);) {
    const std::string code = line.substr(0, line.find("//"));
    for (auto at = code.find("--"); at != std::string::npos; at = code.find("--", at + 2)) {
      const bool isText = std::count(code.begin(), code.begin() + at, '"') % 2 == 1;
      const bool isName = at + 2 < code.size() && std::islower(static_cast<unsigned char>(code[at + 2]));
      if (isText && isName && code.rfind("(handlebody-cli ", at) == std::string::npos) found += code + '\n';
    }
  }
  return found;
}

bool breaks(const std::string& path, const std::string& include) {
  return !brokenRules(including(path, include)).empty();
}

}  // namespace

TEST_CASE("no include of the project breaks the dependency rule") {
  const SourceTree sources = readSources(HANDLEBODY_SOURCE_DIR);
  REQUIRE(sources.count("core/errors.h") == 1);
  REQUIRE(sources.count("core/geometry/vec.h") == 1);
  REQUIRE(sources.count("app/cli/main.cpp") == 1);
  std::string all;
  for (const std::string& broken : brokenRules(sources)) all += broken + "\n";
  CHECK(all == "");
}

TEST_CASE("the engine's texts name no option as the command line writes it") {
  CHECK(namedOptions("f(\"--range\");\nf(\"\", --n);  // \"--seed\"") == "f(\"--range\");\n");
  for (const auto& [path, source] : readSources(HANDLEBODY_SOURCE_DIR)) {
    // In the report's folder are the options themselves, and what of them stands in reports.
    if (path.rfind("core/", 0) != 0 || path.rfind("core/io/report/", 0) == 0) continue;
    INFO(path);
    CHECK(namedOptions(source) == "");
  }
}

TEST_CASE("the engine's library links Eigen, threads and nothing else") {
  CHECK(std::string(HANDLEBODY_CORE_LINKS) == "handlebody_options,Eigen3::Eigen,Threads::Threads");
}

TEST_CASE("a breach is told with its file, line and reason") {
  const auto broken = brokenRules(including("core/mesh/mesh.h", "\"core/surgery/event.h\""));
  REQUIRE(broken.size() == 1);
  CHECK(broken[0] == "core/mesh/mesh.h:2: core/surgery/event.h: core/mesh may not use core/surgery");
}

TEST_CASE("each part uses the parts under it and not the ones above or beside") {
  const std::vector<std::string> line{"geometry", "mesh", "collision", "surgery", "evolution", "io"};
  for (std::size_t upper = 1; upper < line.size(); ++upper)
    for (std::size_t lower = 0; lower < upper; ++lower) {
      INFO(line[upper] << " on " << line[lower]);
      CHECK_FALSE(breaks("core/" + line[upper] + "/a.cpp", "\"core/" + line[lower] + "/b.h\""));
      CHECK(breaks("core/" + line[lower] + "/b.h", "\"core/" + line[upper] + "/a.h\""));
    }
  CHECK(breaks("core/collision/a.h", "\"core/handles/b.h\""));
  CHECK(breaks("core/handles/a.h", "\"core/collision/b.h\""));
  CHECK(breaks("core/volume/a.h", "\"core/mesh/b.h\""));
  CHECK(breaks("core/surgery/a.h", "\"core/volume/b.h\""));
  CHECK_FALSE(breaks("core/evolution/a.h", "\"core/volume/b.h\""));
}

TEST_CASE("the rooms of io use each other one way") {
  const std::vector<std::string> line{"meshes", "formats", "dicom", "decoder"};
  for (std::size_t upper = 1; upper < line.size(); ++upper)
    for (std::size_t lower = 0; lower < upper; ++lower) {
      INFO(line[upper] << " on " << line[lower]);
      CHECK_FALSE(breaks("core/io/" + line[upper] + "/a.cpp", "\"core/io/" + line[lower] + "/b.h\""));
      CHECK(breaks("core/io/" + line[lower] + "/b.cpp", "\"core/io/" + line[upper] + "/a.h\""));
    }
  CHECK(breaks("core/io/report/a.cpp", "\"core/io/decoder/b.h\""));
  CHECK(breaks("core/io/atomic_file.cpp", "\"core/io/formats/b.h\""));
  CHECK_FALSE(breaks("core/io/meshes/a.cpp", "\"core/io/atomic_file.h\""));
  CHECK(breaks("core/measure/a.cpp", "\"core/io/formats/b.h\""));
  CHECK_FALSE(breaks("ui/model/a.cpp", "\"core/io/formats/b.h\""));
}

TEST_CASE("the model does not know its views, nor the views the window") {
  CHECK(breaks("ui/model/a.h", "\"ui/view/b.h\""));
  CHECK(breaks("ui/model/a.cpp", "\"ui/window/b.h\""));
  CHECK(breaks("ui/view/a.cpp", "\"ui/window/b.h\""));
  CHECK_FALSE(breaks("ui/view/a.h", "\"ui/model/b.h\""));
  CHECK_FALSE(breaks("ui/window/a.h", "\"ui/model/b.h\""));
  CHECK_FALSE(breaks("ui/window/a.h", "\"ui/view/b.h\""));
  CHECK_FALSE(breaks("ui/model/a.h", "\"core/mesh/b.h\""));
  CHECK_FALSE(breaks("app/handlebody/main.cpp", "\"ui/window/b.h\""));
}

TEST_CASE("pictures without a display are the programs' alone, and know nothing of the window") {
  CHECK_FALSE(breaks("app/cli/run.cpp", "\"app/picture/picture.h\""));
  CHECK_FALSE(breaks("app/picture/a.cpp", "\"core/io/meshes/b.h\""));
  CHECK_FALSE(breaks("app/picture/a.cpp", "<vtkPNGWriter.h>"));
  for (const char* beside : {"core/io/report/b.h", "sample_volumes/b.h", "ui/view/b.h", "app/cli/b.h"})
    CHECK(breaks("app/picture/a.cpp", '"' + std::string(beside) + '"'));
  CHECK(breaks("app/picture/a.cpp", "<QPainter>"));
  for (const char* other : {"core/io/a.cpp", "core/mesh/a.cpp", "ui/model/a.cpp", "python/a.cpp"})
    CHECK(breaks(other, "\"app/picture/picture.h\""));
}

TEST_CASE("the Python module stands on the engine, its files and the phantoms, and nothing on it") {
  for (const char* under : {"core/evolution/a.h", "core/io/a.h", "sample_volumes/a.h"})
    CHECK_FALSE(breaks("python/b.cpp", '"' + std::string(under) + '"'));
  for (const char* beside : {"app/cli/run.h", "ui/model/a.h", "tests/support/catch.h"})
    CHECK(breaks("python/b.cpp", '"' + std::string(beside) + '"'));
  for (const char* other : {"core/io/a.cpp", "app/cli/a.cpp", "ui/model/a.cpp", "sample_volumes/a.cpp"})
    CHECK(breaks(other, "\"python/b.h\""));
}

TEST_CASE("angle brackets do not get round the rule") {
  CHECK(breaks("core/mesh/a.cpp", "<core/surgery/event.h>"));
  CHECK(breaks("core/mesh/a.cpp", "  <core/surgery/event.h>  // a remark"));
}

TEST_CASE("core does not use the programs, the window, the phantoms or the tests") {
  for (const char* above : {"app/cli/run.h", "ui/view/view.h", "sample_volumes/phantom.h",
                            "app/picture/picture.h", "tests/support/catch.h"}) {
    INFO(above);
    CHECK(breaks("core/evolution/a.cpp", '"' + std::string(above) + '"'));
    CHECK(breaks("core/io/a.cpp", '"' + std::string(above) + '"'));
  }
  CHECK(breaks("ui/view/view.cpp", "\"app/cli/run.h\""));
  CHECK(breaks("app/cli/run.cpp", "\"tests/support/catch.h\""));
  CHECK_FALSE(breaks("app/cli/run.cpp", "\"sample_volumes/phantom.h\""));
}

TEST_CASE("the engine includes Eigen and the standard library only") {
  for (const char* allowed : {"<vector>", "<cstdint>", "<Eigen/Core>", "\"core/errors.h\""})
    CHECK_FALSE(breaks("core/mesh/a.h", allowed));
  for (const char* other :
       {"<unistd.h>", "<nlohmann/json.hpp>", "<CGAL/Kernel.h>", "<tbb/parallel_for.h>", "<QString>",
        "<vtkPolyData.h>", "<itkImage.h>", "<gdcmReader.h>", "\"vtkPolyData.h\""}) {
    INFO(other);
    CHECK(breaks("core/mesh/a.h", other));
    CHECK(breaks("core/evolution/a.cpp", other));
    CHECK(breaks("core/errors.h", other));
  }
}

TEST_CASE("Qt stays out of io as well") {
  for (const char* qt : {"<QString>", "<QtCore/QString>", "<qobject.h>"}) CHECK(breaks("core/io/a.cpp", qt));
  CHECK_FALSE(breaks("ui/view/view.h", "<QWidget>"));
}

TEST_CASE("headers of io that reach ITK or VTK are for io alone") {
  SourceTree tree{{"core/io/inner.h", "#include <itkImage.h>\n"},
                  {"core/io/outer.h", "#include \"core/io/inner.h\"\n"},
                  {"core/io/reader.cpp", "#include \"core/io/outer.h\"\n#include <vtkPolyData.h>\n"},
                  {"core/io/reader.h", "#include <string>\n"},
                  {"app/main.cpp", "#include \"core/io/reader.h\"\n"}};
  CHECK(brokenRules(tree).empty());
  tree["app/main.cpp"] = "#include \"core/io/outer.h\"\n";
  CHECK(brokenRules(tree).size() == 1);
  tree["sample_volumes/make.cpp"] = "#include \"core/io/inner.h\"\n";
  CHECK(brokenRules(tree).size() == 2);
}

TEST_CASE("includes that the rules could not see are refused") {
  CHECK(breaks("core/mesh/a.cpp", "SOME_HEADER"));
  CHECK(breaks("core/novel/a.cpp", "\"core/geometry/vec.h\""));
  const SourceTree beside{{"core/io/a.cpp", "#include \"b.h\"\n"}, {"core/io/b.h", ""}};
  CHECK(brokenRules(beside).size() == 1);
  const SourceTree upwards{{"app/cli/a.cpp", "#include \"../b.h\"\n"}, {"app/b.h", ""}};
  CHECK(brokenRules(upwards).size() == 1);
}
