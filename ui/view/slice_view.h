#pragma once
// One slice of the volume with crosshair, outline of the mesh, seeds, letters and a scale bar.

#include <QWidget>
#include <memory>

#include "ui/view/view_state.h"

namespace handlebody::ui {

class Document;

class SliceView : public QWidget {
  Q_OBJECT

 public:
  SliceView(Plane plane, Document& document, ViewState& state, QWidget* parent = nullptr);
  ~SliceView() override;

  Plane plane() const;
  //! The whole slice in the view, centred.
  void resetZoom();
  //! Picture of the view as it is shown, in device pixels.
  QImage picture();

 Q_SIGNALS:
  //! Under the mouse: world mm, continuous voxel index, intensity; for the status bar.
  void hovered(const handlebody::Vec3& world, const handlebody::Vec3& index, double intensity);
  void left();
  void maximiseRequested();  //!< double click

 private:
  struct Private;
  std::unique_ptr<Private> d_;
};

}  // namespace handlebody::ui
