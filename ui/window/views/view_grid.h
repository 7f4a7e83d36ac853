#pragma once
// The four views, 2×2, or one of them alone.

#include <QImage>
#include <QWidget>
#include <array>
#include <optional>

#include "core/enum_index.h"
#include "ui/view/view_state.h"

class QSplitter;

namespace handlebody::ui {

class Document;
class SliceView;
class SurfaceView;

//! The places of the 2×2 grid, row by row (as in 3D Slicer's four-up layout).
enum class Cell { axial, surface, coronal, sagittal };
inline constexpr std::array kCells{Cell::axial, Cell::surface, Cell::coronal, Cell::sagittal};

//! "Axial", "3D" …, translated.
QString cellName(Cell cell);
//! "axial", "3d" …: on the command line.
std::optional<Cell> cellFromWord(const QString& word);

class ViewGrid : public QWidget {
  Q_OBJECT

 public:
  ViewGrid(Document& document, ViewState& state, QWidget* parent = nullptr);

  SliceView& slice(Plane plane) const;
  SurfaceView& surface() const { return *surface_; }
  //! Which view fills the grid; none: all four are shown.
  std::optional<Cell> maximised() const { return maximised_; }
  void maximise(std::optional<Cell> cell);
  //! Whole slices, the camera at its start.
  void resetViews();
  //! What a view shows, or all four (none), in device pixels.
  QImage picture(std::optional<Cell> cell) const;
  //! Sizes of the views and which one fills the grid.
  QByteArray saveLayout() const;
  void restoreLayout(const QByteArray& layout);

 Q_SIGNALS:
  void maximisedChanged();

 private:
  QWidget* frameOf(Cell cell) const { return frames_[indexOf(cell)]; }
  void addSlice(Cell cell, Plane plane, Document& document, ViewState& state);
  void addFrame(Cell cell, QWidget* view);
  void arrange();
  QWidget* viewOf(Cell cell) const;
  QImage pictureOfAll();

  std::array<SliceView*, 3> slices_{};
  SurfaceView* surface_ = nullptr;
  std::array<QWidget*, 4> frames_{};
  QSplitter *rows_, *top_, *bottom_;
  std::optional<Cell> maximised_;
};

}  // namespace handlebody::ui
