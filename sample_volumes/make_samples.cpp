// Writes the small ready phantoms of this folder: make_samples FOLDER. One line per phantom tells where its
// seed is.

#include <array>
#include <cstdio>
#include <exception>
#include <string>

#include "core/io/formats/volume_io.h"
#include "sample_volumes/phantom.h"

namespace {

struct Sample {
  const char* name;
  double spacing;  // mm, so coarse that a file stays below 600 kB
};

constexpr std::array<Sample, 4> kSamples{{{"cyst", 2}, {"cube", 1.5}, {"genus3", 1.5}, {"torus", 1.5}}};

void writeSample(const Sample& sample, const std::string& folder) {
  handlebody::PhantomOptions options;
  options.spacing = handlebody::Vec3::Constant(sample.spacing);
  const handlebody::Phantom phantom = handlebody::makePhantom(sample.name, options);
  handlebody::writeVolume(phantom.volume, folder + "/" + sample.name + ".nii.gz");
  handlebody::writeVolume(phantom.truth, folder + "/" + sample.name + "_truth.nii.gz");
  std::printf("%s: --seed %g,%g,%g,%g   genus", sample.name, phantom.seed.x(), phantom.seed.y(),
              phantom.seed.z(), phantom.seedRadius);
  for (const int genus : phantom.genus) std::printf(" %d", genus);
  std::printf("\n");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "Usage: make_samples FOLDER\n");
    return 2;
  }
  try {
    for (const Sample& sample : kSamples) writeSample(sample, argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
