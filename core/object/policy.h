#pragma once
// Every threshold of the search for the object that a click means, with what it rests on. Lengths in cells
// are mean spacings of the grid that is searched. Chosen on real volumes; docs/object.md tells how sensitive
// those of score and choice are and most of the corrections', the others were not measured yet.

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

  // --- logarithms of intensities: where, over three octaves below the highest, ---
  double logTop = 0.001;     //!< (this part of the cells left out)
  double logGrowth = 1.5;    //!< the noise grows so much at least from octave to octave
  double logPlateau = 0.03;  //!< and no more than this part of the cells is in the highest one
  double logFloor = 0.016;   //!< of the highest: what is lower is one

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
  std::size_t likely = 100;    //!< best regions that are weighed against each other
  double likelySame = 0.9;     //!< intersection over union above which two of them are one
  double likelyScore = 0.3;    //!< scores that differ by this differ e-fold in likelihood
  double central = 0.4;        //!< cost of the log of how much nearer a click is to the rim than this part
  double centralDepth = 0.5;   //!< of the deepest place: a user clicks well inside of what is meant
  double leastCentral = 0.02;  //!< and less deep than this makes no difference
  double crisp = 0.72;         //!< Dice above which, of what is expected to fit, the best score is taken

  // --- star-shaped regions: lengths on their rays in parts of the radius they are looked for at ---
  double starSmoothing = 0.8;  //!< cells: Gaussian besides the search's
  double starRays = 0.34;      //!< distance of neighbours on the unit sphere: 162 rays
  double smallestStart = 3;    //!< cells: radius of the first sphere
  double nextStart = 1.6;      //!< times as large is the next one
  double largestStart = 0.3;   //!< of the widest side of what is searched; no more than a third of the reach
  double starInner = 0.2, starOuter = 2.2;
  std::size_t starBend = 2;  //!< steps of 6 % that the radius may change by from ray to ray
  double starShell = 1.5;    //!< the inside is told from what lies up to here
  double starEdge = 3;       //!< weight of a strong edge against a whole ray of certain intensities
  double starBeyond = 2;     //!< log of the odds against places where there is no image
  double starMargin = 1.5;   //!< cells from a click to the surface
  int starMoves = 4;         //!< of the centre towards the middle,
  double starMove = 0.8;     //!< by this part of the way
  int starRounds = 4;        //!< of statistics and surface; half of them before the last move

  // --- tubes: lengths in parts of the radius they are looked for at ---
  double tubeSmallest = 1.5;     //!< cells: radius of the first start
  double tubeNext = 1.5;         //!< times as large is the next one
  double tubeLargest = 30;       //!< mm; an aorta that is widened
  double tubeDirections = 0.55;  //!< distance of neighbours on the unit sphere: 21 lines through the click
  double tubeShell = 1.5;        //!< the inside is told from what lies up to here
  double tubeEdge = 2;           //!< weight of a strong edge against a whole ray of certain intensities
  double tubeStart = 2;     //!< cost of the squared log of how far a radius is from the expected: at first,
  double tubeKeep = 20;     //!< on the way,
  double tubeSmooth = 20;   //!< and in the end
  double tubeStep = 0.7;    //!< to the next plane
  double tubeTurn = 0.4;    //!< part that a new plane has in the direction
  double tubeGrowth = 1.5;  //!< from what is expected at most
  double tubeWeak = 0.5;    //!< of the usual edge: less of it is no tube
  int tubeMissed = 4;       //!< planes in a row that may be none
  std::size_t tubeSections = 300;  //!< planes at most
  std::size_t tubeAround = 4;      //!< planes on each side that say what is usual
  int tubeRounds = 2;              //!< of all outlines in the end
  double tubeLong = 2.5;           //!< diameters; what is shorter is star-shaped
  double tubeBonus = 0.3;          //!< agreement for each time that it is 2.7 times as long

  // --- score: ranks from 0 to 1, added ---
  double stability = 0.5, edge = 0.7, contrast = 0.7;
  double shape = 0.1;  //!< times the log of how much more surface than a ball's, cubed, between the limits
  double compact = 1.2, ragged = 6;  //!< a ball of voxels has 1.2
  double agreement = 0.8;            //!< of the starts, in place of stability: of a star-shaped region
  double clearContrast = 1.35;       //!< of the best region: from here on, or from
  double clearEdge = 4;              //!< noises per cell on, star-shaped ones come behind it
  double border = 1.0;               //!< times the part of the surface on the border
  double size = 0.3;                 //!< times the log of how far the volume exceeds largePart
  double largePart = 0.05;           //!< of the cells searched
  double thinPart = 0.35;            //!< of its deepest place: a click less deep is a close choice
  double close = 0.25;               //!< star-shaped ones come this much behind
  double sure = 0.7;                 //!< expected Dice: what is chosen with less is a close choice
  double rival = 0.05;               //!< and where another one's is not lower by this

  // --- corrections: lengths in depths of the click behind the surface, costs in scores ---
  std::size_t tried = 6;    //!< regions of the click's own search that are tried
  std::size_t weighed = 8;  //!< best corrections that are weighed against each other
  double corrected =
      0.3;  //!< cost of a correction near a click; for one outside n times that of the nth in a row
  double mixed = 0.2;    //!< cost besides, of the part of another candidate
  double renewed = 0.6;  //!< and of another candidate as a whole, once a click has said what it must not hold
  double correctionReach = 2.5;  //!< what is further from the click stays
  double makeshiftReach = 0.8;   //!< of a ball where nothing else serves
  double edgesLost = 0.4;        //!< cost of each octave by which the edges on the new surface are weaker
  double tooDeep = 2;            //!< cost of the log of how much deeper a change is than the click
  double against = 1;            //!< cost of the log of how much deeper one against the click's sense is than
  double againstDeep = 0.3;      //!< this
  double relabelZone = 2.5;      //!< cells so far from the surface are open
  double relabelBall = 0.7;      //!< around the click cells are what it says
  double relabelEdge = 1.5;      //!< noises: a jump that halves the pull between neighbours
  double relabelPrior = 0.2;     //!< pull of the cell's intensities against that of a neighbour
  double relabelClick = 0.5;     //!< share of the click's cells in the intensities inside
  double refineOuter = 2, refineInner = 1;  //!< cells: so near to a region's surface all are open
  double displaced = 1.25;                  //!< the surface moves so far at the click,
  double displacedWidth = 0.9;              //!< around it by a bell so wide in depths of the object's
  double otherPart = 1.2;     //!< deepest place, and as deep as this in them the click lies in another part
  double displacedEdge = 10;  //!< noises: a jump that makes a step of that way twice as long
  double slices = 2.5;        //!< times the finest spacing: cells so thick are slices;
  int fewSlices = 4;          //!< a stack of no more is nothing but ends
  double settled = 0.3;       //!< and a cell: so far it moves then to where edges and intensities are;
  double settledShape = 4;    //!< log of the odds for its side that a place as deep as the click has
  double settledNear = 2.5;   //!< widths of the bell: what of a boundary is further away stays
  double shallow = 0.5;       //!< of the deepest place: less deep than this nothing else is tried
  double core = 0.65;         //!< of the deepest place: a click outside beyond this says that most is wrong,
  double coreCells = 8;       //!< if it lies so many cells deep; another candidate costs nothing then
  double coreCut = 0.6;       //!< and a change near the click this besides
  double growth = 0.6;        //!< of its largest volume so far: what a click inside, but the first, may add,
  double growthApart = 2;     //!< and in another part so many times that, or a ball as deep as the click
  double left = 0.1;          //!< of the region as it is: what a click outside, but the first, leaves
  double relabelSure = 2.5;   //!< log of the odds that intensities may give at most
  std::size_t cavity = 14;    //!< cells: smaller cavities are noise; a ball of one and a half cells' radius
};

}  // namespace handlebody
