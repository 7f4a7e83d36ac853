#pragma once
// The surface of a region moved around a click. What a click says is wrong there is mostly a shell about as
// wide as the object, not a ball as deep as the click.

#include "core/object/region.h"

namespace handlebody {

//! How far a surface moves: a bell around a click.
struct Displacement {
  CellClick click;
  bool isInside = true;            //!< the click: the surface moves outwards
  double height = 0;               //!< mm: at the click
  double width = 0;                //!< mm: standard deviation of the bell
  std::vector<CellClick> against;  //!< clicks of the other kind: what is nearer to one of them stays
  double edge = 0;                 //!< intensities: a jump that makes a step twice as long; 0: none does
  double slices = 0;               //!< times the finest spacing: cells so thick are slices; 0: none are
  int fewSlices = 4;               //!< a stack of no more is nothing but ends
};

//! `region` with the cells that the surface of `from` passes over when it is displaced: they become as the
//! click is. How far it moves is measured along the shortest paths, and edges make these longer. Where the
//! bell is lower than half a cell nothing changes. For a click outside in a slice on the volume's border all
//! of the slice is as near to the outside as its rim: one slice too many is a common fault.
Region displaced(const WorkImage& work, const Region& from, Region region, const Displacement& d);

}  // namespace handlebody
