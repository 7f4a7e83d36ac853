#include <sys/resource.h>
#include <sys/wait.h>
#include <zlib.h>

#include <atomic>
#include <limits>

#include "core/cancellation.h"
#include "core/io/formats/sha256.h"
#include "tests/io/comma_locale.h"
#include "tests/io/io_test_support.h"

using namespace handlebody;
using namespace handlebody::test;

namespace {

const VoxelType kAllTypes[] = {VoxelType::uint8,  VoxelType::int8,  VoxelType::uint16,  VoxelType::int16,
                               VoxelType::uint32, VoxelType::int32, VoxelType::float32, VoxelType::float64};

void expectSameGrid(const Grid& a, const Grid& b, double tolerance) {
  CHECK(a.size == b.size);
  CHECK((a.spacing - b.spacing).norm() < tolerance);
  CHECK((a.origin - b.origin).norm() < tolerance);
  CHECK((a.direction - b.direction).norm() < tolerance);
  CHECK((a.direction.transpose() * a.direction - Eigen::Matrix3d::Identity()).norm() < 1e-12);
}

std::string niftiBytes(const TemporaryFolder& folder, VoxelType type) {
  writeVolume(randomVolume(obliqueGrid(), type), folder / "made.nii");
  return readBytes(folder / "made.nii");
}

std::string nrrdHeader(const std::string& type, const std::string& sizes, const std::string& rest) {
  const auto dimension = std::count(sizes.begin(), sizes.end(), ' ') + 1;
  return "NRRD0004\ntype: " + type + "\ndimension: " + std::to_string(dimension) + "\nsizes: " + sizes +
         "\nendian: little\nencoding: raw\n" + rest + "\n";
}

//! Little-endian TIFF of pages of 8 bits, or of floats of 32.
std::string tiffBytes(int width, int height, const std::vector<std::string>& pages, bool areFloats = false) {
  constexpr std::uint32_t kWholeNumbers = 1, kFloats = 3;
  std::string bytes("II*\0\0\0\0\0", 8);
  std::size_t link = 4;
  for (const std::string& page : pages) {
    const std::size_t data = bytes.size();
    bytes += page;
    if (bytes.size() % 2) bytes += '\0';
    patch(bytes, link, static_cast<std::uint32_t>(bytes.size()));
    const std::uint32_t tags[][3] = {{256, 4, static_cast<std::uint32_t>(width)},
                                     {257, 4, static_cast<std::uint32_t>(height)},
                                     {258, 3, areFloats ? 32U : 8U},
                                     {259, 3, 1},
                                     {262, 3, 1},
                                     {273, 4, static_cast<std::uint32_t>(data)},
                                     {277, 3, 1},
                                     {278, 4, static_cast<std::uint32_t>(height)},
                                     {279, 4, static_cast<std::uint32_t>(page.size())},
                                     {339, 3, areFloats ? kFloats : kWholeNumbers}};
    std::string directory(2 + std::size(tags) * 12 + 4, '\0');
    patch(directory, 0, static_cast<std::uint16_t>(std::size(tags)));
    for (std::size_t i = 0; i < std::size(tags); ++i) {
      patch(directory, 2 + 12 * i, static_cast<std::uint16_t>(tags[i][0]));
      patch(directory, 4 + 12 * i, static_cast<std::uint16_t>(tags[i][1]));
      patch(directory, 6 + 12 * i, std::uint32_t{1});
      patch(directory, 10 + 12 * i, tags[i][2]);
    }
    link = bytes.size() + directory.size() - 4;
    bytes += directory;
  }
  return bytes;
}

//! Growth of the process's peak memory while it reads `path`, in bytes (in a child, whose peak is its own).
double peakOfReading(const std::string& path) {
  int ends[2];
  REQUIRE(pipe(ends) == 0);
  const pid_t child = fork();
  if (child == 0) {
    const auto peak = [] {
      rusage usage{};
      getrusage(RUSAGE_SELF, &usage);
      return static_cast<double>(usage.ru_maxrss) * 1024;
    };
    inspectVolume(path);  // libraries have loaded what they need
    const double before = peak();
    const Volume volume = readVolume(path);
    const double growth = volume.voxels ? peak() - before : -1;
    const bool sent = ::write(ends[1], &growth, sizeof growth) == sizeof growth;
    _exit(sent ? 0 : 1);
  }
  double growth = -1;
  REQUIRE(read(ends[0], &growth, sizeof growth) == sizeof growth);
  waitpid(child, nullptr, 0);
  close(ends[0]);
  close(ends[1]);
  return growth;
}

}  // namespace

TEST_CASE("volumes come back with their type, voxels and oblique anisotropic geometry") {
  const TemporaryFolder folder;
  const std::string name = GENERATE("v.nii", "v.nii.gz", "v.nrrd", "v.mha", "V.NII.GZ");
  for (const VoxelType type : kAllTypes) {
    INFO(name << " " << voxelTypeName(type));
    const Volume volume = randomVolume(obliqueGrid(), type);
    writeVolume(volume, folder / name);
    CHECK(folder.fileCount() == 1);
    const Volume back = readVolume(folder / name);
    CHECK(back.type == type);
    CHECK((voxelBytes(back) == voxelBytes(volume)));
    // NIfTI holds its geometry in single precision: 121.5 mm to 7e-6 mm.
    const bool single = name[2] == 'n' && name[3] == 'i';
    expectSameGrid(back.grid, volume.grid, single || name[0] == 'V' ? 2e-5 : 1e-9);
    const VolumeInfo info = inspectVolume(folder / name);
    CHECK(info.type == type);
    CHECK(info.frames == 1);
    CHECK(info.warnings.empty());
    expectSameGrid(info.grid, back.grid, 1e-15);
    fs::remove(folder / name);
  }
}

TEST_CASE("a locale with a decimal comma changes no number of a volume that is written") {
  const TemporaryFolder folder;
  const Volume volume = randomVolume(obliqueGrid(), VoxelType::int16);
  const CommaLocale comma;
  if (!comma.isChosen()) return;
  for (const char* name : {"v.nii.gz", "v.nrrd", "v.mha"}) {
    INFO(name);
    REQUIRE_NOTHROW(writeVolume(volume, folder / name));
    expectSameGrid(readVolume(folder / name).grid, volume.grid, 2e-5);
    CHECK(*localeconv()->decimal_point == ',');  // the host's, as before
  }
}

TEST_CASE("every axis permutation and reflection survives NIfTI") {
  const TemporaryFolder folder;
  for (int code = 0; code < 48; ++code) {
    Grid grid = obliqueGrid();
    std::array<int, 3> order{0, 1, 2};
    for (int i = 0; i < code / 8; ++i) std::next_permutation(order.begin(), order.end());
    grid.direction.setZero();
    for (int a = 0; a < 3; ++a) grid.direction(order[a], a) = (code >> a & 1) ? -1 : 1;
    writeVolume(randomVolume(grid, VoxelType::uint8), folder / "v.nii");
    expectSameGrid(readVolume(folder / "v.nii").grid, grid, 2e-5);
  }
}

TEST_CASE("a 4D NIfTI gives the chosen time point, and the first with a warning") {
  const TemporaryFolder folder;
  std::string bytes = niftiBytes(folder, VoxelType::int16);
  const std::size_t frame = obliqueGrid().voxelCount() * 2;
  const std::string first = bytes.substr(352, frame);
  std::string second = first, third = first;
  second[0] = static_cast<char>(second[0] + 1);
  third[frame - 1] = static_cast<char>(third[frame - 1] + 1);
  patch(bytes, 40, std::int16_t{4});
  patch(bytes, 48, std::int16_t{3});
  bytes += second + third;
  const bool compressed = GENERATE(false, true);
  const std::string path = folder / (compressed ? "4d.nii.gz" : "4d.nii");
  if (compressed) {
    const gzFile file = gzopen(path.c_str(), "wb");
    REQUIRE(gzwrite(file, bytes.data(), static_cast<unsigned>(bytes.size())) ==
            static_cast<int>(bytes.size()));
    gzclose(file);
  } else {
    writeBytes(path, bytes);
  }
  CHECK((voxelBytes(readVolume(path)) == first));
  CHECK((voxelBytes(readVolume(path, {.frame = 1})) == second));
  CHECK((voxelBytes(readVolume(path, {.frame = 2})) == third));
  const VolumeInfo info = inspectVolume(path);
  CHECK(info.frames == 3);
  expectWarning(info, FindingKind::frameZeroUsed,
                "There are 3 time points; frame 0 is used (--frame chooses another).");
  CHECK(inspectVolume(path, {.frame = 1}).warnings.empty());
  CHECK_THROWS_AS(readVolume(path, {.frame = 3}), UsageError);
  CHECK_THROWS_AS(readVolume(path, {.frame = -1}), UsageError);
  CHECK_THROWS_AS(inspectVolume(path, {.frame = 3}), UsageError);
}

TEST_CASE("a 4D NRRD and a 4D MetaImage give the chosen time point") {
  const TemporaryFolder folder;
  const std::string frame0 = "abcdefgh", frame1 = "ijklmnop";
  writeBytes(folder / "4d.nrrd", nrrdHeader("uint8", "2 2 2 2", "") + frame0 + frame1);
  writeBytes(folder / "4d.mha",
             "ObjectType = Image\nNDims = 4\nBinaryData = True\nElementSpacing = 1 1 1 1\nDimSize = 2 2 2 2\n"
             "ElementType = MET_UCHAR\nElementDataFile = LOCAL\n" +
                 frame0 + frame1);
  for (const char* name : {"4d.nrrd", "4d.mha"}) {
    INFO(name);
    CHECK(voxelBytes(readVolume(folder / name)) == frame0);
    CHECK(voxelBytes(readVolume(folder / name, {.frame = 1})) == frame1);
    CHECK(inspectVolume(folder / name).frames == 2);
  }
}

TEST_CASE("a frame other than 0 of a 3D volume and a series of something else than DICOM are usage errors") {
  const TemporaryFolder folder;
  writeVolume(randomVolume(obliqueGrid(), VoxelType::uint8), folder / "v.mha");
  CHECK_NOTHROW(readVolume(folder / "v.mha", {.frame = 0}));
  CHECK_THROWS_AS(readVolume(folder / "v.mha", {.frame = 1}), UsageError);
  CHECK_THROWS_AS(readVolume(folder / "v.mha", {.series = "1.2.3"}), UsageError);
}

TEST_CASE("NIfTI scaling is applied: slope and intercept make integers float32") {
  const TemporaryFolder folder;
  std::string bytes = niftiBytes(folder, VoxelType::int16);
  std::int16_t stored = 0;
  std::memcpy(&stored, bytes.data() + 352, 2);
  patch(bytes, 112, 0.5f);
  patch(bytes, 116, -10.0f);
  writeBytes(folder / "scaled.nii", bytes);
  const Volume volume = readVolume(folder / "scaled.nii");
  REQUIRE(volume.type == VoxelType::float32);
  CHECK(inspectVolume(folder / "scaled.nii").type == VoxelType::float32);
  CHECK(volume.data<float>()[0] == 0.5f * static_cast<float>(stored) - 10.0f);
  // A slope of 0 means none.
  patch(bytes, 112, 0.0f);
  writeBytes(folder / "zero.nii", bytes);
  CHECK(readVolume(folder / "zero.nii").type == VoxelType::int16);
}

TEST_CASE("a sheared sform beside a good qform is a warning, and the qform is used") {
  const TemporaryFolder folder;
  std::string bytes = niftiBytes(folder, VoxelType::uint8);
  float shear = 0;
  std::memcpy(&shear, bytes.data() + 284, 4);
  patch(bytes, 284, shear + 0.5f);
  patch(bytes, 252, std::int16_t{1});
  patch(bytes, 254, std::int16_t{1});
  writeBytes(folder / "sheared.nii", bytes);
  const VolumeInfo info = inspectVolume(folder / "sheared.nii");
  expectSameGrid(info.grid, obliqueGrid(), 2e-5);
  REQUIRE(info.warnings.size() == 1);
  const double apart = info.warnings[0].number("apart_mm");
  CHECK(apart == std::ceil(apart));
  expectWarning(info, FindingKind::formsDisagree,
                "The sform and the qform of the header disagree (by up to " +
                    std::to_string(std::lround(apart)) + " mm); the qform is used.");
}

TEST_CASE("a big-endian NIfTI and a big-endian MetaImage hold the same numbers") {
  const TemporaryFolder folder;
  std::string bytes = niftiBytes(folder, VoxelType::int16);
  const std::string expected = bytes.substr(352);
  const auto reverse = [&](std::size_t at, std::size_t size, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
      std::reverse(bytes.begin() + static_cast<long>(at + i * size),
                   bytes.begin() + static_cast<long>(at + (i + 1) * size));
  };
  reverse(0, 4, 1);    // sizeof_hdr
  reverse(40, 2, 8);   // dim
  reverse(56, 4, 3);   // intent_p
  reverse(68, 2, 4);   // intent_code, datatype, bitpix, slice_start
  reverse(76, 4, 11);  // pixdim, vox_offset, scl_slope, scl_inter
  reverse(120, 2, 1);  // slice_end
  reverse(124, 4, 4);  // cal_max, cal_min, slice_duration, toffset
  reverse(252, 2, 2);  // qform_code, sform_code
  reverse(256, 4, 18);
  reverse(352, 2, expected.size() / 2);
  writeBytes(folder / "big.nii", bytes);
  const Volume volume = readVolume(folder / "big.nii");
  CHECK((voxelBytes(volume) == expected));
  expectSameGrid(volume.grid, obliqueGrid(), 2e-5);

  writeBytes(folder / "big.mha",
             std::string("ObjectType = Image\nNDims = 3\nBinaryData = True\n"
                         "BinaryDataByteOrderMSB = True\nDimSize = 2 2 2\nElementType = MET_SHORT\n"
                         "ElementDataFile = LOCAL\n") +
                 std::string("\0\1\0\2\0\3\0\4\0\5\0\6\0\7\1\0", 16));
  const Volume meta = readVolume(folder / "big.mha");
  CHECK(meta.data<std::int16_t>()[0] == 1);
  CHECK(meta.data<std::int16_t>()[7] == 256);
}

TEST_CASE("colour becomes luminance with a warning") {
  const TemporaryFolder folder;
  std::string pixels;
  for (int i = 0; i < 8; ++i) pixels += std::string("\xff\0\0", 3);  // red
  writeBytes(folder / "rgb.mha",
             "ObjectType = Image\nNDims = 3\nBinaryData = True\nElementNumberOfChannels = 3\nElementSpacing "
             "= 1 1 1\n"
             "DimSize = 2 2 2\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n" +
                 pixels);
  writeBytes(folder / "rgb.nrrd",
             nrrdHeader("uint8", "3 2 2 2",
                        "space: left-posterior-superior\nkinds: RGB-color domain domain domain\n"
                        "space directions: none (1,0,0) (0,1,0) (0,0,1)\nspace origin: (0,0,0)\n") +
                 pixels);
  for (const char* name : {"rgb.mha", "rgb.nrrd"}) {
    INFO(name);
    const Volume volume = readVolume(folder / name);
    REQUIRE(volume.type == VoxelType::uint8);
    CHECK(volume.grid.size == std::array<int, 3>{2, 2, 2});
    CHECK(int{volume.data<std::uint8_t>()[7]} == 54);  // 0.2125 · 255
    expectWarning(inspectVolume(folder / name), FindingKind::colourAsLuminance,
                  "Colour was turned into luminance (0.2125 R + 0.7154 G + 0.0721 B).");
  }
}

TEST_CASE("64-bit integers are widened to float64") {
  const TemporaryFolder folder;
  std::string voxels(64, '\0');
  patch(voxels, 8, std::int64_t{-123456789012});
  writeBytes(folder / "long.nrrd", nrrdHeader("int64", "2 2 2", "") + voxels);
  const Volume volume = readVolume(folder / "long.nrrd");
  REQUIRE(volume.type == VoxelType::float64);
  CHECK(volume.data<double>()[1] == -123456789012.0);
}

TEST_CASE("an NRRD in RAS is turned to LPS, and one without a space is a warning") {
  const TemporaryFolder folder;
  writeBytes(folder / "ras.nrrd",
             nrrdHeader("uint8", "2 2 2",
                        "space: right-anterior-superior\nspace directions: (2,0,0) (0,3,0) (0,0,4)\n"
                        "space origin: (10,20,30)\n") +
                 "abcdefgh");
  const Grid grid = readVolume(folder / "ras.nrrd").grid;
  CHECK((grid.toWorld(Vec3(1, 1, 1)) - Vec3(-12, -23, 34)).norm() < 1e-12);
  CHECK(inspectVolume(folder / "ras.nrrd").warnings.empty());
  writeBytes(folder / "none.nrrd", nrrdHeader("uint8", "2 2 2", "") + "abcdefgh");
  const VolumeInfo none = inspectVolume(folder / "none.nrrd");
  REQUIRE(none.warnings.size() == 2);
  expectWarning(none.warnings[0], FindingKind::axesTakenAsLps,
                "The header does not say how the volume lies in space; its axes are taken as LPS.");
  expectWarning(none.warnings[1], FindingKind::uncalibrated,
                "The volume is uncalibrated: its file does not give the spacing, 1 mm is assumed where it is "
                "missing, and lengths and volumes mean nothing until --spacing gives it.");
  CHECK_FALSE(none.calibrated);
}

TEST_CASE("a TIFF of several pages is a volume, with a warning about its geometry") {
  const TemporaryFolder folder;
  writeBytes(folder / "v.tif", tiffBytes(3, 2, {"abcdef", "ghijkl", "mnopqr", "stuvwx"}));
  const Volume volume = readVolume(folder / "v.tif");
  CHECK(volume.grid.size == std::array<int, 3>{3, 2, 4});
  CHECK(voxelBytes(volume) == "abcdefghijklmnopqrstuvwx");
  const VolumeInfo info = inspectVolume(folder / "v.tif");
  REQUIRE(info.warnings.size() == 2);
  expectWarning(info.warnings[0], FindingKind::tiffWithoutPlace,
                "TIFF does not say how far apart the slices are nor how they lie; 1 mm and LPS axes are "
                "assumed.");
  CHECK_FALSE(info.calibrated);
  writeBytes(folder / "flat.tif", tiffBytes(3, 2, {"abcdef"}));
  expectInputError(folder / "flat.tif", "2D image");
  writeBytes(folder / "short.tif", readBytes(folder / "v.tif").substr(0, 150));
  expectInputError(folder / "short.tif", "", true);
}

TEST_CASE("voxels of a TIFF that are not a number are read below all others, as of other formats") {
  const TemporaryFolder folder;
  std::vector<std::string> pages;
  for (int k = 0; k < 4; ++k) {
    std::string page(3 * 2 * sizeof(float), '\0');
    for (std::size_t i = 0; i < 6; ++i)
      patch(page, 4 * i, static_cast<float>(10 * k) + static_cast<float>(i));
    pages.push_back(page);
  }
  patch(pages[2], 4 * 5, std::numeric_limits<float>::quiet_NaN());
  writeBytes(folder / "v.tif", tiffBytes(3, 2, pages, true));
  const LoadedVolume loaded = loadVolume(folder / "v.tif");
  REQUIRE(loaded.volume.type == VoxelType::float32);
  expectAmong(loaded.info, FindingKind::voxelsNotNumbers,
              "1 of 24 voxels are not a number: they count as outside of the field of view.");
  const auto* values = loaded.volume.data<float>();
  for (int i = 0; i < 24; ++i)
    CHECK((i == 17 ? values[i] < 0 : values[i] == static_cast<float>(i / 6 * 10 + i % 6)));
}

TEST_CASE("a folder of TIFF files is a volume of slices, in the order of their numbers") {
  const TemporaryFolder folder;
  const std::string slices = folder / "slices";
  std::filesystem::create_directories(slices);
  const char* const names[] = {"cut1.tif", "cut2.TIF", "cut9.tiff", "cut10.tif"};
  const std::vector<std::string> pages{"abcdef", "ghijkl", "mnopqr", "stuvwx"};
  for (std::size_t i = 0; i < 4; ++i) writeBytes(slices + "/" + names[i], tiffBytes(3, 2, {pages[i]}));
  writeBytes(slices + "/notes.txt", "of the scanner");
  const Volume volume = readVolume(slices);
  CHECK(volume.grid.size == std::array<int, 3>{3, 2, 4});
  CHECK(voxelBytes(volume) == "abcdefghijklmnopqrstuvwx");
  // As that of a file with these pages.
  writeBytes(folder / "v.tif", tiffBytes(3, 2, pages));
  const VolumeInfo info = inspectVolume(slices), asFile = inspectVolume(folder / "v.tif");
  CHECK(info.frames == 1);
  CHECK_FALSE(info.calibrated);
  CHECK(info.grid.spacing == asFile.grid.spacing);
  REQUIRE(info.warnings.size() == asFile.warnings.size());
  CHECK(info.warnings[0].kind == FindingKind::tiffWithoutPlace);
  CHECK(readVolume(slices, {.spacing = Vec3(0.5, 0.5, 2)}).grid.spacing == Vec3(0.5, 0.5, 2));
  CHECK_THROWS_AS(readVolume(slices, {.series = "1.2"}), UsageError);
}

TEST_CASE("TIFF files of a folder that are no slices of one volume are refused, each by its name") {
  const TemporaryFolder folder;
  const std::string slices = folder / "slices";
  std::filesystem::create_directories(slices);
  writeBytes(slices + "/a.tif", tiffBytes(3, 2, {"abcdef"}));
  const auto refused = [&](const std::string& other, const std::string& cause) {
    writeBytes(slices + "/b.tif", other);
    expectInputError(slices, "b.tif: " + cause);
  };
  refused(tiffBytes(2, 3, {"abcdef"}), "its size, resolution or type of voxels");
  refused(tiffBytes(3, 2, {"abcdef", "ghijkl"}), "it has 2 pages");
  refused(tiffBytes(3, 2, {"abcdef"}).substr(0, 60), "");
  refused("no TIFF at all", "");
  // Alone it is what it would be by itself.
  std::filesystem::remove(slices + "/b.tif");
  expectInputError(slices, "2D image");
  std::filesystem::remove(slices + "/a.tif");
  writeBytes(slices + "/v.tif", tiffBytes(3, 2, {"abcdef", "ghijkl"}));
  CHECK(voxelBytes(readVolume(slices)) == "abcdefghijkl");
}

TEST_CASE("reading an uncompressed volume takes its own size of memory and little more") {
  const TemporaryFolder folder;
  Grid grid;
  grid.size = {256, 256, 256};
  const double size = 256.0 * 256 * 256 * 2;
  void* buffer = nullptr;
  const Volume zeros = makeVolume(grid, VoxelType::int16, &buffer);
  const std::string sizes = "256 256 256";
  writeVolume(zeros, folder / "v.nii");
  writeBytes(folder / "v.nrrd", nrrdHeader("int16", sizes, "") + voxelBytes(zeros));
  writeBytes(folder / "v.mha", "ObjectType = Image\nNDims = 3\nBinaryData = True\nDimSize = " + sizes +
                                   "\nElementType = MET_SHORT\nElementDataFile = LOCAL\n" +
                                   voxelBytes(zeros));
  writeVolume(zeros, folder / "v.nii.gz");
  for (const char* name : {"v.nii", "v.nrrd", "v.mha", "v.nii.gz"}) {
    INFO(name);
    const double peak = peakOfReading(folder / name);
    CHECK(peak > 0.5 * size);  // the measurement works
    CHECK(peak < 1.2 * size);
  }
}

TEST_CASE("SHA-256 of a file and of a folder agree with the standard's examples") {
  const TemporaryFolder folder;
  writeBytes(folder / "a", "ab");
  writeBytes(folder / "b", "c");
  // FIPS 180-2, appendix B.1: "abc".
  CHECK(sha256OfPath(folder.path()) == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  writeBytes(folder / "a", "");
  CHECK(sha256OfPath(folder / "a") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  CHECK_THROWS_AS(sha256OfPath(folder / "missing"), InputError);
}

TEST_CASE("the hash of a detached header is of the voxels, too, and that of a header alone is still known") {
  const TemporaryFolder folder;
  writeBytes(folder / "v.raw", "12345678");
  const auto name = GENERATE(as<std::string>{}, "v.nhdr", "v.mhd");
  const std::string text = name == "v.nhdr"
                               ? nrrdHeader("uint8", "2 2 2", "data file: v.raw\n")
                               : "ObjectType = Image\nNDims = 3\nBinaryData = True\nDimSize = 2 2 2\n"
                                 "ElementType = MET_UCHAR\nElementDataFile = v.raw\n";
  writeBytes(folder / name, text);
  REQUIRE(readVolume(folder / name).grid.size == std::array<int, 3>{2, 2, 2});
  const PathHash before = hashOfPath(folder / name);
  CHECK(before.whole == sha256OfText(text + "12345678"));
  CHECK(before.header == sha256OfText(text));
  writeBytes(folder / "v.raw", "12345679");
  const PathHash after = hashOfPath(folder / name);
  CHECK_FALSE(after.is(before.whole));
  CHECK(after.is(before.header));
  writeBytes(folder / "whole.nrrd", nrrdHeader("uint8", "2 2 2", "") + "12345678");
  CHECK(hashOfPath(folder / "whole.nrrd").header.empty());
  const std::atomic<bool> cancelled{true};
  const CancelScope scope(cancelled);
  CHECK_THROWS_AS(hashOfPath(folder / "whole.nrrd"), Cancelled);
}
