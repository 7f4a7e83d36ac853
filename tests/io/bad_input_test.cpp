#include <zlib.h>

#include <iostream>
#include <limits>
#include <sstream>

#include "tests/io/io_test_support.h"

using namespace handlebody;
using namespace handlebody::test;

namespace {

std::string metaHeader(const std::string& changes = "", const std::string& size = "2 2 2") {
  return "ObjectType = Image\nNDims = 3\nBinaryData = True\nDimSize = " + size +
         "\nElementType = MET_UCHAR\n" + changes + "ElementDataFile = LOCAL\n";
}

std::string nrrd(const std::string& directions) {
  return "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 2 2 2\nspace: left-posterior-superior\nspace "
         "directions: " +
         directions + "\nspace origin: (0,0,0)\nencoding: raw\n\nabcdefgh";
}

}  // namespace

TEST_CASE("missing, empty and foreign files are refused with one sentence") {
  const TemporaryFolder folder;
  expectInputError(folder / "missing.nii.gz", "there is no such file");
  writeBytes(folder / "empty.nrrd", "");
  expectInputError(folder / "empty.nrrd", "the file is empty");
  writeBytes(folder / "text.nii.gz", "This is a letter, not a volume.\n");
  expectInputError(folder / "text.nii.gz", "not a volume in a known format");
  writeBytes(folder / "pointer.mhd", "version https://git-lfs.github.com/spec/v1\noid sha256:00\nsize 12\n");
  expectInputError(folder / "pointer.mhd", "Git LFS pointer");
  fs::create_directory(folder / "images");
  expectInputError(folder / "images", "holds no DICOM images");
  writeBytes(folder / "images/readme.txt", "nothing here");
  expectInputError(folder / "images", "holds no DICOM images");
  expectInputError("/dev/null", "neither a file nor a folder");
}

TEST_CASE("every truncation of a volume file is refused") {
  const TemporaryFolder folder;
  const std::string ending = GENERATE(".nii", ".nii.gz", ".nrrd", ".mha");
  const Volume volume = randomVolume(obliqueGrid(), VoxelType::int16);
  writeVolume(volume, folder / ("whole" + ending));
  const std::string bytes = readBytes(folder / ("whole" + ending));
  const std::string path = folder / ("cut" + ending);
  for (std::size_t n = 1; n < bytes.size(); ++n) {
    writeBytes(path, bytes.substr(0, n));
    INFO(ending << " cut to " << n << " of " << bytes.size() << " bytes");
    bool refused = false;
    try {
      // The very last bytes of a compressed NRRD are its checksum: the voxels may be whole without it.
      refused =
          voxelBytes(readVolume(path)) == voxelBytes(volume) && ending == ".nrrd" && n + 8 >= bytes.size();
    } catch (const InputError& e) {
      refused = std::string(e.what()).rfind(path, 0) == 0;
    }
    if (!refused) CHECK(refused);
  }
}

TEST_CASE("a flipped bit in compressed NIfTI and MetaImage data is found by the checksum") {
  const TemporaryFolder folder;
  for (const char* name : {"v.nii.gz", "v.mha"}) {
    writeVolume(randomVolume(obliqueGrid(), VoxelType::uint8), folder / name);
    std::string bytes = readBytes(folder / name);
    bytes[bytes.size() - 40] = static_cast<char>(bytes[bytes.size() - 40] ^ 4);
    writeBytes(folder / name, bytes);
    expectInputError(folder / name, "", true);
  }
}

TEST_CASE("data that are longer than the header says, as damage makes them, are held to their checksum") {
  const TemporaryFolder folder;
  const Volume volume = randomVolume(obliqueGrid(), VoxelType::uint8);
  writeVolume(volume, folder / "v.nii");
  const std::string path = folder / "long.nii.gz";
  const std::string longer = readBytes(folder / "v.nii") + std::string(300'000, '\7');
  const gzFile file = gzopen(path.c_str(), "wb");
  REQUIRE(gzwrite(file, longer.data(), static_cast<unsigned>(longer.size())) ==
          static_cast<int>(longer.size()));
  REQUIRE(gzclose(file) == Z_OK);
  CHECK(voxelBytes(readVolume(path)) == voxelBytes(volume));
  std::string bytes = readBytes(path);
  bytes[bytes.size() - 8] = static_cast<char>(bytes[bytes.size() - 8] ^ 1);
  writeBytes(path, bytes);
  expectInputError(path, "damaged", true);
}

TEST_CASE("uncompressed NRRD and MetaImage files that are too short are refused before reading") {
  const TemporaryFolder folder;
  writeBytes(folder / "short.mha", metaHeader() + "abcdefg");
  expectInputError(folder / "short.mha", "truncated");
  const std::string whole = nrrd("(1,0,0) (0,1,0) (0,0,1)");
  writeBytes(folder / "whole.nrrd", whole);
  CHECK(voxelBytes(readVolume(folder / "whole.nrrd")) == "abcdefgh");
  writeBytes(folder / "short.nrrd", whole.substr(0, whole.size() - 1));
  expectInputError(folder / "short.nrrd", "truncated");
}

TEST_CASE("headers that declare absurd sizes are refused without allocating them") {
  const TemporaryFolder folder;
  writeBytes(folder / "huge.mha", metaHeader("", "2000000000 2000000000 2000000000") + "abc");
  expectInputError(folder / "huge.mha", "");
  writeBytes(folder / "packed.mha", metaHeader("CompressedData = True\n", "3000 3000 300") + "abc");
  expectInputError(folder / "packed.mha", "truncated or damaged");
  writeVolume(randomVolume(obliqueGrid(), VoxelType::uint8), folder / "v.nii");
  std::string bytes = readBytes(folder / "v.nii");
  for (std::size_t a = 0; a < 3; ++a) patch(bytes, 42 + 2 * a, std::int16_t{32000});
  writeBytes(folder / "huge.nii", bytes);
  expectInputError(folder / "huge.nii", "declares");
}

TEST_CASE("volumes without voxels and 2D images are refused") {
  const TemporaryFolder folder;
  writeBytes(folder / "zero.mha", metaHeader("", "0 2 2"));
  expectInputError(folder / "zero.mha", "");
  writeVolume(randomVolume(obliqueGrid(), VoxelType::uint8), folder / "v.nii");
  std::string bytes = readBytes(folder / "v.nii");
  patch(bytes, 44, std::int16_t{0});
  writeBytes(folder / "zero.nii", bytes);
  expectInputError(folder / "zero.nii", "no voxels");
  writeBytes(folder / "flat.mha", metaHeader("", "2 4 1") + "abcdefgh");
  expectInputError(folder / "flat.mha", "2D image");
  writeBytes(folder / "flat.nrrd",
             "NRRD0004\ntype: uint8\ndimension: 2\nsizes: 2 4\nencoding: raw\n\nabcdefgh");
  expectInputError(folder / "flat.nrrd", "2D image");
}

TEST_CASE("sheared axes, spacing of zero and vector voxels are refused") {
  const TemporaryFolder folder;
  writeBytes(folder / "sheared.nrrd", nrrd("(1,0,0) (0.1,1,0) (0,0,1)"));
  expectInputError(folder / "sheared.nrrd", "right angles");
  writeBytes(folder / "sheared.mha",
             metaHeader("TransformMatrix = 1 0 0 0.1 0.99498743710662 0 0 0 1\n") + "abcdefgh");
  expectInputError(folder / "sheared.mha", "right angles");
  writeBytes(
      folder / "vector.mha",
      "ObjectType = Image\nNDims = 3\nBinaryData = True\nElementNumberOfChannels = 3\nDimSize = 2 2 2\n"
      "ElementType = MET_FLOAT\nElementDataFile = LOCAL\n" +
          std::string(96, 'a'));
  expectInputError(folder / "vector.mha", "components");
  writeVolume(randomVolume(obliqueGrid(), VoxelType::uint8), folder / "v.nii");
  std::string bytes = readBytes(folder / "v.nii");
  patch(bytes, 40, std::int16_t{5});
  patch(bytes, 50, std::int16_t{3});
  writeBytes(folder / "vector.nii", bytes + bytes + bytes);
  expectInputError(folder / "vector.nii", "components");
}

TEST_CASE("a damaged NIfTI-2 header and Analyze are refused, metres become millimetres with a warning") {
  const TemporaryFolder folder;
  writeVolume(randomVolume(obliqueGrid(), VoxelType::uint8), folder / "v.nii");
  const std::string bytes = readBytes(folder / "v.nii");
  std::string changed = bytes;
  patch(changed, 0, std::int32_t{540});
  writeBytes(folder / "two.nii", changed);
  expectInputError(folder / "two.nii", "NIfTI-2");
  changed = bytes;
  patch(changed, 344, std::int32_t{0});
  writeBytes(folder / "analyze.img", changed);
  writeBytes(folder / "analyze.hdr", changed);
  expectInputError(folder / "analyze.hdr", "Analyze");
  changed = bytes;
  changed[123] = 1;
  writeBytes(folder / "metres.nii", changed);
  const VolumeInfo info = inspectVolume(folder / "metres.nii");
  expectWarning(info.warnings.at(0), FindingKind::lengthsInMetres,
                "The lengths in the header are in metres and were turned into millimetres.");
  changed[123] = 3;
  patch(changed, 252, std::int16_t{0});
  patch(changed, 254, std::int16_t{0});
  writeBytes(folder / "nowhere.nii", changed);
  const VolumeInfo nowhere = inspectVolume(folder / "nowhere.nii");
  REQUIRE(nowhere.warnings.size() == 2);
  expectWarning(nowhere.warnings[0], FindingKind::placeUnknown,
                "The header does not say how the volume lies in space (qform and sform codes are 0).");
  expectWarning(nowhere.warnings[1], FindingKind::lengthsInMicrometres,
                "The lengths in the header are in micrometres and were turned into millimetres.");
  const Grid grid = obliqueGrid();
  CHECK((info.grid.spacing - 1000 * grid.spacing).norm() < 0.02);
  CHECK((info.grid.toWorld(Vec3(3, 4, 2)) - 1000 * grid.toWorld(Vec3(3, 4, 2))).norm() < 0.02);
}

TEST_CASE("a NIfTI whose sform is no number is refused, though its qform is sound") {
  const TemporaryFolder folder;
  writeVolume(randomVolume(obliqueGrid(), VoxelType::uint8), folder / "v.nii");
  std::string bytes = readBytes(folder / "v.nii");
  patch(bytes, 254, std::int16_t{1});
  patch(bytes, 284, std::numeric_limits<float>::quiet_NaN());
  writeBytes(folder / "v.nii", bytes);
  expectInputError(folder / "v.nii", "sform");
}

TEST_CASE("voxels written as text that their type cannot hold are refused") {
  const TemporaryFolder folder;
  const auto write = [&](const std::string& type, const std::string& last) {
    writeBytes(folder / "v.nrrd", "NRRD0004\ntype: " + type +
                                      "\ndimension: 3\nsizes: 2 2 2\nspacings: 1 1 1\nencoding: text\n\n1 "
                                      "2 3 4 5 6 7 " +
                                      last + "\n");
    return folder / "v.nrrd";
  };
  CHECK(readVolume(write("uint8", "255")).data<std::uint8_t>()[7] == 255);
  expectInputError(write("uint8", "256"), "", true);
  expectInputError(write("int8", "-129"), "", true);
  expectInputError(write("short", "70000"), "", true);
  expectInputError(write("float", "1e400"), "", true);
}

TEST_CASE("a MetaImage whose data file is missing and a tracked sequence are refused") {
  const TemporaryFolder folder;
  writeBytes(
      folder / "v.mhd",
      "ObjectType = Image\nNDims = 3\nDimSize = 2 2 2\nElementType = MET_UCHAR\nElementDataFile = v.raw\n");
  expectInputError(folder / "v.mhd", "v.raw is missing");
  writeBytes(folder / "v.raw", "abcdefgh");
  CHECK(voxelBytes(readVolume(folder / "v.mhd")) == "abcdefgh");
  const std::string header = readBytes(folder / "v.mhd");
  const auto withSize = [&](const std::string& size) {
    return "ObjectType = Image\nHeaderSize = " + size + header.substr(header.find('\n'));
  };
  writeBytes(folder / "v.raw", "1234abcdefgh");
  for (const char* size : {"4", "-1"}) {  // -1: the data are the end of the file
    writeBytes(folder / "v.mhd", withSize(size));
    CHECK(voxelBytes(readVolume(folder / "v.mhd")) == "abcdefgh");
  }
  for (const char* size : {"four", "4x", "0.5"}) {
    writeBytes(folder / "v.mhd", withSize(size));
    expectInputError(folder / "v.mhd", "MetaImage");
  }
  writeBytes(folder / "one.mha", metaHeader("Seq_Frame0000_ImageStatus = OK\n") + "abcdefgh");
  CHECK_NOTHROW(readVolume(folder / "one.mha"));
  writeBytes(folder / "sequence.mha",
             metaHeader("Seq_Frame0000_ImageStatus = OK\nSeq_Frame0001_ImageStatus = OK\n") + "abcdefgh");
  expectInputError(folder / "sequence.mha", "sequence of tracked");
}

TEST_CASE(
    "infinite voxels are refused with their count and the first index, and so are none that is a number") {
  const TemporaryFolder folder;
  const VoxelType type = GENERATE(VoxelType::float32, VoxelType::float64);
  const Volume volume = randomVolume(obliqueGrid(), type);
  const auto spoil = [&](auto* values) {
    values[7 * 5 * 2 + 7 * 3 + 4] =
        std::numeric_limits<std::remove_reference_t<decltype(*values)>>::infinity();
    values[7 * 5 * 4 - 1] = -std::numeric_limits<std::remove_reference_t<decltype(*values)>>::infinity();
  };
  std::string voxels = voxelBytes(volume);
  if (type == VoxelType::float32)
    spoil(reinterpret_cast<float*>(voxels.data()));
  else
    spoil(reinterpret_cast<double*>(voxels.data()));
  writeBytes(folder / "nan.mha",
             "ObjectType = Image\nNDims = 3\nBinaryData = True\nDimSize = 7 5 4\nElementType = " +
                 std::string(type == VoxelType::float32 ? "MET_FLOAT" : "MET_DOUBLE") +
                 "\nElementDataFile = LOCAL\n" + voxels);
  expectInputError(folder / "nan.mha", "2 of its voxels are infinite, the first at index (4, 3, 2)", true);
}

TEST_CASE("any bytes under any name are refused or read, never a crash") {
  const TemporaryFolder folder;
  std::mt19937 random(7);
  std::string bytes;
  for (const char* name : {"v.nii", "v.nrrd", "v.mha"}) {
    writeVolume(randomVolume(obliqueGrid(), VoxelType::int16), folder / name);
    const std::string whole = readBytes(folder / name);
    for (int round = 0; round < 400; ++round) {
      bytes = whole;
      for (int change = 0; change < 4; ++change)
        bytes[random() % std::min<std::size_t>(400, bytes.size())] = static_cast<char>(random());
      const std::string path = folder / ("changed" + fs::path(name).extension().string());
      writeBytes(path, bytes);
      try {
        const Volume volume = readVolume(path);
        REQUIRE(volume.grid.spacing.minCoeff() > 0);
      } catch (const InputError& e) {
        REQUIRE(std::string(e.what()).rfind(path, 0) == 0);
      }
    }
  }
}

TEST_CASE("refusals leave standard error to the caller") {
  const TemporaryFolder folder;
  writeBytes(folder / "short.mha", metaHeader() + "abcdefg");
  writeBytes(folder / "bad.nrrd", "NRRD0004\ntype: strange\n\n");
  std::ostringstream caught;
  std::streambuf* before = std::cerr.rdbuf(caught.rdbuf());
  CHECK_THROWS_AS(readVolume(folder / "short.mha"), InputError);
  CHECK_THROWS_AS(readVolume(folder / "bad.nrrd"), InputError);
  std::cerr.rdbuf(before);
  CHECK(caught.str().empty());
}
