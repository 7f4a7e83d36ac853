// STL, alone and within DICOM, PLY and OBJ. (VTP is read by a child process.)

#include <cstring>

#include "core/io/formats/volume_source.h"
#include "core/io/meshes/mesh_files.h"
#include "tests/fuzz/libfuzzer/scratch_file.h"

namespace handlebody {

MeshFile readVtp(const std::string& path, const DecoderSettings&) { refuseInput(path, "not here"); }
bool isMeshPath(const std::string&) { return true; }  // stands beside the writers

}  // namespace handlebody

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t n) {
  static const handlebody::test::ScratchFile stl("m.stl"), ply("m.ply"), obj("m.obj"), dicom("m.stl.dcm");
  const auto begins = [&](std::size_t at, const char* magic, std::size_t length) {
    return n >= at + length && std::memcmp(bytes + at, magic, length) == 0;
  };
  const bool isPly = begins(0, "ply", 3), isDicom = begins(128, "DICM", 4);
  for (const handlebody::test::ScratchFile* file : {&stl, &ply, &obj, &dicom})
    if ((file == &ply) == isPly && (file == &dicom) == isDicom)
      handlebody::test::answeredOrRefused([&] { handlebody::readMesh(file->write(bytes, n)); });
  return 0;
}
