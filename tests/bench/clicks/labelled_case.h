#pragma once
// Real volumes with a reference label, and the user who clicks in them.

#include <cstdint>
#include <string>
#include <vector>

#include "core/volume/volume.h"

namespace handlebody::bench {

//! Voxels of a volume, x fastest: 1 = the object.
using Mask = std::vector<std::uint8_t>;

//! One structure of a case file, which lists objects {name, volume, label, value (0: any label), grade
//! (clear or hard)} with paths relative to it.
struct LabelledCase {
  std::string name, grade, volumePath, labelPath;
  int value = 0;
};
//! Throws InputError, which names the file.
std::vector<LabelledCase> readCases(const std::string& path);

struct LabelledVolume {
  Volume volume;
  Mask truth;  //!< on the volume's grid
};
//! Throws InputError.
LabelledVolume readLabelled(const LabelledCase& c);

struct UserClick {
  Vec3 place;  //!< mm
  bool isInside = true;
};

//! `most` voxels of the object at least 40 % as deep as its deepest, drawn without repetition.
std::vector<Vec3> firstClicks(const LabelledVolume& v, int most, unsigned seed);

//! The deepest voxel of the largest connected part that is wrong; false where nothing is.
bool nextClick(const LabelledVolume& v, const Mask& result, UserClick& click);

double diceOf(const Mask& a, const Mask& b);

}  // namespace handlebody::bench
