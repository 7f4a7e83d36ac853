#include "core/io/report/object_paths.h"

#include "tests/support/catch.h"

using namespace handlebody;
using Strings = std::vector<std::string>;

TEST_CASE("the name of an object goes before the ending of its file") {
  CHECK(objectPaths("/a/ct.stl", ".stl", {"liver", "back muscle"}) ==
        Strings{"/a/ct_liver.stl", "/a/ct_back muscle.stl"});
  CHECK(objectPaths("/a.b/ct.SEG.NRRD", ".seg.nrrd", {"liver"}) == Strings{"/a.b/ct_liver.SEG.NRRD"});
}

TEST_CASE("no name of an object leads into another folder, or is refused by a file system") {
  CHECK(objectPaths("x.stl", ".stl", {"../a\\b", "1: ?", std::string("a\nb")}) ==
        Strings{"x_.._a_b.stl", "x_1_ _.stl", "x_a_b.stl"});
}

TEST_CASE("objects whose files would have the same name get numbers") {
  CHECK(objectPaths("x.stl", ".stl", {"a/b", "A:B", "a_b", "a_b_2"}) ==
        Strings{"x_a_b.stl", "x_A_B_2.stl", "x_a_b_3.stl", "x_a_b_2_2.stl"});
}

TEST_CASE("a long name of an object is cut between two characters") {
  std::string name;
  for (int i = 0; i < 80; ++i) name += "\xC3\xA4";  // ä
  const std::string path = objectPaths("x.stl", ".stl", {"n" + name})[0];
  CHECK(path == "x_n" + name.substr(0, 98) + ".stl");
}
