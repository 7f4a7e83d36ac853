// STL, PLY and OBJ. (VTP is read by a child process.)

#include "core/io/formats/volume_source.h"
#include "core/io/meshes/mesh_files.h"
#include "tests/fuzz/libfuzzer/scratch_file.h"

namespace handlebody {

MeshFile readVtp(const std::string& path) { refuseInput(path, "not here"); }
bool isMeshPath(const std::string&) { return true; }  // stands beside the writers

}  // namespace handlebody

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t n) {
  static const handlebody::test::ScratchFile stl("m.stl"), ply("m.ply"), obj("m.obj");
  const bool isPly = n >= 3 && bytes[0] == 'p' && bytes[1] == 'l' && bytes[2] == 'y';
  for (const handlebody::test::ScratchFile* file : {&stl, &ply, &obj})
    if ((file == &ply) == isPly)
      handlebody::test::answeredOrRefused([&] { handlebody::readMesh(file->write(bytes, n)); });
  return 0;
}
