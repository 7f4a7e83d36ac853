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
};

//! The clicks of both sides, those inside the object first.
struct Clicks {
  std::vector<Seed> world;   //!< mm LPS
  std::vector<Seed> voxels;  //!< continuous indices; the radius in voxels of mean size
};

//! Throws UsageError that names the option, also if no click is inside the object, unless a surface to begin
//! with is (`hasStart`).
Clicks parseClicks(const ClickTexts& texts, bool hasStart = false);
//! The same for clicks that come to others: none of them need be inside.
Clicks parseFurtherClicks(const ClickTexts& texts);

//! All of them in mm LPS: those inside the object first, and on each side those given in mm first.
std::vector<Seed> seedsInWorld(const Clicks& clicks, const Grid& grid);

}  // namespace handlebody
