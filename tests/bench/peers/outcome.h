#pragma once
// What one system made of one phantom, and how it is judged: the same way for all.

#include <string>
#include <vector>

#include "sample_volumes/phantom.h"

namespace handlebody::bench {

//! Plain data: it comes back from a child process.
struct Outcome {
  //! Everything but making the image: processor time on one thread, else what a clock shows.
  double seconds = 0;
  double peakMegabytes = 0;  //!< beyond what the process held before
  double dice = 0;           //!< with the truth label
  double distance = 0;       //!< mean over vertices and face middles to the ideal surface, voxels
  int vertices = 0;
  int components = 0;
  int genus = 0;               //!< sum over the components
  int selfIntersections = -1;  //!< pairs
  bool rightTopology = false;  //!< the genus of each component is the expected one
};

//! Components of less than this many voxels are not counted in any system's topology: specks of noise that a
//! user would remove with one click.
inline constexpr double kSpeck = 30;

//! Overlap of two labels (0: outside).
double dice(const std::vector<unsigned char>& label, const Volume& truth);

//! Fills in all but seconds, memory and dice.
void judge(Outcome& outcome, const TriangleSoup& mesh, const Phantom& phantom, const PhantomOptions& options);

}  // namespace handlebody::bench
