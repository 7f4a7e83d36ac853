// NIfTI-2, NRRD with a time axis at any place and with numbered data files, and where geometry comes from.

#include <limits>

#include "core/io/formats/volume_keys.h"
#include "core/volume/field_of_view.h"
#include "tests/io/io_test_support.h"

using namespace handlebody;
using namespace handlebody::test;

namespace {

//! The NIfTI-1 header of a file that we wrote, as NIfTI-2.
std::string asNifti2(const std::string& first) {
  std::string bytes(544, '\0');
  const auto float32 = [&](std::size_t at) {
    float value;
    std::memcpy(&value, first.data() + at, sizeof value);
    return static_cast<double>(value);
  };
  const auto int16 = [&](std::size_t at) {
    std::int16_t value;
    std::memcpy(&value, first.data() + at, sizeof value);
    return value;
  };
  patch(bytes, 0, std::int32_t{540});
  bytes.replace(4, 8, std::string("n+2\0\r\n\x1a\n", 8));
  patch(bytes, 12, int16(70));
  for (std::size_t i = 0; i < 8; ++i) patch(bytes, 16 + 8 * i, std::int64_t{int16(40 + 2 * i)});
  for (std::size_t i = 0; i < 8; ++i) patch(bytes, 104 + 8 * i, float32(76 + 4 * i));
  patch(bytes, 168, std::int64_t{544});
  patch(bytes, 176, float32(112));
  patch(bytes, 184, float32(116));
  patch(bytes, 344, std::int32_t{int16(252)});
  patch(bytes, 348, std::int32_t{int16(254)});
  for (std::size_t i = 0; i < 6; ++i) patch(bytes, 352 + 8 * i, float32(256 + 4 * i));
  for (std::size_t i = 0; i < 12; ++i) patch(bytes, 400 + 8 * i, float32(280 + 4 * i));
  patch(bytes, 500, std::int32_t{first[123]});
  return bytes + first.substr(352);
}

std::string nrrdOf(const std::string& sizes, const std::string& fields) {
  return "NRRD0005\ntype: uint8\ndimension: " +
         std::to_string(1 + std::count(sizes.begin(), sizes.end(), ' ')) + "\nsizes: " + sizes +
         "\nencoding: raw\n" + fields + "\n";
}

}  // namespace

TEST_CASE("a NIfTI-2 file is the same volume as its NIfTI-1 twin") {
  const TemporaryFolder folder;
  for (const VoxelType type : {VoxelType::uint8, VoxelType::int16, VoxelType::float64}) {
    const Volume volume = randomVolume(obliqueGrid(), type);
    writeVolume(volume, folder / "one.nii");
    writeBytes(folder / "two.nii", asNifti2(readBytes(folder / "one.nii")));
    const Volume one = readVolume(folder / "one.nii"), two = readVolume(folder / "two.nii");
    CHECK(two.type == type);
    CHECK((voxelBytes(two) == voxelBytes(volume)));
    CHECK(two.grid.size == one.grid.size);
    CHECK((two.grid.toWorld(Vec3(6, 4, 3)) - one.grid.toWorld(Vec3(6, 4, 3))).norm() < 1e-12);
    CHECK(inspectVolume(folder / "two.nii").format == "NIfTI-2");
  }
}

TEST_CASE("a NIfTI with a sform alone lies where the sform says") {
  const TemporaryFolder folder;
  writeVolume(randomVolume(obliqueGrid(), VoxelType::uint8), folder / "v.nii");
  const Grid expected = readVolume(folder / "v.nii").grid;
  std::string bytes = readBytes(folder / "v.nii");
  patch(bytes, 252, std::int16_t{0});
  patch(bytes, 254, std::int16_t{1});
  for (std::size_t r = 0; r < 3; ++r) {
    const double sign = r < 2 ? -1 : 1;
    for (std::size_t a = 0; a < 4; ++a) {
      const auto row = static_cast<Eigen::Index>(r), axis = static_cast<Eigen::Index>(a);
      const double value =
          a == 3 ? expected.origin[row] : expected.direction(row, axis) * expected.spacing[axis];
      patch(bytes, 280 + 16 * r + 4 * a, static_cast<float>(sign * value));
    }
  }
  writeBytes(folder / "s.nii", bytes);
  const VolumeInfo info = inspectVolume(folder / "s.nii");
  for (const Vec3& index : {Vec3(0, 0, 0), Vec3(6, 0, 3), Vec3(1, 4, 2)})
    CHECK((info.grid.toWorld(index) - expected.toWorld(index)).norm() < 1e-4);
  CHECK_THAT(info.sources.direction, Contains("sform"));
}

TEST_CASE("the time axis of an NRRD may stand first, last or between") {
  const TemporaryFolder folder;
  // Value of voxel (x, y, z) at time t: t · 100 + x + 2 y + 6 z.
  const std::array<int, 3> size{2, 3, 4};
  for (const std::size_t place : {0u, 1u, 2u, 3u}) {
    std::string sizes, kinds, directions;
    std::vector<int> order;
    for (int a = 0, axis = 0; a < 4; ++a) {
      const bool time = a == static_cast<int>(place);
      order.push_back(time ? 3 : axis);
      sizes += (a ? " " : "") + std::to_string(time ? 2 : size[axis]);
      kinds += time ? " list" : " domain";
      directions += time ? " none" : axis == 0 ? " (1,0,0)" : axis == 1 ? " (0,1,0)" : " (0,0,1)";
      if (!time) ++axis;
    }
    std::string voxels(48, '\0');
    for (int i = 0; i < 48; ++i) {
      int rest = i, at[4] = {0, 0, 0, 0};
      for (int a : order) {
        const int n = a == 3 ? 2 : size[a];
        at[a] = rest % n;
        rest /= n;
      }
      voxels[i] = static_cast<char>(100 * at[3] + at[0] + 2 * at[1] + 6 * at[2]);
    }
    const std::string path = folder / "4d.nrrd";
    writeBytes(path, nrrdOf(sizes, "space: LPS\nkinds:" + kinds + "\nspace directions:" + directions + "\n") +
                         voxels);
    INFO("time axis " << place);
    CHECK(inspectVolume(path).frames == 2);
    for (int t = 0; t < 2; ++t) {
      const Volume volume = readVolume(path, {.frame = t});
      CHECK(volume.grid.size == size);
      for (int i = 0; i < 24; ++i) CHECK(int{volume.data<std::uint8_t>()[i]} == 100 * t + i);
    }
  }
}

TEST_CASE("an NRRD header may name numbered data files, or a list of them") {
  const TemporaryFolder folder;
  for (int k = 1; k <= 3; ++k)
    writeBytes(folder / ("slice.0" + std::to_string(k)), std::string(6, static_cast<char>(k)));
  const std::string geometry = "spacings: 1 2 3\n";
  writeBytes(folder / "numbered.nhdr", nrrdOf("3 2 3", geometry + "data file: slice.%02d 1 3 1\n"));
  writeBytes(folder / "list.nhdr",
             nrrdOf("3 2 3", geometry + "data file: LIST\nslice.03\nslice.02\nslice.01\n"));
  const Volume up = readVolume(folder / "numbered.nhdr"), down = readVolume(folder / "list.nhdr");
  for (int k = 0; k < 3; ++k) {
    CHECK(int{up.data<std::uint8_t>()[6 * k]} == k + 1);
    CHECK(int{down.data<std::uint8_t>()[6 * k]} == 3 - k);
  }
  fs::remove(folder / "slice.02");
  expectInputError(folder / "numbered.nhdr", "slice.02 is missing");
  writeBytes(folder / "hostile.nhdr", nrrdOf("3 2 3", geometry + "data file: %s%n 1 3 1\n"));
  expectInputError(folder / "hostile.nhdr", "not supported");
}

TEST_CASE(
    "sizes whose product exceeds 64 bits, the memory or the file are refused before anything is allocated") {
  const TemporaryFolder folder;
  const std::string spaced = "spacings: 1 1 1\n";
  for (const char* sizes : {"2147483647 2147483647 2147483647", "100000 100000 100000", "4000 4000 4000"}) {
    INFO(sizes);
    writeBytes(folder / "v.nrrd", nrrdOf(sizes, spaced) + "abc");
    expectInputError(folder / "v.nrrd", "");
    writeBytes(folder / "v.mha", std::string("ObjectType = Image\nNDims = 3\nBinaryData = True\nDimSize = ") +
                                     sizes + "\nElementType = MET_UCHAR\nElementDataFile = LOCAL\nabc");
    expectInputError(folder / "v.mha", "");
  }
  writeBytes(folder / "t.nrrd", nrrdOf("2 2 2 2147483647", "spacings: 1 1 1 nan\n") + "abcdefgh");
  expectInputError(folder / "t.nrrd", "");
}

TEST_CASE("every number of the geometry has a source") {
  const TemporaryFolder folder;
  for (const char* name : {"v.nii", "v.nrrd", "v.mha"}) {
    INFO(name);
    writeVolume(randomVolume(obliqueGrid(), VoxelType::uint8), folder / name);
    const VolumeInfo info = inspectVolume(folder / name);
    CHECK(info.calibrated);
    for (const std::string* source :
         {&info.sources.size, &info.sources.spacing[0], &info.sources.spacing[1], &info.sources.spacing[2],
          &info.sources.origin, &info.sources.direction}) {
      CHECK_FALSE(source->empty());
      CHECK_THAT(*source, !Contains("assumed"));
    }
  }
}

TEST_CASE("units that are no millimetres are said") {
  const TemporaryFolder folder;
  writeBytes(folder / "v.mha",
             "ObjectType = Image\nNDims = 3\nBinaryData = True\nDimSize = 2 2 2\nElementSpacing = 1 1 1\n"
             "DistanceUnits = um\nElementType = MET_UCHAR\nElementDataFile = LOCAL\nabcdefgh");
  expectWarning(inspectVolume(folder / "v.mha"), FindingKind::unitAsMillimetres,
                "The distance unit um is taken as millimetres.");
  writeBytes(
      folder / "v.nrrd",
      "NRRD0004\ntype: uint8\ndimension: 3\nspace: LPS\nsizes: 2 2 2\nspace directions: (1,0,0) "
      "(0,1,0) (0,0,1)\nspace origin: (0,0,0)\nspace units: \"um\" \"um\" \"um\"\nencoding: raw\n\nabcdefgh");
  expectWarning(inspectVolume(folder / "v.nrrd"), FindingKind::unitsAsMillimetres,
                "The space units \"um\" \"um\" \"um\" are taken as millimetres.");
}

TEST_CASE("a spacing given by the user replaces the file's, and is said") {
  const TemporaryFolder folder;
  writeVolume(randomVolume(obliqueGrid(), VoxelType::uint8), folder / "v.nrrd");
  VolumeSelection given;
  given.spacing = Vec3(1, 2, 3);
  const VolumeInfo info = inspectVolume(folder / "v.nrrd", given);
  CHECK(info.grid.spacing == Vec3(1, 2, 3));
  expectWarning(info, FindingKind::spacingOverridden,
                "The spacing was given by the user; the file says 0.5 mm, 1.25 mm, 2.75 mm.");
  given.spacing = Vec3(1, 0, 3);
  CHECK_THROWS_AS(readVolume(folder / "v.nrrd", given), UsageError);
}

TEST_CASE("a GIPL file is read with its voxels, sizes, spacing and origin, plain or packed") {
  const TemporaryFolder folder;
  std::vector<std::int16_t> voxels;
  for (int i = 0; i < 3 * 4 * 5; ++i) voxels.push_back(static_cast<std::int16_t>(1000 - 37 * i));
  const std::string bytes = giplBytes({3, 4, 5}, Vec3(0.5, 0.75, 2), Vec3(-10, 20.25, 3), voxels);
  writeBytes(folder / "v.gipl", bytes);
  REQUIRE(std::system(("gzip -k '" + (folder / "v.gipl") + "'").c_str()) == 0);
  for (const char* name : {"v.gipl", "v.gipl.gz"}) {
    const Volume volume = readVolume(folder / name);
    CHECK(inspectVolume(folder / name).format == "GIPL");
    CHECK(volume.grid.size == std::array<int, 3>{3, 4, 5});
    CHECK(volume.grid.spacing == Vec3(0.5, 0.75, 2));
    CHECK(volume.grid.origin == Vec3(-10, 20.25, 3));
    REQUIRE(volume.type == VoxelType::int16);
    CHECK(std::equal(voxels.begin(), voxels.end(), volume.data<std::int16_t>()));
  }
  writeBytes(folder / "short.gipl", bytes.substr(0, bytes.size() - 1));
  expectInputError(folder / "short.gipl", "truncated");
  std::string text = bytes;
  text[9] = 3;
  writeBytes(folder / "type.gipl", text);
  expectInputError(folder / "type.gipl", "voxel type (3) is not supported");
}

TEST_CASE("voxels that are not a number are read below all others, with a warning") {
  const TemporaryFolder folder;
  std::vector<float> voxels(8 * 8 * 8, 3.0F);
  for (std::size_t i = 0; i < voxels.size(); ++i) voxels[i] += 0.01F * static_cast<float>(i);
  for (std::size_t i = 0; i < 100; ++i) voxels[5 * i] = std::numeric_limits<float>::quiet_NaN();
  voxels[1] = -7;
  std::string bytes(voxels.size() * sizeof(float), '\0');
  std::memcpy(bytes.data(), voxels.data(), bytes.size());
  writeBytes(folder / "v.mha",
             "ObjectType = Image\nNDims = 3\nBinaryData = True\nDimSize = 8 8 8\nElementType = "
             "MET_FLOAT\nElementDataFile = LOCAL\n" +
                 bytes);
  const LoadedVolume loaded = loadVolume(folder / "v.mha");
  const auto* values = loaded.volume.data<float>();
  for (std::size_t i = 0; i < voxels.size(); ++i)
    REQUIRE((std::isnan(voxels[i]) ? values[i] < -7 && values[i] > -7.01F : values[i] == voxels[i]));
  expectAmong(loaded.info, FindingKind::voxelsNotNumbers,
              "100 of 512 voxels are not a number: they count as outside of the field of view.");
  const auto view = FieldOfView::find(loaded.volume);
  REQUIRE(view != nullptr);
  for (std::size_t i = 0; i < voxels.size(); ++i) REQUIRE(view->isPadding(i) == std::isnan(voxels[i]));
}

TEMPLATE_TEST_CASE("voxels as large as numbers go have no value, as those that are not a number", "", float,
                   double) {
  const TemporaryFolder folder;
  constexpr bool kSingle = sizeof(TestType) == 4;
  constexpr TestType kMax = std::numeric_limits<TestType>::max();
  std::vector<TestType> voxels(8 * 8 * 8, 5);
  voxels[1] = -2;
  voxels[2] = static_cast<TestType>(9e36);  // may be meant
  voxels[10] = voxels[11] = -kMax;
  voxels[20] = kMax;
  voxels[30] = static_cast<TestType>(-2e38);
  voxels[40] = std::numeric_limits<TestType>::quiet_NaN();
  std::string bytes(voxels.size() * sizeof(TestType), '\0');
  std::memcpy(bytes.data(), voxels.data(), bytes.size());
  writeBytes(folder / "v.mha",
             "ObjectType = Image\nNDims = 3\nBinaryData = True\nDimSize = 8 8 8\nElementType = " +
                 std::string(kSingle ? "MET_FLOAT" : "MET_DOUBLE") + "\nElementDataFile = LOCAL\n" + bytes);
  const LoadedVolume loaded = loadVolume(folder / "v.mha");
  expectAmong(loaded.info, FindingKind::voxelsNotNumbers,
              "5 of 512 voxels are not a number: they count as outside of the field of view.");
  const auto view = FieldOfView::find(loaded.volume);
  REQUIRE(view != nullptr);
  const auto* values = loaded.volume.data<TestType>();
  for (std::size_t i = 0; i < voxels.size(); ++i) {
    INFO(i);
    const bool isOutside = i == 10 || i == 11 || i == 20 || i == 30 || i == 40;
    REQUIRE((isOutside ? values[i] < -2 && values[i] > -2.01 : values[i] == voxels[i]));
    // All of the border but the few that were changed is 5, which makes it padding.
    if (isOutside) REQUIRE(view->isPadding(i));
  }
}

// What ITK's readers lose (docs/formats.md).

TEST_CASE("a packed NIfTI gives its own voxels where another one of its name lies beside it unpacked") {
  const TemporaryFolder folder;
  const Volume packed = randomVolume(obliqueGrid(), VoxelType::int16, 1),
               plain = randomVolume(obliqueGrid(), VoxelType::int16, 2);
  writeVolume(packed, folder / "v.nii.gz");
  writeVolume(plain, folder / "v.nii");
  CHECK((voxelBytes(readVolume(folder / "v.nii.gz")) == voxelBytes(packed)));
  CHECK((voxelBytes(readVolume(folder / "v.nii")) == voxelBytes(plain)));
}

TEST_CASE("voxels of a NIfTI that are not a number are no zeros, and infinite ones are refused") {
  const TemporaryFolder folder;
  writeVolume(randomVolume(obliqueGrid(), VoxelType::float32), folder / "v.nii");
  std::string bytes = readBytes(folder / "v.nii");
  patch(bytes, bytes.size() - 4, std::numeric_limits<float>::quiet_NaN());
  writeBytes(folder / "nan.nii", bytes);
  const LoadedVolume loaded = loadVolume(folder / "nan.nii");
  expectAmong(loaded.info, FindingKind::voxelsNotNumbers,
              "1 of 140 voxels are not a number: they count as outside of the field of view.");
  patch(bytes, bytes.size() - 4, std::numeric_limits<float>::infinity());
  writeBytes(folder / "inf.nii", bytes);
  expectInputError(folder / "inf.nii", "is infinite", true);
}

TEST_CASE("a voxel size of a NIfTI that is 0 is assumed, and one that is not a number is refused") {
  const TemporaryFolder folder;
  writeVolume(randomVolume(obliqueGrid(), VoxelType::uint8), folder / "v.nii");
  std::string bytes = readBytes(folder / "v.nii");
  patch(bytes, 252, static_cast<std::int16_t>(GENERATE(1, 0)));  // by its qform, or by the voxel sizes alone
  patch(bytes, 254, std::int16_t{0});
  writeBytes(folder / "sound.nii", bytes);
  CHECK(inspectVolume(folder / "sound.nii").calibrated);
  patch(bytes, 76 + 4 * 3, 0.0F);
  for (const bool inMetres : {false, true}) {
    bytes[123] = inMetres ? 1 : 2;
    writeBytes(folder / "zero.nii", bytes);
    const VolumeInfo info = inspectVolume(folder / "zero.nii");
    CHECK_FALSE(info.calibrated);
    CHECK((info.grid.spacing - Vec3(inMetres ? 500 : 0.5, inMetres ? 1250 : 1.25, 1)).norm() < 1e-3);
    CHECK(info.sources.spacing[1] == "pixdim");
    CHECK(info.sources.spacing[2] == "assumed");
    expectAmong(info, FindingKind::uncalibrated, sentence(FindingKind::uncalibrated));
  }
  patch(bytes, 76 + 4 * 3, std::numeric_limits<float>::quiet_NaN());
  writeBytes(folder / "nan.nii", bytes);
  expectInputError(folder / "nan.nii", sentence(FindingKind::badSpacing));
}

TEST_CASE("an NRRD in left-anterior-superior axes lies where it says") {
  const TemporaryFolder folder;
  writeBytes(folder / "v.nrrd", nrrdOf("2 2 2",
                                       "space: left-anterior-superior\nspace directions: (1,0,0) (0,2,0) "
                                       "(0,0,3)\nspace origin: (5,6,7)\n") +
                                    "abcdefgh");
  const Grid grid = inspectVolume(folder / "v.nrrd").grid;
  CHECK(grid.toWorld(Vec3(0, 0, 0)) == Vec3(5, -6, 7));
  CHECK(grid.toWorld(Vec3(1, 1, 1)) == Vec3(6, -8, 10));
}

TEST_CASE("fields of an NRRD may be written without blanks, as teem reads them") {
  const TemporaryFolder folder;
  const std::string path = folder / "v.nrrd";
  for (const std::string fields :
       {"space: LPS\nspacedirections: (2,0,0) (0,3,0) (0,0,4)\nspaceorigin: (5,6,7)\n",
        "space:LPS\nspace directions:(2,0,0) (0,3,0) (0,0,4)\nspace origin:(5,6,7)\n",
        "space: LPS\nSpace Directions: (2,0,0)(0,3,0)(0,0,4)\nSPACE ORIGIN: (5, 6, 7)\n"}) {
    INFO(fields);
    writeBytes(path,
               nrrdOf("2 2 2", fields + "spaceunits: \"um\" \"um\" \"um\"\na:key:=space origin:(9,9,9)\n") +
                   "abcdefgh");
    const VolumeInfo info = inspectVolume(path);
    CHECK(info.grid.spacing == Vec3(2, 3, 4));
    CHECK(info.grid.origin == Vec3(5, 6, 7));
    CHECK(info.sources.origin == "space origin");
    expectWarning(info, FindingKind::unitsAsMillimetres,
                  "The space units \"um\" \"um\" \"um\" are taken as millimetres.");
  }
}

TEST_CASE("an NRRD without an origin says so, and one whose origin is no place is refused") {
  const TemporaryFolder folder;
  const std::string path = folder / "v.nrrd",
                    space = "space: LPS\nspace directions: (1,0,0) (0,1,0) (0,0,1)\n";
  for (const std::string line : {"", "space origin: none\n"}) {
    writeBytes(path, nrrdOf("2 2 2", space + line) + "abcdefgh");
    expectWarning(inspectVolume(path), FindingKind::originAssumed,
                  "The header does not say where the first voxel lies; it is taken to lie at 0, 0, 0.");
  }
  for (const char* origin : {"(1,2)", "(1,2,3,4,5)", "(nan,nan,nan)", "(1,2,inf)", "(1,2,3) (4,5,6)",
                             "none (1,2,3)", "1 2 3", ""}) {
    INFO(origin);
    writeBytes(path, nrrdOf("2 2 2", space + "space origin: " + origin + "\n") + "abcdefgh");
    expectInputError(path, "space");
  }
}

TEST_CASE("a volume that comes back in another place than it was written is told from one that is rounded") {
  const Grid meant = obliqueGrid();
  for (const char* name : {"v.nii", "V.NII.GZ", "v.nrrd", "v.mha"}) {
    INFO(name);
    Grid back = meant;
    CHECK(isGridKept(back, meant, name));
    back.origin = Vec3(-17, 33, 121);  // as after a comma
    CHECK_FALSE(isGridKept(back, meant, name));
    back = meant;
    back.spacing.x() *= 1.2;
    CHECK_FALSE(isGridKept(back, meant, name));
    back = meant;
    back.origin.x() = std::numeric_limits<double>::quiet_NaN();
    CHECK_FALSE(isGridKept(back, meant, name));
    back = meant;
    back.origin = meant.origin.cast<float>().cast<double>();
    back.spacing = meant.spacing.cast<float>().cast<double>();
    CHECK(isGridKept(back, meant, name));
  }
}

TEST_CASE(
    "a volume that lies nearly along the axes is written as NIfTI, whose quaternion is rounded most there") {
  const TemporaryFolder folder;
  Grid grid = obliqueGrid();
  for (const double angle : {0.0, 1e-5, 1e-4, 3e-4, 1e-3, 1e-2}) {
    INFO(angle);
    grid.direction = Eigen::AngleAxisd(angle, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    CHECK_NOTHROW(writeVolume(randomVolume(grid, VoxelType::uint8), folder / "v.nii"));
  }
}

TEST_CASE("a packed MetaImage is read whole where its header says nothing, or wrongly, how long it is") {
  const TemporaryFolder folder;
  const Volume volume = randomVolume(obliqueGrid(), VoxelType::int16);
  writeVolume(volume, folder / "v.mha");
  const std::string bytes = readBytes(folder / "v.mha");
  const auto at = bytes.find("CompressedDataSize"), end = bytes.find('\n', at) + 1;
  REQUIRE(at != std::string::npos);
  for (const char* line : {"", "CompressedDataSize = 100\n", "CompressedDataSize = 99999999999\n"}) {
    INFO(line);
    writeBytes(folder / "v.mha", bytes.substr(0, at) + line + bytes.substr(end));
    CHECK((voxelBytes(readVolume(folder / "v.mha")) == voxelBytes(volume)));
  }
}
