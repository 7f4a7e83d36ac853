#pragma once
// What files of several segments say of each: name, colour, coded term. DICOM's are read in dicom/.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/io/meshes/exported_object.h"

namespace handlebody {

//! What a file says of one of its labels; what it does not say is empty.
struct FileLabel {
  std::string name{};
  std::optional<Colour> colour{};
  std::string term{};      //!< name of one of terms(): that with the code of the type
  SegmentSource source{};  //!< a terminology only if it is not wholly that term's

  void take(Terminology said);  //!< term and terminology
  //! It has a look of its own: a colour, or a term that brings one.
  bool hasLook() const { return colour || !term.empty(); }
};

//! By the numbers of the labels: the values of the voxels or, in a further layer of a .seg.nrrd, those and
//! the layer's shift.
using FileLabels = std::map<int, FileLabel>;

//! The name of the term whose type has this code; empty if the list has none.
std::string termOfCode(const std::string& scheme, const std::string& value);

//! `label` called, coloured and termed as the file says; what it does not say stays, and a name that a format
//! could not hold is none. A term without a colour brings its own. What is not in our list is kept as it is.
ObjectLabel labelledAs(const FileLabel& said, ObjectLabel label);

//! The segments of 3D Slicer's .seg.nrrd, by the keys in its header. Empty for any other file.
FileLabels readSlicerLabels(const std::string& path);

//! By how much the number of a label of each of its layers is larger than the value of the voxels: layers may
//! have the same values for different segments. 0 for the first; the rest as far as segments name layers.
std::vector<int> slicerLayerShifts(const std::string& path);

}  // namespace handlebody
