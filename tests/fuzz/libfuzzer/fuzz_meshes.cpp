// STL, alone and within DICOM, PLY, OBJ and 3MF; what begins as XML is packed as the model of a 3MF file,
// whose checksums nothing would pass else. (VTP is read by a child process.)

#include <cstring>

#include "core/io/formats/volume_source.h"
#include "core/io/meshes/mesh_files.h"
#include "tests/fuzz/libfuzzer/scratch_file.h"
#include "tests/io/zip_test_support.h"

namespace handlebody {

MeshFile readVtp(const std::string& path, const DecoderSettings&) { refuseInput(path, "not here"); }
bool isMeshPath(const std::string&) { return true; }  // stands beside the writers

}  // namespace handlebody

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t n) {
  static const handlebody::test::ScratchFile stl("m.stl"), ply("m.ply"), obj("m.obj"), dicom("m.stl.dcm"),
      print("m.3mf");
  const auto begins = [&](std::size_t at, const char* magic, std::size_t length) {
    return n >= at + length && std::memcmp(bytes + at, magic, length) == 0;
  };
  if (begins(0, "<", 1)) {
    const std::string packed =
        handlebody::test::archiveOfModel(std::string(reinterpret_cast<const char*>(bytes), n));
    handlebody::test::answeredOrRefused([&] {
      handlebody::readMesh(print.write(reinterpret_cast<const std::uint8_t*>(packed.data()), packed.size()));
    });
    return 0;
  }
  const bool isPly = begins(0, "ply", 3), isDicom = begins(128, "DICM", 4), isPrint = begins(0, "PK", 2);
  for (const handlebody::test::ScratchFile* file : {&stl, &ply, &obj, &dicom, &print})
    if ((file == &ply) == isPly && (file == &dicom) == isDicom && (file == &print) == isPrint)
      handlebody::test::answeredOrRefused([&] { handlebody::readMesh(file->write(bytes, n)); });
  return 0;
}
