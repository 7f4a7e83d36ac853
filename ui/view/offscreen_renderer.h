#pragma once
// VTK drawing into a QImage through an OpenGL context without a window. Drawing through QOpenGLWidget costs
// the window's composition at every update, and Debian's VTK has no widgets for Qt 6.

#include <QImage>
#include <functional>
#include <memory>

class vtkGenericRenderWindowInteractor;
class vtkRenderer;

namespace handlebody::ui {

//! Lives on the GUI thread. Where there is no OpenGL 3.2, isValid() is false and nothing else may be called.
class OffscreenRenderer {
 public:
  OffscreenRenderer();
  ~OffscreenRenderer();

  bool isValid() const;
  vtkRenderer* renderer() const;
  //! Sizes and positions of its events are device pixels.
  vtkGenericRenderWindowInteractor* interactor() const;
  //! Called when the interactor wants the scene drawn again.
  void onRenderRequest(std::function<void()> request);
  //! `size` and the result in device pixels, at least 1 × 1; y down.
  QImage render(const QSize& size, double pixelRatio);

 private:
  struct Private;
  std::unique_ptr<Private> d_;
};

}  // namespace handlebody::ui
