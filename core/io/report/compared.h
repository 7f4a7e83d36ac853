#pragma once
// Two objects to be compared, from files, and what `compare` found as JSON: what the command line and the
// Python module share.

#include <optional>
#include <string>
#include <vector>

#include "core/io/decoder_settings.h"
#include "core/solid/comparison.h"

namespace handlebody {

class LabelFile;

struct ComparedObject {
  std::string path;          //!< or what it is called; empty: not told
  std::optional<int> label;  //!< asked for, of a label map
  Solid solid;
};

struct ComparedPair {
  ComparedObject a, b;
  Comparison found;
  std::vector<Finding> warnings;  //!< sentences: of the files, then those of the comparison
};

//! A mesh, as it is called. Throws InputError if its triangles have no area.
ComparedObject comparedMesh(const std::string& name, TriangleSoup mesh);

//! What a label map holds. Throws InputError if a voxel is no whole number, and as solidOf.
ComparedObject comparedLabels(const std::string& name, const Volume& labels, std::optional<int> label);

//! A mesh or label map, by the ending of its path; a label of a file is meant as LabelFile does. Adds the
//! warnings of the file. Throws InputError.
ComparedObject readCompared(const std::string& path, std::optional<int> label, std::vector<Finding>& warnings,
                            const DecoderSettings& decoder = {});

//! The same of a label map that is open.
ComparedObject comparedLabels(const std::string& path, LabelFile& file, std::optional<int> label,
                              std::vector<Finding>& warnings);

//! Fills `found` and adds its warnings. Throws as compare.
void compare(ComparedPair& pair, const ComparisonOptions& how);

//! mm, of every vertex of A's surface from B's: negative inside of B, or without a sign where B has no
//! inside. Precondition: neither is empty.
std::vector<double> distancesFromReference(const ComparedPair& pair, int threads);
//! Writes the surface of A with them (.vtp). Throws as writeMeshWithValues.
void writeDistances(const ComparedPair& pair, const std::vector<double>& distances, const std::string& path);

//! Without what may name the patient: paths; warnings speak of A and B in their place.
ComparedPair anonymous(ComparedPair pair);

//! "version", "notice", "a", "b", "dice", "iou" … (docs/compare.md) as JSON text.
std::string comparisonJson(const ComparedPair& pair);

}  // namespace handlebody
