#pragma once
// Names of files that hold one object each.

#include <string>
#include <vector>

namespace handlebody {

//! PATH_NAME.EXT for each object: its name goes before `extension` (".seg.nrrd"), with which the path ends.
//! What file systems refuse in names becomes an underscore; of names that are the same then, upper and lower
//! case apart, the later ones get a number. Precondition: the path ends with the extension, case apart.
std::vector<std::string> objectPaths(const std::string& path, const std::string& extension,
                                     const std::vector<std::string>& names);

}  // namespace handlebody
