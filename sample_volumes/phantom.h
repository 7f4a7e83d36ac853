#pragma once
// Phantoms: volumes of known shape, with their truth label and their ideal surface. The dark part is the
// object.
//
// A shape is defined in millimetres in the volume's own frame (0 = centre of the volume, axes = its axes). So
// spacing and size change the sampling and not the shape; a rotation turns the direction matrix and with it
// the shape, about the centre of the volume, which stays at the same world point whatever the options.
//
// cyst      ultrasound of a cyst, a bright needle through it from front to back (y); z is depth. Genus 1.
// cube      80 mm cube, a bright ball in its centre pierces all six faces. Genus 5.
// genus3    two nodes joined by four equal arms, the seed in one of them. Genus 3.
// torus     solid torus around four bright balls. Genus 1 and four spheres.
// sphere    ball of 30 mm radius. Genus 0.
// dumbbell  two balls joined by a bar. Genus 0.
// wall      two chambers apart by a 2 mm wall, in which `gapVoxels` makes a hole. The object (truth,
// distance,
//           surface) is the seeded chamber alone. Genus 0.
// neck      two balls joined by a bar of 2.5 mm radius. Genus 0.
// rings     two linked rings joined by a bridge. Genus 2.
// trefoil   tube about a trefoil knot. Genus 1.
// tree      vessel tree: tubes of 3 mm radius with three loops. Genus 3.
// balls     ball with nine bright balls of 2 to 10 mm radius in it. Ten spheres.
// plate     4 mm thick, with round rims. Genus 0.
// gyroid    one of the two labyrinths of a gyroid of 40 mm period, in a rounded cube. Genus 27.
//
// Intensities of object and background: uint8 60 and 180, int16 -200 and 800, float32 0.25 and 0.75. A voxel
// at the surface holds the part of it that is dark (a smooth ramp as wide as the voxel along the normal), so
// that the half-way level lies on the ideal surface. Noise is white and Gaussian, in the cyst log-compressed
// Rayleigh speckle; there the boundary is not blurred by the point spread function, so that the truth stays
// sharp, and the intensity falls with depth by 0.25 of the contrast over the volume.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/mesh/mesh.h"
#include "core/volume/volume.h"

namespace handlebody {

struct PhantomOptions {
  //! Voxels; 0 = the phantom's own extent in mm divided by the spacing, rounded up. Any other number widens
  //! or narrows the view around the centre; the object and one voxel around it must fit.
  std::array<int, 3> size{0, 0, 0};
  Vec3 spacing{1, 1, 1};              //!< mm; at most half the thinnest part
  Vec3 rotationDegrees{0, 0, 0};      //!< direction matrix = Rz·Ry·Rx
  VoxelType type = VoxelType::uint8;  //!< uint8, int16 or float32
  double noise = -1;  //!< standard deviation as a fraction of the contrast; < 0 = the phantom's own
  double bias =
      1;  //!< >= 1: largest over smallest gain (over the own extent) of a smooth multiplicative field
  double gapVoxels = 0;  //!< width in y and z of a hole in the wall, voxels (only for `wall`)
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

//! Signed distance (mm, negative inside the object) of a world point to the ideal surface of a phantom. Exact
//! for cube, torus, sphere, wall, plate, balls and trefoil, outside of the others also at concave creases;
//! inside their creases (genus3, dumbbell, neck, rings, tree), and outside the rims where the needle enters
//! the cyst and where the cube cuts the gyroid, its magnitude is a lower bound. More than 6 mm from the body
//! of the cyst and 3 mm from the gyroid it is an estimate of the right sign. Throws UsageError as makePhantom
//! does.
double phantomDistance(const std::string& name, const PhantomOptions& options, const Vec3& world);

//! The ideal surface, cavities included, as a closed manifold mesh without self-intersections in world mm;
//! edges of 0.8 mm on average. Vertices lie on the surface within 0.002 mm; faces cut corners by up to 0.1 mm
//! where the radius is 3.5 mm (the needle) and by up to 0.5 mm at sharp edges (cube).
TriangleSoup phantomSurface(const std::string& name, const PhantomOptions& options);

}  // namespace handlebody
