#include "ui/window/views/view_grid.h"

#include <QDataStream>
#include <QHBoxLayout>
#include <QIODevice>
#include <QPainter>
#include <QSplitter>
#include <QVBoxLayout>

#include "ui/view/slice_view.h"
#include "ui/view/surface_view.h"
#include "ui/window/views/view_frame.h"

namespace handlebody::ui {

namespace {

struct CellWords {
  Cell cell;
  const char* word;
};
constexpr std::array kWords{CellWords{Cell::axial, "axial"}, CellWords{Cell::surface, "3d"},
                            CellWords{Cell::coronal, "coronal"}, CellWords{Cell::sagittal, "sagittal"}};

QSplitter* makeSplitter(Qt::Orientation orientation, QWidget* parent) {
  auto* splitter = new QSplitter(orientation, parent);
  splitter->setChildrenCollapsible(false);
  splitter->setHandleWidth(4);
  return splitter;
}

}  // namespace

QString cellName(Cell cell) {
  switch (cell) {
    case Cell::axial:
      return ViewGrid::tr("Axial");
    case Cell::coronal:
      return ViewGrid::tr("Coronal");
    case Cell::sagittal:
      return ViewGrid::tr("Sagittal");
    default:
      return ViewGrid::tr("3D");
  }
}

std::optional<Cell> cellFromWord(const QString& word) {
  for (const CellWords& w : kWords)
    if (word == QLatin1String(w.word)) return w.cell;
  return std::nullopt;
}

ViewGrid::ViewGrid(Document& document, ViewState& state, QWidget* parent)
    : QWidget(parent),
      rows_(makeSplitter(Qt::Vertical, this)),
      top_(makeSplitter(Qt::Horizontal, rows_)),
      bottom_(makeSplitter(Qt::Horizontal, rows_)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(rows_);
  addSlice(Cell::axial, Plane::axial, document, state);
  surface_ = new SurfaceView(document, state, this);
  connect(surface_, &SurfaceView::maximiseRequested, this,
          [this] { maximise(maximised_ ? std::nullopt : std::optional(Cell::surface)); });
  addFrame(Cell::surface, surface_);
  addSlice(Cell::coronal, Plane::coronal, document, state);
  addSlice(Cell::sagittal, Plane::sagittal, document, state);
}

void ViewGrid::addSlice(Cell cell, Plane plane, Document& document, ViewState& state) {
  auto* view = new SliceView(plane, document, state, this);
  slices_[indexOf(plane)] = view;
  connect(view, &SliceView::maximiseRequested, this,
          [this, cell] { maximise(maximised_ ? std::nullopt : std::optional(cell)); });
  addFrame(cell, view);
}

void ViewGrid::addFrame(Cell cell, QWidget* view) {
  view->setAccessibleName(tr("%1 view").arg(cellName(cell)));
  auto* frame = new ViewFrame(cellName(cell), view, this);
  frames_[indexOf(cell)] = frame;
  (cell == Cell::axial || cell == Cell::surface ? top_ : bottom_)->addWidget(frame);
  connect(frame, &ViewFrame::maximiseRequested, this,
          [this, cell] { maximise(maximised_ ? std::nullopt : std::optional(cell)); });
}

SliceView& ViewGrid::slice(Plane plane) const { return *slices_[indexOf(plane)]; }

void ViewGrid::maximise(std::optional<Cell> cell) {
  if (cell == maximised_) return;
  maximised_ = cell;
  arrange();
  Q_EMIT maximisedChanged();
}

void ViewGrid::arrange() {
  const auto shown = [this](Cell cell) { return !maximised_ || *maximised_ == cell; };
  for (Cell cell : kCells) {
    frameOf(cell)->setVisible(shown(cell));
    static_cast<ViewFrame*>(frameOf(cell))->setMaximised(maximised_.has_value());
  }
  top_->setVisible(shown(Cell::axial) || shown(Cell::surface));
  bottom_->setVisible(shown(Cell::coronal) || shown(Cell::sagittal));
}

void ViewGrid::resetViews() {
  for (SliceView* view : slices_) view->resetZoom();
  surface_->resetCamera();
}

QWidget* ViewGrid::viewOf(Cell cell) const {
  switch (cell) {
    case Cell::axial:
      return slices_[indexOf(Plane::axial)];
    case Cell::coronal:
      return slices_[indexOf(Plane::coronal)];
    case Cell::sagittal:
      return slices_[indexOf(Plane::sagittal)];
    default:
      return surface_;
  }
}

//! Also while one of them fills the grid. What a view only shows when it is ready is waited for.
QImage ViewGrid::pictureOfAll() {
  const auto arrangeFor = [this](std::optional<Cell> cell) {
    maximised_ = cell;
    arrange();
    for (QSplitter* splitter : {rows_, top_, bottom_}) splitter->refresh();  // now, not with the next events
  };
  const std::optional<Cell> before = maximised_;
  if (before) arrangeFor(std::nullopt);
  QImage image = grab().toImage();  // lays the views out; of it is kept what lies between them
  QPainter painter(&image);
  for (Cell cell : kCells) painter.drawImage(viewOf(cell)->mapTo(this, QPoint(0, 0)), picture(cell));
  painter.end();
  if (before) arrangeFor(before);
  return image;
}

QImage ViewGrid::picture(std::optional<Cell> cell) const {
  if (!cell) return const_cast<ViewGrid*>(this)->pictureOfAll();
  switch (*cell) {
    case Cell::surface:
      return surface_->picture();
    case Cell::axial:
      return slice(Plane::axial).picture();
    case Cell::coronal:
      return slice(Plane::coronal).picture();
    default:
      return slice(Plane::sagittal).picture();
  }
}

QByteArray ViewGrid::saveLayout() const {
  QByteArray layout;
  QDataStream stream(&layout, QIODevice::WriteOnly);
  stream << rows_->saveState() << top_->saveState() << bottom_->saveState()
         << (maximised_ ? static_cast<int>(*maximised_) : -1);
  return layout;
}

void ViewGrid::restoreLayout(const QByteArray& layout) {
  QDataStream stream(layout);
  QByteArray rows, top, bottom;
  int cell = -1;
  stream >> rows >> top >> bottom >> cell;
  if (stream.status() != QDataStream::Ok) return;
  rows_->restoreState(rows);
  top_->restoreState(top);
  bottom_->restoreState(bottom);
  const bool known = cell >= 0 && cell < static_cast<int>(kCells.size());
  maximise(known ? std::optional(static_cast<Cell>(cell)) : std::nullopt);
}

}  // namespace handlebody::ui
