#pragma once
// The contour before its first step: automatic parameters, smoothing, seed spheres. Made in the background
// whenever seeds or parameters change, so that the automatic values can be shown and a growth begins at once.

#include <QString>
#include <atomic>
#include <functional>
#include <memory>
#include <vector>

#include "core/evolution/active_contour.h"
#include "ui/model/background.h"
#include "ui/model/finished_mesh.h"

namespace handlebody::ui {

struct Prepared {
  std::shared_ptr<const ActiveContour> contour;  //!< null if it failed
  QString error;
  double seconds = 0;
};

//! A surface that a growth starts from in place of spheres at its seeds: that of the frame beside.
struct CarriedStart {
  TriangleSoup mesh;
  bool holdTopology = true;
};

//! One at a time; calls come from one thread.
class Preparation {
 public:
  ~Preparation();
  //! `done` is called on the worker thread. Of several requests only the newest is answered; what is under
  //! way for an older one is given up. `walls` are the objects among the request's, which are made first.
  //! `start`: null where it grows from its seeds.
  void request(const Volume& volume, const Request& request, const std::vector<FinishedWall>& walls,
               const std::shared_ptr<const CarriedStart>& start, std::function<void(Prepared)> done);
  void cancel();
  //! Lets go of what was prepared lately: its images are large.
  void forget();

 private:
  //! What was prepared lately for the open volume: the choice of the image takes nearly all of the time, and
  //! undo comes back to it.
  struct Known {
    Volume volume;
    std::shared_ptr<const ActiveContour> contour;
  };
  Prepared prepare(const Volume& volume, const Request& request, const CarriedStart* surface);
  ActiveContour make(const Volume& volume, const Request& request);

  std::deque<Known> known_;               // the worker's
  std::shared_ptr<ObjectMemory> memory_;  // likewise: of clicks in the open volume
  std::shared_ptr<std::atomic<bool>> cancelled_ = std::make_shared<std::atomic<bool>>(false);
  Background background_;  // last: its job uses the others
};

}  // namespace handlebody::ui
