#pragma once
// A picture of a result, made without a display: three slices with the mesh's outline, and the mesh itself.

#include <optional>
#include <string>

#include "core/mesh/mesh.h"
#include "core/volume/volume.h"

namespace handlebody {

//! Pixels of every picture.
constexpr int kPictureWidth = 1200;
constexpr int kPictureHeight = 1000;

struct PictureOptions {
  //! Where the slices are taken, mm LPS; unless given the centre of the mesh's bounding box. Moved into the
  //! volume if it lies outside.
  std::optional<Vec3> point{};
};

//! True for .png (any case).
bool isPicturePath(const std::string& path);

//! Writes a PNG, whole or not at all: axial, coronal and sagittal slice along the volume's own axes, each
//! named after the nearest anatomical axis ("oblique" if it is more than a degree away), with the patient's
//! right on the left, superior up and anterior on the left in the sagittal slice; and the mesh from the
//! front, left and above. `mesh` in mm LPS, of any kind, may be empty. Intensities from the 0.1 to the 99.9
//! percentile of the volume. Precondition: the volume has voxels, none of them NaN. Not for two threads at a
//! time (VTK's text). Throws OutputError; UsageError for an extension other than .png.
void writePicture(const Volume& volume, const TriangleSoup& mesh, const std::string& path,
                  const PictureOptions& options = {});

//! A small picture has one pixel for so many of each row and column.
constexpr int kThumbnailPart = 5;

//! The bytes of a small PNG of a picture that writePicture wrote. Throws InputError if it is none.
std::string thumbnailOf(const std::string& picture);

}  // namespace handlebody
