#pragma once
// Internal: the mesh formats. Coordinates are passed as they stand in the file.

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/decimal_point.h"
#include "core/io/meshes/mesh_io.h"

namespace handlebody {

//! A mesh as a file holds it.
struct MeshFile {
  TriangleSoup mesh{};
  CoordinateSpace space = CoordinateSpace::lps;
  std::vector<double> values{};  //!< per point, for .vtp; empty: none
  std::string valueName{};
  std::vector<MeshPart> parts{};  // written, not read back
};

//! "SPACE=LPS" or "SPACE=RAS": what we write into comments and headers.
std::string spaceMark(CoordinateSpace space);
//! The space that `text` (a header or comment) names; LPS if it names none.
CoordinateSpace spaceIn(const std::string& text);

//! Text, with every digit (VTK's OBJ writer and reader keep six). Write: `temporary` is a file that exists.
void writeObj(const MeshFile& file, const std::string& temporary);
MeshFile readObj(const std::string& path);

//! Text or binary, of either byte order.
MeshFile readPly(const std::string& path);

//! All objects that are built, one behind the other, in mm. In this process, as NIfTI and NRRD are unpacked:
//! unlike VTK's reader of VTP, libzip and expat are made for files that nobody trusts and fuzzed by others as
//! by us, what they hand on is checked here, and sizes and nesting are held before memory is taken.
MeshFile readThreeMf(const std::string& path);

//! A binary STL in memory, of the file `path`. Throws InputError.
MeshFile readStlBytes(std::string_view bytes, const std::string& path);
//! The STL within DICOM (Encapsulated STL). In this process: what looks for it is our own walk, which checks
//! every bound, and no library for DICOM has a part in it.
MeshFile readDicomStl(const std::string& path);
//! True for a file that is there and says at its beginning that it is one.
bool isEncapsulatedStlFile(const std::string& path);

//! VTK's messages go nowhere while one of these lives; errors are found through error codes and observers.
//! Numbers of its text formats have a point meanwhile.
class VtkSilence {
 public:
  VtkSilence();
  ~VtkSilence();
  VtkSilence(const VtkSilence&) = delete;
  VtkSilence& operator=(const VtkSilence&) = delete;

 private:
  bool before_;
  DecimalPoint point_{};
};

//! VTP through VTK, in a child process: its reader crashes on some damaged files.
MeshFile readVtp(const std::string& path, const DecoderSettings& settings);
//! The same in this process.
MeshFile readVtpHere(const std::string& path);

}  // namespace handlebody
