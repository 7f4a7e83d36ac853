#include "core/io/dicom/dicom_resample.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace handlebody {
namespace {

template <typename T>
class Resampler {
 public:
  Resampler(const DicomStack& stack, const T* from)
      : stack_(stack),
        from_(from),
        columns_(stack.slices.front().file->columns),
        rows_(stack.slices.front().file->rows) {
    const std::size_t n =
        static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) * stack.slicesPerFrame();
    outside_ = *std::min_element(from, from + n);
  }
  void slice(int k, T* to) const;

 private:
  //! Bilinear in slice i at a place of the grid; NaN outside of it.
  double sample(std::size_t i, int gx, int gy) const;
  const DicomStack& stack_;
  const T* from_;
  int columns_, rows_;
  T outside_;
};

template <typename T>
double Resampler<T>::sample(std::size_t i, int gx, int gy) const {
  const double x = gx - stack_.places[i].x, y = gy - stack_.places[i].y;
  if (x < 0 || y < 0 || x > columns_ - 1 || y > rows_ - 1) return std::numeric_limits<double>::quiet_NaN();
  const int ix = std::min(static_cast<int>(x), columns_ - 2), iy = std::min(static_cast<int>(y), rows_ - 2);
  const double fx = x - ix, fy = y - iy;
  const T* p = from_ +
               (i * static_cast<std::size_t>(rows_) + static_cast<std::size_t>(iy)) *
                   static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(ix);
  const double low = (1 - fx) * static_cast<double>(p[0]) + fx * static_cast<double>(p[1]);
  const double high = (1 - fx) * static_cast<double>(p[columns_]) + fx * static_cast<double>(p[columns_ + 1]);
  return (1 - fy) * low + fy * high;
}

template <typename T>
void Resampler<T>::slice(int k, T* to) const {
  const auto& places = stack_.places;
  const double along = k * stack_.grid.spacing.z();
  std::size_t below = 0;
  while (below + 2 < places.size() && places[below + 1].along <= along) ++below;
  const double gap = places[below + 1].along - places[below].along;
  double above = std::clamp((along - places[below].along) / gap, 0.0, 1.0);
  constexpr double kOnSlice = 1e-9;  // a rounding error must not mix in the neighbour
  if (above < kOnSlice) above = 0;
  if (above > 1 - kOnSlice) above = 1;
  for (int y = 0; y < stack_.grid.size[1]; ++y)
    for (int x = 0; x < stack_.grid.size[0]; ++x, ++to) {
      double value = 0;
      if (above < 1) value += (1 - above) * sample(below, x, y);
      if (above > 0) value += above * sample(below + 1, x, y);
      if (std::isnan(value))
        *to = outside_;
      else
        *to = static_cast<T>(std::is_integral_v<T> ? std::round(value) : value);
    }
}

}  // namespace

void resampleStack(const DicomStack& stack, Component type, const void* from, void* to,
                   const DecodingProgress& progress) {
  const std::size_t voxels =
      static_cast<std::size_t>(stack.grid.size[0]) * static_cast<std::size_t>(stack.grid.size[1]);
  visitComponents(type, from, [&](const auto* in) {
    using T = std::remove_const_t<std::remove_pointer_t<decltype(in)>>;
    const Resampler<T> resampler(stack, in);
    for (int k = 0; k < stack.grid.size[2]; ++k) {
      progress(1, stack.slices.front().file->file, 0);
      resampler.slice(k, static_cast<T*>(to) + voxels * static_cast<std::size_t>(k));
    }
  });
}

}  // namespace handlebody
