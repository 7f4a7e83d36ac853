#pragma once
// Components and topology numbers of a closed mesh.

#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "core/mesh/mesh.h"

namespace handlebody {

//! The connected components of a mesh.
struct Components {
  std::vector<int> ofVertex;             //!< component per vertex slot; -1 for deleted vertices
  std::vector<int> vertices;             //!< number of vertices per component
  std::vector<int> faces;                //!< number of faces per component
  std::vector<double> volume;            //!< signed volume per component, mm³: negative for a cavity
  std::vector<Eigen::AlignedBox3d> box;  //!< bounding box per component, mm
  std::vector<double> extent;            //!< its longest side, mm

  int count() const { return static_cast<int>(vertices.size()); }
};

//! Topology of the whole mesh.
struct TopologyNumbers {
  int components = 0;
  int euler = 0;  //!< V - E + F
  int genus = 0;  //!< sum over the components
  bool operator==(const TopologyNumbers&) const = default;
};

//! Number of components, Euler number, genus of a closed mesh.
TopologyNumbers topologyNumbers(const Mesh& mesh);

//! Number of components: cheaper than to label them. The mesh may be open, but every vertex has a face. The
//! components of the vertices in `joined` count as one.
int countComponents(const Mesh& mesh, std::span<const int> joined = {});

//! Labels components in the order of their lowest vertex slot.
Components findComponents(const Mesh& mesh);

//! Signed volume of all components together, mm³: cavities count negative.
double signedVolume(const Mesh& mesh);

//! Removes every vertex and face of the component that v belongs to.
void deleteComponent(Mesh& mesh, int v);

}  // namespace handlebody
