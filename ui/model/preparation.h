#pragma once
// The contour before its first step: automatic parameters, smoothing, seed spheres. Made in the background
// whenever seeds or parameters change, so that the automatic values can be shown and a growth begins at once.

#include <QString>
#include <functional>
#include <memory>
#include <vector>

#include "core/evolution/active_contour.h"
#include "ui/model/background.h"

namespace handlebody::ui {

struct Prepared {
  std::shared_ptr<const ActiveContour> contour;  //!< null if it failed
  QString error;
  double seconds = 0;
};

class Preparation {
 public:
  //! `done` is called on the worker thread. A request that has not begun is dropped for a newer one.
  void request(const Volume& volume, const std::vector<Seed>& seeds, const Parameters& parameters,
               std::function<void(Prepared)> done);

 private:
  Background background_;
};

}  // namespace handlebody::ui
