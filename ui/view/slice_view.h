#pragma once
// One slice of the volume with crosshair, outline of the mesh, seeds, letters and a scale bar.

#include <QWidget>
#include <memory>

#include "ui/view/view_state.h"

namespace handlebody::ui {

class Document;

//! Needs no OpenGL. Mouse: left crosshair, or the seed under it (centre: move, rim: radius); middle or
//! Shift+left pan; right or Ctrl+wheel zoom; wheel slice (Shift: five). Keys, with the focus: arrows and
//! PgUp/PgDn one voxel (Shift: five), Return adds a seed, Backspace or Delete removes the selected one, + and
//! - change its radius by half a voxel, W window and level (short press: until the next; held down: as long).
//! While the brush is on, left does what it is for (brush.h) and Ctrl+wheel changes its radius.
class SliceView : public QWidget {
  Q_OBJECT

 public:
  SliceView(Plane plane, Document& document, ViewState& state, QWidget* parent = nullptr);
  ~SliceView() override;

  Plane plane() const;
  //! The whole slice in the view, centred.
  void resetZoom();
  //! Picture of the view as it is shown, in device pixels, without the sign of the keyboard's focus.
  QImage picture();

  QSize minimumSizeHint() const override;
  QSize sizeHint() const override;

 Q_SIGNALS:
  //! Under the mouse: world mm, continuous voxel index, intensity of the voxel there; for the status bar.
  void hovered(const handlebody::Vec3& world, const handlebody::Vec3& index, double intensity);
  void left();               //!< the mouse left the view or the volume
  void maximiseRequested();  //!< double click

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  void startVolume();
  void followCrosshair();
  void tellHoverAgain();
  void tellHover(const QPointF& pixel);

  struct Private;
  std::unique_ptr<Private> d_;
};

}  // namespace handlebody::ui
