#pragma once
// Internal: slices that are shifted or unevenly spaced, onto their stack's even grid.

#include "core/io/dicom/dicom_geometry.h"
#include "core/io/dicom/dicom_scan.h"

namespace handlebody {

//! `from`: the slices of one time point, one after another, of type `type`; `to`: the voxels of stack.grid.
//! Bilinear within slices, linear between them; what no slice covers gets the smallest value of all.
void resampleStack(const DicomStack& stack, Component type, const void* from, void* to,
                   const DecodingProgress& progress);

}  // namespace handlebody
