#pragma once
// A step as a transaction: attempts are made until one leaves a valid mesh, each that does not is taken back
// exactly, and the places that failed rest before the next.

#include <functional>
#include <vector>

#include "core/evolution/step_check.h"

namespace handlebody {

//! What one attempt at a step leaves behind besides the mesh.
struct Attempt {
  std::vector<Event> events;
  std::vector<Trouble> troubles;       //!< places where nothing fitted: all is taken back, and they rest
  std::vector<int> moving;             //!< vertices that were asked to move
  std::vector<double> distances;       //!< how far, mm
  std::vector<unsigned char> touched;  //!< per vertex: its faces have moved or are new, and were looked at
};

//! Of a transaction: the mesh that it works on, and what its caller does.
struct StepWork {
  Mesh& mesh;
  TopologyNumbers topology;                    //!< of the mesh
  double longest = 0;                          //!< mm, of an edge
  std::function<Attempt()> attempt;            //!< changes the mesh
  std::function<void(const Trouble&)> restAt;  //!< before the next attempt
};

//! Keeps its memory from step to step.
class Transaction {
 public:
  //! The attempt that was kept. If kAttempts failed, the last of them, with its troubles, and the mesh as it
  //! was, bit for bit. Every place that failed has been handed to restAt. What an attempt throws passes
  //! through.
  Attempt run(const StepWork& work);
  //! mm³ enclosed by the mesh that is left.
  double volume() const { return volume_; }

  static constexpr int kAttempts = 8;

 private:
  Mesh before_;
  StepCheck check_;
  double volume_ = 0;
};

}  // namespace handlebody
