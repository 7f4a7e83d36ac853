#pragma once
// Internal: what the mouse does in the 3D view.

#include <vtkInteractorStyleTrackballCamera.h>

namespace handlebody::ui {

//! Left rotates, right and wheel zoom, middle or Shift+left pans, as in 3D Slicer. Keys do nothing here.
class SurfaceStyle : public vtkInteractorStyleTrackballCamera {
 public:
  static SurfaceStyle* New();
  vtkTypeMacro(SurfaceStyle, vtkInteractorStyleTrackballCamera);

  // Unlike the base class none of these takes the focus of VTK's own event handling.
  void OnLeftButtonDown() override;
  void OnMiddleButtonDown() override;
  void OnRightButtonDown() override;
  void OnChar() override {}

 protected:
  SurfaceStyle() = default;

 private:
  bool findRenderer();
};

}  // namespace handlebody::ui
