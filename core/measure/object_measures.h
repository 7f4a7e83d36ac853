#pragma once
// What is measured of an object: what the report, `measure` and the window show. docs/measure.md has the
// definitions.

#include <optional>
#include <string>
#include <vector>

#include "core/finding.h"
#include "core/measure/intensity_inside.h"
#include "core/measure/shape_measures.h"

namespace handlebody {

struct ObjectMeasures {
  ShapeMeasures shape;
  std::optional<IntensityInside> intensity{};  //!< none without a volume
  std::vector<Finding> warnings{};             //!< sentences
};

//! `volume` may be null. Preconditions as shapeMeasures.
ObjectMeasures objectMeasures(const TriangleSoup& mesh, const Volume* volume);

}  // namespace handlebody
