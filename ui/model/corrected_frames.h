#pragma once
// Frames to which a surface was carried and that are, or were, corrected.

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "core/volume/volume.h"

namespace handlebody::ui {

class ObjectWork;

//! What was done there can be undone as long as it is known.
struct CorrectedFrame {
  int frame = 0;
  std::shared_ptr<ObjectWork> object;
  Volume volume;  //!< of the frame
};

//! While one is being corrected the object of the grown frame and its volume are put away here. Owned by the
//! document; GUI thread.
class CorrectedFrames {
 public:
  //! Null: not known.
  const CorrectedFrame* at(int frame) const {
    return find([&](const CorrectedFrame& c) { return c.frame == frame; });
  }
  const CorrectedFrame* of(const std::shared_ptr<ObjectWork>& object) const {
    return find([&](const CorrectedFrame& c) { return c.object == object; });
  }
  void add(CorrectedFrame corrected) { known_.push_back(std::move(corrected)); }
  //! Of none is known what was done there. What is put away stays so.
  void forget() { known_.clear(); }

  //! The same of those that start from another surface now: beyond a frame, seen from the grown one.
  void forgetBeyond(int frame, int grown) {
    std::erase_if(known_,
                  [&](const CorrectedFrame& c) { return frame > grown ? c.frame > frame : c.frame < frame; });
  }

  //! One is being corrected.
  bool isOpen() const { return home_ != nullptr; }
  //! Of the grown frame, while another one is corrected; else null.
  const std::shared_ptr<ObjectWork>& home() const { return home_; }
  //! Voxels of the grown frame, where another one is corrected; else `shown`, which are those then.
  const Volume& grownVolume(const Volume& shown) const { return isOpen() ? homeVolume_ : shown; }
  //! Nothing if something is put away already: one frame is left for another one.
  void putAway(std::shared_ptr<ObjectWork> object, const Volume& volume) {
    if (isOpen()) return;
    home_ = std::move(object);
    homeVolume_ = volume;
  }
  //! What was put away. Precondition: isOpen().
  std::pair<std::shared_ptr<ObjectWork>, Volume> takeBack() {
    return {std::exchange(home_, nullptr), std::exchange(homeVolume_, {})};
  }

 private:
  template <typename Is>
  const CorrectedFrame* find(Is&& is) const {
    const auto found = std::find_if(known_.begin(), known_.end(), is);
    return found == known_.end() ? nullptr : &*found;
  }

  std::vector<CorrectedFrame> known_;
  std::shared_ptr<ObjectWork> home_;
  Volume homeVolume_;
};

}  // namespace handlebody::ui
