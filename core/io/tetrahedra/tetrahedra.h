#pragma once
// Tetrahedra for a finite-element solver, by gmsh or TetGen where one of them is installed as a program.

#include <array>
#include <string>
#include <vector>

#include "core/io/meshes/exported_object.h"
#include "core/io/meshes/mesh_io.h"

namespace handlebody {

//! True for .msh .vtu .inp (any case).
bool isTetrahedraPath(const std::string& path);

//! Empty if gmsh or TetGen is found in the folders of PATH; else why there are no tetrahedra, as the end of a
//! sentence.
std::string tetrahedraFault();

//! Throws OutputError, without the name of a file, if there is no folder for the files of these programs.
void requireTemporaryFolder();

struct Tetrahedra {
  std::vector<Vec3> points;               //!< mm LPS
  std::vector<std::array<int, 4>> cells;  //!< indices, of positive volume (right-handed)
  std::vector<int> object;                //!< per cell, index of the object that it fills
};

inline constexpr double kMesherSeconds = 1800;

//! Fills every object between its surface and its cavities, without a change of the surface. Each is given to
//! the programs as a process of its own, to TetGen if gmsh fails; a program that takes longer than
//! `mesherSeconds` is killed with what it has started. What comes back is looked at: all cells have a volume,
//! and together that of the object. Throws OutputError, with the object's name and what the program said,
//! without the name of a file; Cancelled (cancellation.h).
Tetrahedra fillWithTetrahedra(const std::vector<ExportedObject>& objects,
                              double mesherSeconds = kMesherSeconds);

//! Writes by extension: .msh (gmsh's format 2.2), .vtu (VTK), .inp (Abaqus, C3D4), in mm, objects by name and
//! label; whole or not at all. Throws OutputError.
void writeTetrahedra(const Tetrahedra& tetrahedra, const std::vector<ExportedObject>& objects,
                     const std::string& path, CoordinateSpace space);

}  // namespace handlebody
