#pragma once
// Components and topology numbers of a closed mesh.

#include <vector>

#include "core/mesh/mesh.h"

namespace handlebody {

//! The connected components of a mesh.
struct Components {
  std::vector<int> ofVertex;   //!< component per vertex slot; -1 for deleted vertices
  std::vector<int> vertices;   //!< number of vertices per component
  std::vector<int> faces;      //!< number of faces per component
  std::vector<double> volume;  //!< signed volume per component, mm³: negative for a cavity
  std::vector<double> extent;  //!< longest side of the bounding box per component, mm

  int count() const { return static_cast<int>(vertices.size()); }
};

//! Labels components in the order of their lowest vertex slot.
Components findComponents(const Mesh& mesh);

//! Signed volume of all components together, mm³: cavities count negative.
double signedVolume(const Mesh& mesh);

//! Removes every vertex and face of the component that v belongs to.
void deleteComponent(Mesh& mesh, int v);

}  // namespace handlebody
