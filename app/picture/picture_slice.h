#pragma once
// Internal: one slice of a picture. Where it lies is planned apart from the drawing, so that it can be
// tested.

#include <array>
#include <string>

#include "app/picture/picture.h"
#include "app/picture/picture_canvas.h"
#include "core/mesh/mesh.h"
#include "core/volume/anatomy.h"
#include "core/volume/volume.h"

namespace handlebody {

//! A plane across one voxel axis, and how the other two lie on the picture.
struct SliceView : SliceAxes {
  AnatomicalPlane plane = AnatomicalPlane::axial;
  Rect area;              //!< pixels
  Vec3 centre{0, 0, 0};   //!< voxel index at the middle of `area`; its `normal` part is the slice
  Vec3 spacing{1, 1, 1};  //!< mm
  double mmPerPixel = 1;

  //! Continuous voxel index → picture; what is off the plane is projected onto it.
  Vec2 toPicture(const Vec3& index) const;
  Vec3 toIndex(const Vec2& pixel) const;
};

//! The slice through `point` (continuous voxel index) that shows [low, high] (voxel indices of the mesh's
//! bounding box) at two and a half times its size, or the whole volume if that is smaller. It lies on voxel
//! centres unless the mesh would be missed there.
SliceView planSlice(const Grid& grid, AnatomicalPlane plane, const Vec3& point, const Vec3& low,
                    const Vec3& high, const Rect& area);

//! The three slices of a picture: axial, coronal, sagittal.
std::array<SliceView, 3> planSlices(const Grid& grid, const TriangleSoup& mesh,
                                    const PictureOptions& options);

//! Intensities that are drawn black and white.
struct GreyWindow {
  double black = 0, white = 1;
};

void drawVoxels(Canvas& canvas, const SliceView& view, const Volume& volume, const GreyWindow& window);
//! `points`: the mesh's points as continuous voxel indices.
void drawOutline(Canvas& canvas, const SliceView& view, const std::vector<Vec3>& points,
                 const std::vector<Triangle>& triangles);
//! R, L, A, P, S, I at the edges.
void drawLetters(Canvas& canvas, const SliceView& view);
//! "Axial, S 12.0 mm" and "slice 5 of 20".
std::array<std::string, 2> sliceCaptions(const SliceView& view, const Grid& grid);

}  // namespace handlebody
