#pragma once
// Which cells near a surface belong to the object: once a click inside has said that it is missed there, and
// next to a surface that was found by bounds of intensity.

#include "core/object/corrections.h"

namespace handlebody {

//! What a relabelling goes by.
struct Relabelling {
  CellClick click;                         //!< that was on the wrong side of the surface
  double depth = 0;                        //!< mm: of the click behind the surface
  double reach = 0;                        //!< mm: cells further from the click stay
  double noise = 0;                        //!< standard deviation, intensities
  std::vector<CellClick> inside, outside;  //!< all clicks that have been taken in
  bool isInside = true;                    //!< the click
};

//! For a click inside. Cells outside about as near to the surface as the click are open. They become inside
//! or outside as their neighbours do, the less across edges, and as intensities inside (the click's among
//! them) and further outside speak for: a random walker with priors, after Grady (2005), "Multilabel random
//! walker image segmentation using prior models".
Region relabelled(const WorkImage& work, const Region& region, const Relabelling& r,
                  const ObjectPolicy& policy);

//! A region whose surface a click has moved, with all of its surface where edges and intensities next to it
//! are, by the same walk: those around the click speak for its side, and a place that lies far within the
//! moved surface, or far off it, hardly changes its side. So the surface neither stays in the open where a
//! click has pushed it past an edge, nor gives up what the click has won.
Region settled(const WorkImage& work, const Region& region, const Relabelling& r, const ObjectPolicy& policy);

//! The region with its surface where the edges next to it are, by the same walk: only cells next to the
//! surface are open. The opening and the bounds of intensity that found it put the surface a little off.
Region refined(const WorkImage& work, const Region& region, double noise, const ObjectPolicy& policy);

}  // namespace handlebody
