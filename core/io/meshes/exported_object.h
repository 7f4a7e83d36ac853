#pragma once
// What an object is called when it leaves the program: name, colour, label value and coded term.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/io/meshes/terminology.h"
#include "core/mesh/mesh.h"

namespace handlebody {

inline constexpr const char* kSnomed = "SCT";  //!< designator of SNOMED CT in DICOM

//! A coded concept of SNOMED CT.
struct Code {
  std::string value;
  std::string meaning;  //!< 64 characters at most
};

using Colour = std::array<std::uint8_t, 3>;  //!< sRGB

//! What an object is: its segmented property category and type, as DICOM and 3D Slicer have them.
struct Term {
  std::string name;  //!< what chooses it, "spinal-cord"
  Code category, type;
  Colour colour;  //!< recommended for display
};

//! The built-in list. Codes, meanings and categories are those of DICOM's context groups 7151 ff. (PS3.16) as
//! dcmqi and 3D Slicer list them, colours those of 3D Slicer's anatomy list where it has one.
const std::vector<Term>& terms();
//! Nothing if the list has none of that name.
const Term* termFromName(const std::string& name);
//! "tissue": says least.
const Term& plainTerm();

//! How an object is named in what is written of it.
struct ObjectLabel {
  std::string name = "Object";   //!< as checkObjectName
  Colour colour{128, 174, 128};  //!< 3D Slicer's for a tissue
  int value = 1;                 //!< of its voxels in a label map, 1 … 65535
  std::string term = "tissue";   //!< name of one of terms(); the nearest, where the source says more
  SegmentSource source{};        //!< what its file says of it besides

  friend bool operator==(const ObjectLabel&, const ObjectLabel&) = default;
};

//! The codes of one of the list.
Terminology terminologyOf(const Term& term);
//! What the object is, as it is written: its file's word, or else that of its term.
Terminology terminologyOf(const ObjectLabel& label);

//! Colours that are told apart at a glance, next to each other in this order: Okabe and Ito's, for the
//! colour-blind too.
const std::vector<Colour>& distinctColours();
//! The smallest label value, from 1 on, that none of these is. Precondition: there is one.
int freeLabelValue(const std::vector<int>& taken);

//! Empty if `name` can stand in every format: 1 to 64 characters of UTF-8, none of them a control character
//! or one that XML has not (U+FFFE, U+FFFF), quote ("), backslash, or bar, tilde or caret (which separate in
//! 3D Slicer's and DICOM's texts). Else why not, as the end of a sentence.
std::string objectNameFault(const std::string& name);

inline constexpr int kLargestLabel = 65535;

//! One object of those that are written together.
struct ExportedObject {
  ObjectLabel label;
  TriangleSoup mesh;  //!< mm LPS, closed, not intersecting those of the others
};

}  // namespace handlebody
