#pragma once
// Which parts of the shown surface the pins hold, as the views draw them.

#include <memory>
#include <vector>

#include "core/evolution/constraints.h"

namespace handlebody::ui {

class Brush;
class Document;
struct MeshSnapshot;

//! The pins of the shown surface as they would be with the stroke that is being drawn. Of those that a stroke
//! adds some may hold nothing of their own.
std::vector<Pin> pinsWithStroke(const Document& document, const Brush& brush);

//! Of one surface at a time; worked out only where it, or the pins, have changed, and a stroke adds to it.
class PinnedSurface {
 public:
  enum Part : unsigned char { none, partly, whole };  //!< of a triangle's corners: none, some, all

  //! One per triangle; empty: nothing is held.
  const std::vector<Part>& of(const std::shared_ptr<const MeshSnapshot>& surface,
                              const std::vector<Pin>& pins);

 private:
  std::shared_ptr<const MeshSnapshot> surface_;
  std::vector<Pin> pins_;
  std::vector<bool> vertices_;
  std::vector<Part> parts_;
};

}  // namespace handlebody::ui
