#include "ui/window/tune/tune_specs.h"

#include "core/evolution/parameters.h"
#include "ui/model/translate.h"

namespace handlebody::ui {

ValueSpec smoothingSpec() {
  return {tr("Smoothing"),
          tr("mm"),
          tr("Standard deviation of the Gaussian that smooths the image ahead. More for more speckle; 0 for "
             "none."),
          0,
          100,
          0.1,
          2};
}

ValueSpec edgeLengthSpec() {
  return {tr("Edge length"),
          tr("mm"),
          tr("Length that the edges of the mesh are kept near. Shorter shows finer detail and takes longer."),
          0.01,
          100,
          0.1,
          2};
}

ValueSpec balloonSpec() {
  return {tr("Balloon"),
          {},
          tr("Weight of the force that drives the surface outward. Less keeps it from leaking."),
          0.01,
          100,
          0.1,
          2,
          Parameters{}.balloon};
}

ValueSpec curvatureSpec() {
  return {tr("Curvature"),
          {},
          tr("Weight of smoothness. More closes narrow leaks and rounds the surface off."),
          0,
          100,
          0.1,
          2,
          Parameters{}.curvature};
}

ValueSpec maxIterationsSpec() {
  return {tr("Iteration limit"),
          {},
          tr("The growth stops after so many iterations, finished or not."),
          1,
          1'000'000,
          100,
          0,
          Parameters{}.maxIterations};
}

}  // namespace handlebody::ui
