#pragma once
// The numbers of the Tune step: names, units, limits, and what they do, in the user's words.

#include "ui/window/widgets/value_field.h"

namespace handlebody::ui {

ValueSpec smoothingSpec();
ValueSpec edgeLengthSpec();
ValueSpec balloonSpec();
ValueSpec curvatureSpec();
ValueSpec maxIterationsSpec();

}  // namespace handlebody::ui
