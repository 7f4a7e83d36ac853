#pragma once
// The picture of one slice: voxels of the native type, interpolated to pixels, through window and colour map.

#include <QImage>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "ui/view/colour_map.h"
#include "ui/view/slice_geometry.h"

namespace handlebody::ui {

struct SliceColours {
  WindowLevel window;
  ColourMap map = ColourMap::grey;
  std::optional<IntensityRange> tint{};  //!< voxels (not pixels) in this range are tinted, or
  //! those that are 1 here, one value per voxel of the slice, across fastest; may be null.
  std::shared_ptr<const std::vector<std::uint8_t>> tinted{};
};

//! Which samples make up the pixels of one line: `taps` per pixel, of `begin` … `end` - 1.
struct Resampling {
  int begin = 0, end = 0;  //!< pixels whose centre lies in the volume
  int taps = 0;
  std::vector<int> sample;    //!< taps · (end - begin), never outside the line of samples
  std::vector<float> weight;  //!< add up to 1 for each pixel
};
//! Pixel p lies at first + p·step (continuous index of the sample, step ≠ 0). Linear interpolation; where
//! pixels are larger than samples a tent as wide as the pixel, so that nothing is skipped. Constant in the
//! outer half of the border samples.
Resampling resampling(int pixels, double first, double step, int samples);

//! Keeps the voxels it has gathered, so that windowing does not gather them again.
class SliceImage {
 public:
  //! Size is the geometry's, in device pixels (Format_RGB32, its ratio set); black outside the volume.
  const QImage& render(const Volume& volume, const SliceGeometry& geometry, double pixelRatio,
                       const SliceColours& colours);

 private:
  void gather(const Volume& volume, const SliceGeometry& geometry);

  QImage image_;
  std::shared_ptr<const void> gatheredFrom_;
  int normal_ = -1, slice_ = -1;
  int width_ = 0, height_ = 0;  // of the slice, voxels
  std::vector<float> plane_;    // the slice, across fastest
};

}  // namespace handlebody::ui
