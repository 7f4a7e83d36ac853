#pragma once
// How a volume's own axes lie in the patient, and how slices along them are shown.

#include <array>
#include <string>

#include "core/volume/volume.h"

namespace handlebody {

//! As numbers: the world axis (L, P, S) that it lies across.
enum class AnatomicalPlane { sagittal, coronal, axial };

//! The voxel axis nearest to each of L, P, S: every axis is taken once.
std::array<int, 3> nearestAxes(const Grid& grid);
//! True if a voxel axis is more than a degree away from its anatomical one.
bool isOblique(const Grid& grid);

//! The letter at the end of world axis 0 (L, R), 1 (P, A) or 2 (S, I).
char anatomicalLetter(int worldAxis, bool positive);
//! A coordinate (mm LPS) with its letter instead of a sign: "R 12.5".
std::string anatomicalPlace(int worldAxis, double mm);
//! "Axial", "Coronal" or "Sagittal".
const char* anatomicalName(AnatomicalPlane plane);

//! The longest of 1, 2 and 5 times a power of ten that is at most `longest` (> 0), for a scale bar.
double roundLength(double longest);

//! How a slice lies on the screen: the patient's right on the left, superior up, and anterior up in the
//! axial, on the left in the sagittal slice.
struct SliceAxes {
  int normal = 2, across = 0, down = 1;                   //!< voxel axes
  double acrossSign = 1, downSign = 1;                    //!< -1: the index falls to the right, or downwards
  char left = 'R', right = 'L', top = 'A', bottom = 'P';  //!< letters at the edges
};
SliceAxes sliceAxes(const Grid& grid, AnatomicalPlane plane);

//! Unit vector (LPS) towards the eye that surfaces are shown to at first: from the front, left and above.
Vec3 obliqueSight();

}  // namespace handlebody
