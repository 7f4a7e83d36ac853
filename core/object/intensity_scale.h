#pragma once
// Intensities as the search for an object compares them.

#include <vector>

#include "core/object/cells.h"

namespace handlebody {

//! Intensities as they are; or their logarithms where noise grows with the signal and nothing has a plateau,
//! as in PET and SPECT: there an object ends where its intensity falls by a given ratio, wherever its maximum
//! lies, and a step of a given ratio stands out of the noise equally well everywhere.
class IntensityScale {
 public:
  //! As they are.
  IntensityScale() = default;
  //! What suits an image: octave by octave below its highest intensities, how strong is the noise?
  static IntensityScale of(const CellImage& image, const ObjectPolicy& policy);

  bool isLogarithmic() const { return offset_ > 0; }
  double to(double intensity) const;
  double from(double scaled) const;  //!< infinite where that is
  void apply(std::vector<float>& intensities) const;

 private:
  double low_ = 0, offset_ = 0;  // log(intensity - low + offset); offset 0: as they are
};

}  // namespace handlebody
