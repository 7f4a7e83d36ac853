#pragma once
// The clicks that a command line gives: parsed before the volume is read, so that a mistake is said at once,
// and placed in it afterwards.

#include <string>
#include <vector>

#include "core/evolution/parameters.h"
#include "core/volume/volume.h"

namespace handlebody {

//! An option that gives a click, and its value.
struct ClickText {
  std::string option;  //!< --seed, --seed-ijk, --background, --background-ijk
  std::string text;
};
//! In the order given: the first click inside the object decides what is meant.
using ClickTexts = std::vector<ClickText>;

//! True if no click is inside the object.
bool hasNoSeed(const ClickTexts& texts);

//! A click as an option gives it.
struct Click {
  Seed seed;                //!< mm LPS, or:
  bool isInVoxels = false;  //!< continuous indices; the radius in voxels of mean size
};

//! In their order. Throws OptionError.
std::vector<Click> parseClicks(const ClickTexts& texts);

//! All of them in mm LPS: those inside the object first, each side in its order.
std::vector<Seed> seedsInWorld(const std::vector<Click>& clicks, const Grid& grid);

}  // namespace handlebody
