#pragma once
// What is told of a contour in the report of its run: what the command line and the Python module share.

#include <memory>
#include <thread>

#include "core/evolution/active_contour.h"
#include "core/io/report/result.h"

namespace handlebody {

//! Of the contour as it was made: parameters as used.
void tellBeginning(const ActiveContour& contour, RunReport& report);

//! Looks for the objects that the clicks of a contour may mean, while its surface grows. Cancelled with the
//! work that makes it, whose CancelScope outlives it.
class CandidateSearch {
 public:
  explicit CandidateSearch(const ActiveContour& contour);
  //! Waits for them. Throws what the search threw, Cancelled.
  void tell(RunReport& report);

 private:
  std::shared_ptr<const AskedChoices> choices_;
  std::jthread thread_;
};

//! Of the contour as it is now: iterations, why it stopped, what the constraints hold.
void tellState(const ActiveContour& contour, RunReport& report);

//! Throws UsageError if the growth has ended and a veto, a pin or an edit of a later iteration never came.
void requireNothingWaiting(const ActiveContour& contour);

//! The surface as it is written. Throws SeedError if nothing is left of it, and as certifiedForExport.
CertifiedMesh grownMesh(const ActiveContour& contour);

//! Adds what a user should look at before trusting `mesh`, which is that of grownMesh: the warnings and the
//! part of the surface without an edge. The report holds everything else already.
void addWarnings(const ActiveContour& contour, const TriangleSoup& mesh, RunReport& report);

}  // namespace handlebody
