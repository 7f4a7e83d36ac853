#include <itkCommand.h>
#include <itkConnectedThresholdImageFilter.h>
#include <itkGeodesicActiveContourLevelSetFunction.h>
#include <itkGradientMagnitudeRecursiveGaussianImageFilter.h>
#include <itkImage.h>
#include <itkMultiThreaderBase.h>
#include <itkParallelSparseFieldLevelSetImageFilter.h>
#include <itkSigmoidImageFilter.h>
#include <itkSmoothingRecursiveGaussianImageFilter.h>
#include <itkThresholdSegmentationLevelSetFunction.h>

#include <cmath>

#include "tests/bench/peers/peer.h"

namespace handlebody::bench {

namespace {

using Image = itk::Image<float, 3>;
constexpr int kWatchEvery = 5;    // iterations
constexpr double kCourant = 0.5;  // of a voxel the surface moves at most in one iteration; ITK's own: 1/6

std::size_t voxelCount(const PeerImage& image) {
  return static_cast<std::size_t>(image.size[0]) * static_cast<std::size_t>(image.size[1]) *
         static_cast<std::size_t>(image.size[2]);
}

double meanSpacing(const PeerImage& image) {
  return std::cbrt(image.spacing[0] * image.spacing[1] * image.spacing[2]);
}

Image::Pointer makeImage(const PeerImage& like) {
  Image::SizeType size;
  Image::SpacingType spacing;
  for (unsigned a = 0; a < 3; ++a) {
    size[a] = static_cast<itk::SizeValueType>(like.size[a]);
    spacing[a] = like.spacing[a];
  }
  auto image = Image::New();
  image->SetRegions(size);
  image->SetSpacing(spacing);
  image->Allocate();
  return image;
}

Image::Pointer asImage(const PeerImage& in) {
  auto image = makeImage(in);
  std::copy(in.values.begin(), in.values.end(), image->GetBufferPointer());
  return image;
}

Image::Pointer smoothed(const PeerImage& in, double sigma) {
  auto filter = itk::SmoothingRecursiveGaussianImageFilter<Image, Image>::New();
  filter->SetInput(asImage(in));
  filter->SetSigma(sigma * meanSpacing(in));
  filter->Update();
  return filter->GetOutput();
}

//! Signed distance (mm) to the seed ball.
Image::Pointer seedDistance(const PeerImage& in) {
  auto image = makeImage(in);
  float* out = image->GetBufferPointer();
  for (int k = 0; k < in.size[2]; ++k)
    for (int j = 0; j < in.size[1]; ++j)
      for (int i = 0; i < in.size[0]; ++i) {
        const double x = (i - in.seed[0]) * in.spacing[0], y = (j - in.seed[1]) * in.spacing[1],
                     z = (k - in.seed[2]) * in.spacing[2];
        *out++ = static_cast<float>(std::sqrt(x * x + y * y + z * z) - in.seedRadius);
      }
  return image;
}

std::vector<float> valuesOf(const Image* image, std::size_t count) {
  return {image->GetBufferPointer(), image->GetBufferPointer() + count};
}

using Function = itk::SegmentationLevelSetFunction<Image, Image>;

//! The solver behind ITK-SNAP: the sparse field whose layers are split among threads.
std::vector<float> evolve(Function* speed, const PeerImage& in, const PeerSettings& s, const Watch& watch) {
  Function::SetMaximumPropagationTimeStep(kCourant);
  speed->SetPropagationWeight(1);
  speed->SetCurvatureWeight(static_cast<float>(s.curvature));
  auto filter = itk::ParallelSparseFieldLevelSetImageFilter<Image, Image>::New();
  filter->SetDifferenceFunction(speed);
  filter->SetMaximumRMSError(0);
  filter->SetNumberOfIterations(static_cast<itk::IdentifierType>(s.iterations));
  filter->SetIsoSurfaceValue(0);
  filter->SetInput(seedDistance(in));
  if (watch)
    filter->AddObserver(itk::IterationEvent(), [&](const itk::EventObject&) {
      const auto n = static_cast<int>(filter->GetElapsedIterations());
      if (n % kWatchEvery == 0 && !watch(n, filter->GetOutput()->GetBufferPointer()))
        filter->SetNumberOfIterations(0);
    });
  filter->Update();
  return valuesOf(filter->GetOutput(), voxelCount(in));
}

Image::SizeType oneVoxel() {
  Image::SizeType radius;
  radius.Fill(1);
  return radius;
}

std::vector<float> thresholdLevelSet(const PeerImage& in, const PeerSettings& s, const Watch& watch) {
  auto speed = itk::ThresholdSegmentationLevelSetFunction<Image, Image>::New();
  const Image::Pointer image = smoothed(in, s.sigma);
  speed->SetFeatureImage(image);
  speed->SetUpperThreshold(static_cast<float>(s.threshold));
  speed->SetLowerThreshold(-4);  // far below the object: its side of the speed is never met
  speed->SetEdgeWeight(0);
  speed->Initialize(oneVoxel());
  speed->AllocateSpeedImage();
  speed->CalculateSpeedImage();
  return evolve(speed, in, s, watch);
}

std::vector<float> geodesicLevelSet(const PeerImage& in, const PeerSettings& s, const Watch& watch) {
  auto gradient = itk::GradientMagnitudeRecursiveGaussianImageFilter<Image, Image>::New();
  gradient->SetInput(asImage(in));
  const double sigma = s.sigma * meanSpacing(in);
  gradient->SetSigma(sigma);
  // A step of height 1 blurred with sigma has the gradient 0.4/sigma. As ITK's guide has it: alpha is a sixth
  // of the interval between the weakest edge and the strongest flat place, beta its middle.
  const double peak = 0.4 / sigma;
  auto sigmoid = itk::SigmoidImageFilter<Image, Image>::New();
  sigmoid->SetInput(gradient->GetOutput());
  sigmoid->SetOutputMinimum(0);
  sigmoid->SetOutputMaximum(1);
  sigmoid->SetAlpha(-(0.6 - 0.15) * peak / 6);
  sigmoid->SetBeta((0.6 + 0.15) * peak / 2);
  sigmoid->Update();
  auto speed = itk::GeodesicActiveContourLevelSetFunction<Image, Image>::New();
  speed->SetFeatureImage(sigmoid->GetOutput());
  speed->Initialize(oneVoxel());
  speed->AllocateSpeedImage();
  speed->CalculateSpeedImage();
  speed->AllocateAdvectionImage();
  speed->CalculateAdvectionImage();
  speed->SetAdvectionWeight(static_cast<float>(s.advection));
  return evolve(speed, in, s, watch);
}

//! The smoothed image less the threshold; outside of the region that was reached (and one voxel around it,
//! where the surface is interpolated) it is positive.
std::vector<float> regionGrowing(const PeerImage& in, const PeerSettings& s) {
  using Mask = itk::Image<unsigned char, 3>;
  const Image::Pointer image = smoothed(in, s.sigma);
  auto grow = itk::ConnectedThresholdImageFilter<Image, Mask>::New();
  grow->SetInput(image);
  grow->SetUpper(static_cast<float>(s.threshold));
  grow->SetLower(itk::NumericTraits<float>::NonpositiveMin());
  grow->SetReplaceValue(1);
  Image::IndexType seed;
  for (unsigned a = 0; a < 3; ++a) seed[a] = std::lround(in.seed[a]);
  grow->SetSeed(seed);
  grow->Update();
  const unsigned char* reached = grow->GetOutput()->GetBufferPointer();
  const float* values = image->GetBufferPointer();
  std::vector<float> field(voxelCount(in));
  for (std::size_t v = 0; v < field.size(); ++v) {
    const auto value = values[v] - static_cast<float>(s.threshold);
    field[v] = reached[v] != 0 || value > 0 ? value : 0.5f;
  }
  return field;
}

}  // namespace

std::vector<float> segmentWith(Peer peer, const PeerImage& image, const PeerSettings& settings,
                               const Watch& watch) {
  const auto threads = static_cast<itk::ThreadIdType>(settings.threads);
  itk::MultiThreaderBase::SetGlobalMaximumNumberOfThreads(threads);
  itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(threads);
  switch (peer) {
    case Peer::thresholdLevelSet:
      return thresholdLevelSet(image, settings, watch);
    case Peer::geodesicLevelSet:
      return geodesicLevelSet(image, settings, watch);
    default:
      return regionGrowing(image, settings);
  }
}

}  // namespace handlebody::bench
