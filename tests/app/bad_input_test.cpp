// Every bad input: the right exit code, one sentence that names the file or the option, no file left behind.

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>

#include "tests/app/refusal.h"
#include "tests/app/run_cli.h"
#include "tests/support/catch.h"

using namespace handlebody::test;

namespace {

void requireUnreadable(const TempFolder& folder, const std::string& name) {
  INFO(name);
  requireRefusal(folder, {"segment", folder / name, "--seed", "1,1,1", "-o", folder / "out.stl"}, 3, name);
  requireRefusal(folder, {"info", folder / name}, 3, name);
}

std::string metaHeader(const std::string& size, const std::string& type, int dimensions = 3) {
  return "ObjectType = Image\nNDims = " + std::to_string(dimensions) +
         "\nBinaryData = True\nBinaryDataByteOrderMSB = False\nDimSize = " + size +
         "\nElementType = " + type + "\nElementDataFile = LOCAL\n";
}

// 8 x 8 x 8 floats, all 1 but for the one in the middle.
std::string floatVolume(float odd) {
  std::vector<float> voxels(512, 1.0F);
  voxels[300] = odd;
  std::string bytes(voxels.size() * sizeof(float), '\0');
  std::memcpy(bytes.data(), voxels.data(), bytes.size());
  return metaHeader("8 8 8", "MET_FLOAT") + bytes;
}

void truncate(const std::string& path, double share) {
  const std::string bytes = readBytes(path);
  writeBytes(path, bytes.substr(0, static_cast<std::size_t>(share * static_cast<double>(bytes.size()))));
}

}  // namespace

TEST_CASE("a file that is not there is unreadable", "[cli][bad]") {
  const TempFolder folder;
  requireUnreadable(folder, "missing.nii.gz");
  requireUnreadable(folder, "missing.nrrd");
  requireUnreadable(folder, "missing-folder/");
}

TEST_CASE("an empty file is unreadable", "[cli][bad]") {
  const TempFolder folder;
  for (const char* name : {"e.nii", "e.nii.gz", "e.nrrd", "e.mha", "e.dcm", "e.tif"}) {
    writeBytes(folder / name, "");
    requireUnreadable(folder, name);
  }
}

TEST_CASE("a folder without images is unreadable", "[cli][bad]") {
  const TempFolder folder;
  std::filesystem::create_directory(folder / "empty");
  std::filesystem::create_directory(folder / "letters");
  writeBytes(folder / "letters/hello.txt", "hello");
  requireUnreadable(folder, "empty");
  requireUnreadable(folder, "letters");
}

TEST_CASE("a truncated volume is unreadable", "[cli][bad]") {
  const TempFolder folder;
  for (const char* name : {"t.nii", "t.nii.gz", "t.nrrd", "t.mha"})
    for (double share : {0.9, 0.5, 0.01}) {
      INFO(share);
      makePhantomFile(folder, name);
      truncate(folder / name, share);
      requireUnreadable(folder, name);
    }
}

TEST_CASE("text with the ending of a volume is unreadable", "[cli][bad]") {
  const TempFolder folder;
  for (const char* name : {"x.nii.gz", "x.nii", "x.nrrd", "x.mha", "x.dcm", "x.unknown"}) {
    writeBytes(folder / name, "This is a letter and not a volume.\n");
    requireUnreadable(folder, name);
  }
}

TEST_CASE("infinite voxels are refused, and those that are not a number told of", "[cli][bad]") {
  const TempFolder folder;
  writeBytes(folder / "nan.mha", floatVolume(std::numeric_limits<float>::quiet_NaN()));
  writeBytes(folder / "inf.mha", floatVolume(-std::numeric_limits<float>::infinity()));
  const auto warnings = runForJson({"info", folder / "nan.mha", "--json"}).at("warnings").dump();
  CHECK(warnings.find("not a number: they count as outside of the field of view") != std::string::npos);
  requireUnreadable(folder, "inf.mha");
  writeBytes(folder / "fine.mha", floatVolume(2));
  CHECK(runCli({"info", folder / "fine.mha"}).exitCode == 0);
}

TEST_CASE("a volume without voxels and a flat image are refused", "[cli][bad]") {
  const TempFolder folder;
  writeBytes(folder / "zero.mha", metaHeader("0 8 8", "MET_UCHAR"));
  writeBytes(folder / "flat.mha", metaHeader("8 8", "MET_UCHAR", 2) + std::string(64, '\1'));
  requireUnreadable(folder, "zero.mha");
  requireUnreadable(folder, "flat.mha");
}

TEST_CASE("a seed outside the volume or on the background has an exit code of its own", "[cli][bad]") {
  const TempFolder folder;
  const PhantomFile phantom = makePhantomFile(folder);
  const std::string out = folder / "out.stl";
  requireRefusal(folder, {"segment", phantom.path, "--seed", "1000,0,0", "-o", out}, 4, "seed");
  requireRefusal(folder, {"segment", phantom.path, "--seed-ijk", "-5,3,3", "-o", out}, 4, "seed");
  // The object of the phantom is dark; the corner is bright background.
  const auto info = runForJson({"info", phantom.path, "--json"});
  const std::string dark = "-inf," + info.at("intensities").at("percentiles").at("5").dump();
  requireRefusal(folder, {"segment", phantom.path, "--range", dark, "--seed-ijk", "2,2,2", "-o", out}, 4,
                 "seed");
}

TEST_CASE("a seed on the bright background is not in a dark object", "[cli][bad]") {
  const TempFolder folder;
  const PhantomFile phantom = makePhantomFile(folder);
  const std::string out = folder / "out.stl";
  requireRefusal(folder, {"segment", phantom.path, "--object", "dark", "--seed-ijk", "2,2,2", "-o", out}, 4,
                 "seed");
}

TEST_CASE("a range without voxels is a mistake in --range", "[cli][bad]") {
  const TempFolder folder;
  const PhantomFile phantom = makePhantomFile(folder);
  for (const char* range : {"5000,6000", "-inf,-100"})
    requireRefusal(
        folder, {"segment", phantom.path, "--seed", phantom.seed, "--range", range, "-o", folder / "out.stl"},
        2, "range");
}

TEST_CASE("an output that cannot be written is refused before the work", "[cli][bad]") {
  const TempFolder folder;
  const PhantomFile phantom = makePhantomFile(folder);
  writeBytes(folder / "file", "");
  std::filesystem::create_directory(folder / "sub.stl");
  const auto refuse = [&](const std::string& option, const std::string& path) {
    std::vector<std::string> arguments{"segment", phantom.path, "--seed", phantom.seed, option, path};
    if (option != "-o") arguments.insert(arguments.end(), {"-o", folder / "out.stl"});
    requireRefusal(folder, arguments, 2, option);
  };
  refuse("-o", folder / "missing/out.stl");
  refuse("-o", folder / "file/out.stl");
  refuse("-o", folder / "sub.stl");
  refuse("-o", "/proc/out.stl");
  refuse("-o", "");
  refuse("-o", phantom.path);
  refuse("--report", folder / "missing/r.json");
  refuse("--session", folder / "missing/s.json");
  refuse("--trace", folder / "missing/t.json");
  refuse("--picture", folder / "missing/p.png");
  refuse("--report", folder / "out.stl");
  refuse("--report", "/dev/null");
}

TEST_CASE("an unknown ending of an output is refused before the input is opened", "[cli][bad]") {
  const TempFolder folder;
  const std::string missing = folder / "missing.mha";
  for (const char* name : {"out.xyz", "out", "out.stl.txt", "out.gz"})
    requireRefusal(folder, {"segment", missing, "--seed", "1,1,1", "-o", folder / name}, 2, name);
  requireRefusal(
      folder, {"segment", missing, "--seed", "1,1,1", "-o", folder / "m.stl", "--picture", folder / "p.jpg"},
      2, "p.jpg");
  requireRefusal(folder, {"phantom", "sphere", "-o", folder / "p.stl"}, 2, "p.stl");
  requireRefusal(folder, {"phantom", "sphere", "-o", folder / "p.mha", "--surface", folder / "s.mha"}, 2,
                 "s.mha");
}

TEST_CASE("mistakes on the command line are named", "[cli][bad]") {
  const TempFolder folder;
  const std::vector<std::pair<std::string, std::string>> wrong{
      {"--seed", "1,2"},         {"--seed", "nan,1,1"},       {"--seed", "1,1,inf"},
      {"--seed", "1,1,1,0"},     {"--seed-ijk", "a,b,c"},     {"--object", "grey"},
      {"--range", "2,1"},        {"--range", "nan,1"},        {"--smoothing", "-1"},
      {"--smoothing", "some"},   {"--edge-length", "0"},      {"--edge-length", "inf"},
      {"--direction", "inward"}, {"--balloon", "0"},          {"--balloon", "-1"},
      {"--curvature", "-0.1"},   {"--threads", "0"},          {"--threads", "1.5"},
      {"--max-iterations", "0"}, {"--max-iterations", "1e3"}, {"--space", "MNI"},
      {"--frame", "-1"},         {"--unknown", "1"}};
  for (const auto& [option, value] : wrong) {
    INFO(option << " " << value);
    requireRefusal(folder, {"segment", "v.mha", "--seed", "1,1,1", "-o", folder / "o.stl", option, value}, 2,
                   option);
  }
}

TEST_CASE("mistakes about the background and the candidate are named", "[cli][bad]") {
  const TempFolder folder;
  const auto refused = [&folder](const std::string& option, const std::string& value) {
    INFO(option << " " << value);
    requireRefusal(folder, {"segment", "v.mha", "--seed", "1,1,1", "-o", folder / "o.stl", option, value}, 2,
                   option + ": ");
  };
  for (const char* value : {"1,2", "1,1,1,0", "a,b,c", "nan,1,1"}) {
    refused("--background", value);
    refused("--background-ijk", value);
  }
  for (const char* value : {"0", "-1", "6", "1.5", "first"}) refused("--candidate", value);
}

TEST_CASE("a command line that asks for nothing is a mistake", "[cli][bad]") {
  const TempFolder folder;
  requireRefusal(folder, {}, 2, "subcommand");
  requireRefusal(folder, {"divide"}, 2, "");
  requireRefusal(folder, {"segment"}, 2, "VOLUME");
  requireRefusal(folder, {"segment", "v.mha", "--seed", "1,1,1"}, 2, "--output");
  requireRefusal(folder, {"segment", "v.mha", "-o", folder / "o.stl"}, 2, "--seed");
  requireRefusal(folder, {"segment", "v.mha", "--background", "1,1,1", "-o", folder / "o.stl"}, 2, "--seed");
  requireRefusal(folder, {"segment", "v.mha", "w.mha", "--seed", "1,1,1", "-o", folder / "o.stl"}, 2,
                 "w.mha");
  requireRefusal(folder, {"segment", "v.mha", "--seed", "1,1,1", "-o", folder / "o.stl", folder / "p.stl"}, 2,
                 "p.stl");
  requireRefusal(folder, {"check"}, 2, "MESH");
  requireRefusal(folder, {"handles"}, 2, "--sizes");
  requireRefusal(folder, {"handles", "--sizes", "3"}, 2, "--sizes");
  requireRefusal(folder, {"handles", "--sizes", "3,2"}, 2, "--sizes");
  requireRefusal(folder, {"handles", "--sizes", "3,4", "--family", "other"}, 2, "--family");
  requireRefusal(folder, {"phantom", "unicorn", "-o", folder / "p.mha"}, 2, "unicorn");
  requireRefusal(folder, {"phantom", "sphere", "-o", folder / "p.mha", "--spacing", "1,0,1"}, 2, "--spacing");
  requireRefusal(folder, {"phantom", "sphere", "-o", folder / "p.mha", "--size", "9,9"}, 2, "--size");
  requireRefusal(folder, {"phantom", "sphere", "-o", folder / "p.mha", "--type", "int64"}, 2, "--type");
}

TEST_CASE("a mesh that cannot be read is unreadable", "[cli][bad]") {
  const TempFolder folder;
  for (const char* name : {"m.stl", "m.vtp", "m.ply", "m.obj", "m.xyz"}) {
    INFO(name);
    requireRefusal(folder, {"check", folder / name}, 3, name);
    writeBytes(folder / name, "");
    requireRefusal(folder, {"check", folder / name}, 3, name);
    writeBytes(folder / name, "This is a letter and not a mesh.\n");
    requireRefusal(folder, {"check", folder / name}, 3, name);
  }
}

TEST_CASE("a session that is damaged or lacks its volume is unreadable", "[cli][bad]") {
  const TempFolder folder;
  const std::string session = folder / "s.json";
  requireRefusal(folder, {"replay", session, "-o", folder / "o.stl"}, 3, "s.json");
  for (const char* text : {"", "{", "[]", "{\"version\": 1}"}) {
    writeBytes(session, text);
    requireRefusal(folder, {"replay", session, "-o", folder / "o.stl"}, 3, "s.json");
  }
  writeBytes(session, R"({"version": "0", "input": {"path": "gone.mha", "sha256": "00"},
                          "requested": {"seeds": [{"centre": [1, 1, 1]}]}})");
  const Outcome outcome = runCli({"replay", session, "-o", folder / "o.stl"});
  CHECK(outcome.exitCode == 3);
  CHECK_THAT(outcome.err, Contains("gone.mha"));
  CHECK(folder.names() == std::vector<std::string>{"s.json"});
}
