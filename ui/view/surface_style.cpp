#include "ui/view/surface_style.h"

#include <vtkObjectFactory.h>
#include <vtkRenderWindowInteractor.h>

namespace handlebody::ui {

vtkStandardNewMacro(SurfaceStyle);

bool SurfaceStyle::findRenderer() {
  FindPokedRenderer(Interactor->GetEventPosition()[0], Interactor->GetEventPosition()[1]);
  return CurrentRenderer != nullptr;
}

void SurfaceStyle::OnLeftButtonDown() {
  if (!findRenderer()) return;
  if (Interactor->GetShiftKey() != 0)
    StartPan();
  else
    StartRotate();
}

void SurfaceStyle::OnMiddleButtonDown() {
  if (findRenderer()) StartPan();
}

void SurfaceStyle::OnRightButtonDown() {
  if (findRenderer()) StartDolly();
}

}  // namespace handlebody::ui
