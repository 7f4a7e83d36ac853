#pragma once
// glTF 2.0, for viewers of scenes: meshes with names and colours.

#include <string>
#include <vector>

#include "core/io/meshes/exported_object.h"

namespace handlebody {

//! True for .gltf (any case).
bool isGltfPath(const std::string& path);

//! Writes the objects by VTK, a node and a material each, data within the file. As the format has it, in
//! metres with y up: x to the patient's left, y to the head, z to the front; single precision. The same
//! objects give the same bytes. Whole or not at all. Throws OutputError.
void writeGltf(const std::vector<ExportedObject>& objects, const std::string& path);

}  // namespace handlebody
