#pragma once
// The peers of the whole job, behind plain arrays: ITK's and VTK's headers stay in their own files.
//
// Each peer gets what a user of it would have to find by hand: the level of the boundary, the smoothing and
// the weights that give the best overlap with the truth on this very image, and (level sets) the number of
// iterations after which the overlap is best. So what is compared is the peers at their best. Level sets run
// in itk::ParallelSparseFieldLevelSetImageFilter, half a voxel per iteration at most, as ITK-SNAP runs them.

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace handlebody::bench {

//! A volume in units of its contrast: the boundary lies at 0, the object is negative.
struct PeerImage {
  std::array<int, 3> size{};
  std::array<double, 3> spacing{};  //!< mm
  std::vector<float> values;        //!< x fastest
  std::array<double, 3> seed{};     //!< continuous voxel index
  double seedRadius = 0;            //!< mm
};

enum class Peer {
  thresholdLevelSet,  //!< itk::ThresholdSegmentationLevelSetFunction, the speed behind "region competition"
  geodesicLevelSet,   //!< itk::GeodesicActiveContourLevelSetFunction on a sigmoid of the gradient
  regionGrowing       //!< Gaussian, itk::ConnectedThresholdImageFilter
};

struct PeerSettings {
  double sigma = 1;        //!< of the Gaussian, voxels (mean spacing)
  double threshold = 0;    //!< level of the boundary, in units of the contrast
  double curvature = 0.2;  //!< weight; propagation has the weight 1
  double advection = 1;    //!< weight, geodesic only
  int iterations = 0;      //!< level sets only
  int threads = 1;
};

//! Called every few iterations with the number of iterations and the field; false ends the run.
using Watch = std::function<bool(int, const float*)>;

//! A field on the grid whose negative voxels are the object; its zero level is the surface.
std::vector<float> segmentWith(Peer peer, const PeerImage& image, const PeerSettings& settings,
                               const Watch& watch = {});

}  // namespace handlebody::bench
