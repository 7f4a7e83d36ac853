#pragma once
// Internal: the programs that make tetrahedra, run as processes. No code of them is linked.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/mesh/mesh.h"

namespace handlebody {

//! A closed surface by body: the components of a mesh that bound it.
struct MesherInput {
  TriangleSoup mesh;
  std::vector<int> component;            //!< per triangle
  std::vector<std::vector<int>> bodies;  //!< components of each body, the outer one first
  std::vector<Vec3> holes;               //!< a point in every cavity
};

struct MesherOutput {
  std::vector<Vec3> points;
  std::vector<std::array<int, 4>> cells;  //!< none if it failed
  std::string fault;                      //!< then: what the program said, without a full stop
};

//! The path of a program in the folders of PATH.
std::optional<std::string> findProgram(const std::string& name);

//! Each ends the program after so many seconds by the clock. Throws Cancelled (cancellation.h), with the
//! program ended. Temporary files are removed in any case.
MesherOutput runGmsh(const std::string& program, const MesherInput& input, double seconds);
MesherOutput runTetgen(const std::string& program, const MesherInput& input, double seconds);

}  // namespace handlebody
