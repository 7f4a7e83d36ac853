#pragma once
// What is told of a contour in the report of its run: what the command line and the Python module share.

#include "core/evolution/active_contour.h"
#include "core/io/report/result.h"

namespace handlebody {

//! Of the contour as it was made: parameters as used.
void tellBeginning(const ActiveContour& contour, RunReport& report);

//! The objects that the clicks of a contour may mean. Where a boundary is beyond doubt they have not been
//! looked for, which takes as long as a growth, and are told only if they are `asked` for. Throws Cancelled.
void tellCandidates(const ActiveContour& contour, bool asked, RunReport& report);

//! Of the contour as it is now: iterations, why it stopped, what the constraints hold.
void tellState(const ActiveContour& contour, RunReport& report);

//! Throws UsageError if the growth has ended and a veto, a pin or an edit of a later iteration never came.
//! Where it was stopped and could go on, addWarnings tells them.
void requireNothingWaiting(const ActiveContour& contour);

//! The surface as it is written. Throws SeedError if nothing is left of it, and as certifiedForExport.
CertifiedMesh grownMesh(const ActiveContour& contour);

//! Adds what a user should look at before trusting `mesh`, which is that of grownMesh: the warnings and the
//! part of the surface without an edge. The report holds everything else already.
void addWarnings(const ActiveContour& contour, const TriangleSoup& mesh, RunReport& report);

}  // namespace handlebody
