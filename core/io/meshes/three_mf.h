#pragma once
// 3MF, for printers: meshes with names, colours and the unit. It is read by readMesh (mesh_io.h).

#include <string>
#include <vector>

#include "core/io/meshes/exported_object.h"
#include "core/io/meshes/mesh_io.h"

namespace handlebody {

//! True for .3mf (any case).
bool isThreeMfPath(const std::string& path);

//! Writes the objects by the core specification 1.3 of the 3MF Consortium, coordinates in mm with every digit
//! of single precision; `space` is said in a metadata of our own. The same objects give the same bytes. Whole
//! or not at all. Throws OutputError.
void writeThreeMf(const std::vector<ExportedObject>& objects, const std::string& path,
                  CoordinateSpace space = CoordinateSpace::lps);

}  // namespace handlebody
