#include <vtkObject.h>

#include "core/io/meshes/mesh_files.h"

namespace handlebody {

VtkSilence::VtkSilence() : before_(vtkObject::GetGlobalWarningDisplay() != 0) {
  vtkObject::GlobalWarningDisplayOff();
}

VtkSilence::~VtkSilence() { vtkObject::SetGlobalWarningDisplay(before_ ? 1 : 0); }

std::string spaceMark(CoordinateSpace space) {
  return space == CoordinateSpace::lps ? "SPACE=LPS" : "SPACE=RAS";
}

CoordinateSpace spaceIn(const std::string& text) {
  return text.find("SPACE=RAS") != std::string::npos ? CoordinateSpace::ras : CoordinateSpace::lps;
}

}  // namespace handlebody
