#pragma once
// Components that are to go.

#include <functional>
#include <memory>
#include <vector>

#include "core/mesh/smaller_components.h"
#include "core/surgery/event.h"

namespace handlebody {

//! The step that is being made.
struct CollapsingStep {
  MeshMotion motion;
  double edgeLength = 0;                    //!< mm
  bool mayShrink = false;                   //!< parts of the surface may give ground
  bool hasEvents = false;                   //!< its topology has been changed already, or folds were smoothed
  bool hasSurgery = false;                  //!< faces were taken out and made
  int iteration = 0;                        //!< for the events
  TopologyNumbers topology;                 //!< of the mesh
  std::function<bool(const Vec3&)> isKept;  //!< asked for the first vertex of each that has collapsed
  //! Of a vertex: its component is kept, too, unless it has turned; and it may turn without getting small.
  //! None: no vertex is.
  std::function<bool(int)> isPinned{};
};

struct ErasedComponents {
  std::vector<Event> events;
  //! All of the mesh, if they were looked for and none was deleted.
  std::shared_ptr<const Components> parts;
};

//! Deletes the components that have collapsed, and those that have turned inside out while they did: a cavity
//! would grow on as a body in the body, a body as a cavity of all space, without end. Knows when there can be
//! none.
class CollapsedComponents {
 public:
  //! Deletes them, one after the other. One that has turned is never kept: no mesh may hold it.
  ErasedComponents erase(Mesh& mesh, const CollapsingStep& step);
  //! After a change of what moves the surface.
  void forget() { lookAt_ = 0, smaller_.forget(); }
  //! After an attempt that was taken back.
  void forgetPlaces() { smaller_.forget(); }

 private:
  bool mustLook(const CollapsingStep& step) const;
  bool isWhole(const Mesh& mesh, const CollapsingStep& step);
  void know(const Components& parts, const CollapsingStep& step);
  bool mayHaveTurned(const Components& parts, const CollapsingStep& step);

  std::ptrdiff_t cavities_ = 0;  // components of negative volume, when last looked at
  int lookAt_ = 0;               // iteration before which none can collapse
  int lookAtLargest_ = 0;        // and the largest cannot
  SmallerComponents smaller_;    // the others, unless one of them is kept though it has collapsed
};

}  // namespace handlebody
