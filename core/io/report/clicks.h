#pragma once
// The clicks that a command line gives: parsed before the volume is read, so that a mistake is said at once,
// and placed in it afterwards.

#include <string>
#include <vector>

#include "core/evolution/parameters.h"
#include "core/volume/volume.h"

namespace handlebody {

//! The values of the options, one for each time that it was given.
struct ClickTexts {
  std::vector<std::string> seeds, voxelSeeds;            //!< --seed, --seed-ijk
  std::vector<std::string> background, voxelBackground;  //!< --background, --background-ijk
  //! True if no click is inside the object.
  bool hasNoSeed() const { return seeds.empty() && voxelSeeds.empty(); }
};

//! The clicks of both sides, those inside the object first.
struct Clicks {
  std::vector<Seed> world;   //!< mm LPS
  std::vector<Seed> voxels;  //!< continuous indices; the radius in voxels of mean size
};

//! Throws OptionError.
Clicks parseClicks(const ClickTexts& texts);

//! All of them in mm LPS: those inside the object first, and on each side those given in mm first.
std::vector<Seed> seedsInWorld(const Clicks& clicks, const Grid& grid);

}  // namespace handlebody
