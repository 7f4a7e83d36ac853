#pragma once
// Every threshold of the search for the object that a click means, with what it rests on. Lengths in cells
// are mean spacings of the grid that is searched. Chosen on real volumes; how sensitive each is was not
// measured yet.

#include <array>
#include <cstddef>

namespace handlebody {

struct ObjectPolicy {
  // --- where is looked ---
  double reach = 160;  //!< mm: the search goes so far from a click along each axis; a liver is 250 mm wide
  std::size_t wideCells = 1'000'000;   //!< of a wide search; beyond it cells of several voxels are taken
  int nearCells = 44;                  //!< a near search goes so many voxels from the click along each axis
  std::size_t workCells = 12'000'000;  //!< of the grid on which the object is kept

  // --- intensities ---
  double smoothing = 0.6;  //!< cells: Gaussian before the search; more did not help in noise or speckle
  int rangeCells = 40;     //!< the range of intensities is that of so many cells around the click
  double outliers = 0.01;  //!< left out of it at either end
  int noiseCells = 20;     //!< the noise is measured in so many cells around the click
  double leastNoise = 1e-3, mostNoise = 0.1;     //!< of the range
  double firstRung = 1.0 / 150, lastRung = 0.7;  //!< of the range: distances from the level at the click

  // --- candidates ---
  std::array<int, 5> bands{5, 9, 13, 17, 20};  //!< rungs of the bound on the other side; the last is none
  std::array<int, 4> openings{0, 1, 3, 6};     //!< passes of the opening: 1.2 cells each
  double passLength = 1.2;                     //!< cells: cross and 18-neighbourhood in turn
  double largestPart = 0.5;                    //!< of the cells: what is larger is the background
  double mostBorder = 0.15;  //!< of the border's cells that a region may hold before it is the background
  std::size_t fewest =
      40;  //!< cells of a candidate: more than the 27 around the click, which belong to it by definition
  double sameSize = 0.22;    //!< |log of volumes| of regions that vote for each other
  double sameRegion = 0.75;  //!< intersection over union above which two candidates are one
  std::size_t offered = 5;

  // --- score: ranks from 0 to 1, added ---
  double stability = 0.7, edge = 0.7, contrast = 0.7;
  double border = 1.0;      //!< times the part of the surface on the border
  double size = 0.3;        //!< times the log of how far the volume exceeds largePart
  double largePart = 0.05;  //!< of the cells searched
  double close = 0.25;      //!< scores that differ by less are a close choice

  // --- corrections: lengths in depths of the click behind the surface, costs in scores ---
  std::size_t tried = 6;   //!< candidates of each kind that are tried
  double corrected = 0.3;  //!< cost of the first correction near a click; n times that of the nth in a row
  double mixed = 0.2;      //!< cost besides, of the part of another candidate
  double makeshift = 0.5;  //!< cost besides, of a ball where nothing else serves
  double correctionReach = 2.5;  //!< what is further from the click stays
  double makeshiftReach = 0.8;
  double tooDeep = 1;        //!< cost of the log of how much deeper a change is than
  double sameDeep = 1;       //!< this in the sense of the click, or
  double againstDeep = 0.3;  //!< this against it
  std::size_t cavity = 14;   //!< cells: smaller cavities are noise; a ball of one and a half cells' radius
};

}  // namespace handlebody
