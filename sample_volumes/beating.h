#pragma once
// A phantom that beats and twists: a dark, ventricle-like cavity in a bright wall that thickens as it
// contracts, in grey surroundings, over one period, with the truth in every frame.
//
// The cavity is an ellipsoid whose cross-sections have three lobes (trabeculae), so that its torsion shows:
// the half axis a(t) of the sections, c(t) along z, lobes of a tenth of the radius, turned by an angle that
// grows from the base (z < 0) to the apex. The volume 4/3·π·a²·c·(1 + m²/2) is exact whatever the torsion.
// From the largest volume V it falls to V·(1 - ejection) at 0.35 of the period, as a raised cosine, is back
// at 0.8, and rests. Of the change of ln V each of the axes across takes 2/5, the axis along 1/5. The wall
// keeps its own volume. The torsion is largest at end systole.

#include <vector>

#include "sample_volumes/phantom.h"

namespace handlebody {

struct BeatingOptions {
  //! Size, spacing, rotation, type, noise (< 0: 0.1, as speckle 0.2; of each frame its own) and random seed;
  //! no bias and no gap. Spacing: 4 mm at most.
  PhantomOptions image;
  int frames = 20;        //!< >= 2, of one period
  double ejection = 0.6;  //!< fraction, 0 … 0.8
  double period = 1000;   //!< ms
  double torsion = 20;    //!< degrees between base and apex at end systole
  bool speckle = false;   //!< log-compressed speckle instead of white noise
};

class BeatingPhantom {
 public:
  //! Throws UsageError for an option without meaning.
  explicit BeatingPhantom(const BeatingOptions& options);

  const Grid& grid() const { return grid_; }
  const BeatingOptions& options() const { return options_; }
  Vec3 seed() const;               //!< mm, LPS: inside in every frame
  double time(int frame) const;    //!< ms
  double volume(int frame) const;  //!< mm³ of the cavity, exact
  //! Of the frames' volumes: (largest - smallest) / largest. That of the options where a frame is at 0.35 of
  //! the period.
  double sampledEjection() const;

  Volume image(int frame) const;
  Volume truth(int frame) const;  //!< uint8: 1 in the cavity
  //! First-order distance (mm, negative inside) of a world point to the cavity's surface, exact on it.
  double distance(int frame, const Vec3& world) const;

 private:
  struct Moment;
  Moment moment(int frame) const;

  BeatingOptions options_;
  Grid grid_;
  Vec3 centre_{0, 0, 0};
};

}  // namespace handlebody
