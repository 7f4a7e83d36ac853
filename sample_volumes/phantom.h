#pragma once
// Phantoms: volumes of known shape, with their truth label and their ideal surface. Shapes are defined in
// millimetres in the volume's own frame, so that spacing and rotation change the sampling and not the shape.

#include <cstdint>
#include <string>
#include <vector>

#include "core/mesh/mesh.h"
#include "core/volume/volume.h"

namespace handlebody {

struct PhantomOptions {
  std::array<int, 3> size{0, 0, 0};   //!< voxels; 0 = the phantom's own extent in mm divided by the spacing
  Vec3 spacing{1, 1, 1};              //!< mm
  Vec3 rotationDegrees{0, 0, 0};      //!< direction matrix = Rz·Ry·Rx
  VoxelType type = VoxelType::uint8;  //!< uint8, int16 or float32
  double noise = -1;     //!< standard deviation as a fraction of the contrast; < 0 = the phantom's own
  double bias = 1;       //!< largest gain over smallest gain of a smooth multiplicative field
  double gapVoxels = 0;  //!< width of a hole in the wall, voxels
  std::uint32_t randomSeed = 1;
};

struct Phantom {
  std::string name;
  Volume volume;
  Volume truth;            //!< uint8 label map
  Vec3 seed{0, 0, 0};      //!< mm, LPS
  double seedRadius = 0;   //!< mm
  std::vector<int> genus;  //!< expected, per component, the largest component first
};

//! Names makePhantom accepts.
const std::vector<std::string>& phantomNames();

//! Throws UsageError for an unknown name or an option without meaning.
Phantom makePhantom(const std::string& name, const PhantomOptions& options = {});

//! Signed distance (mm, negative inside the object) of a world point to the ideal surface of a phantom; exact
//! near the surface.
double phantomDistance(const std::string& name, const PhantomOptions& options, const Vec3& world);

//! The ideal surface as a closed mesh in world mm.
TriangleSoup phantomSurface(const std::string& name, const PhantomOptions& options);

}  // namespace handlebody
