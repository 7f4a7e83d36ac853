#include "ui/view/slice_view.h"

#include <QKeyEvent>
#include <QLineF>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QVector>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "core/mesh/plane_section.h"
#include "ui/model/document.h"
#include "ui/view/brush_picture.h"
#include "ui/view/held_voxels.h"
#include "ui/view/measure_overlay.h"
#include "ui/view/other_outlines.h"
#include "ui/view/overlay.h"
#include "ui/view/pinned_surface.h"
#include "ui/view/significant_digits.h"
#include "ui/view/slice_image.h"
#include "ui/view/slice_interaction.h"
#include "ui/view/slice_measuring.h"
#include "ui/view/wall_overlay.h"

namespace handlebody::ui {
namespace {

const QColor kOutline(0xff, 0xb8, 0x1a);
constexpr double kOutlineWidth = 1.6, kUnsupportedWidth = 2.4, kLoopWidth = 3;  // pixels
constexpr double kPinnedWidth = 3.2, kPartlyWidth = 1.2;                        // pixels

//! The views whose planes the vertical and the horizontal line of a crosshair are.
std::pair<Plane, Plane> crossedPlanes(Plane plane) {
  return plane == Plane::axial     ? std::pair(Plane::sagittal, Plane::coronal)
         : plane == Plane::coronal ? std::pair(Plane::sagittal, Plane::axial)
                                   : std::pair(Plane::coronal, Plane::axial);
}

//! What the picture of the voxels depends on.
struct ImageKey {
  const void* voxels = nullptr;
  QSizeF size;
  QPointF origin, unit;  // of the voxel index, on the screen
  int slice = -1;
  double pixelRatio = 0, window = 0, level = 0;
  ColourMap map = ColourMap::grey;
  std::optional<Tint> tint;
  std::shared_ptr<const HeldVoxels::Mask> tinted;
  bool operator==(const ImageKey&) const = default;
};

//! What stands out of the outline.
struct Marks {
  bool unsupported = false, pinned = false;
};

}  // namespace

struct SliceView::Private {
  Private(Plane p, Document& d, ViewState& s, std::function<void()> repaint)
      : plane(p), document(d), state(s), interaction(d, s, geometry), inObject(std::move(repaint)) {
    interaction.setOutline([this]() -> const auto& { return outline(); });
  }

  const QImage& image(double pixelRatio);
  std::shared_ptr<const HeldVoxels::Mask> heldVoxels();
  const std::vector<std::array<Vec3, 2>>& outline();
  void forgetVolume();
  void paint(QPainter& painter, double pixelRatio, bool focused);
  Marks paintOutline(QPainter& painter);
  void paintBrushWork(QPainter& painter) const;
  void paintMarkedLoops(QPainter& painter) const;
  void paintLegend(QPainter& painter, const Marks& marks) const;
  void paintCrosshair(QPainter& painter) const;
  void paintTexts(QPainter& painter) const;

  const Plane plane;
  Document& document;
  ViewState& state;
  SliceGeometry geometry;
  SliceInteraction interaction;

  SliceImage slice;
  ImageKey shownKey;
  QImage shownImage;
  std::shared_ptr<const MeshSnapshot> cutMesh;
  int cutSlice = -1;
  std::vector<std::array<Vec3, 2>> section;  // of cutMesh with cutSlice, mm
  std::vector<int> sectionFaces;             // triangles of its segments
  OtherOutlines others;
  WallOverlay walls;
  PinnedSurface pinned;
  std::optional<QPointF> pointer;  // where the mouse is, if it is in the view
  HeldVoxels inObject;
};

const QImage& SliceView::Private::image(double pixelRatio) {
  const std::optional<Tint>& tint = state.tint();
  const std::shared_ptr<const HeldVoxels::Mask> tinted = heldVoxels();
  const ImageKey key{document.volume().voxels.get(),
                     geometry.size(),
                     geometry.toScreen(Vec3::Zero()),
                     geometry.toScreen(Vec3::Ones()),
                     geometry.slice(),
                     pixelRatio,
                     state.window(),
                     state.level(),
                     state.colourMap(),
                     tint,
                     tinted};
  if (!(key == shownKey)) {
    const auto range = tint && !tint->object ? std::optional(tint->range) : std::nullopt;
    shownImage = slice.render(document.volume(), geometry, pixelRatio,
                              {{state.window(), state.level()}, state.colourMap(), range, tinted});
  }
  shownKey = key;
  return shownImage;
}

//! Null as long as they are being found, and where the tint does not need them.
std::shared_ptr<const HeldVoxels::Mask> SliceView::Private::heldVoxels() {
  const std::optional<Tint>& tint = state.tint();
  if (tint && tint->object && tint->object->volume().grid().size == geometry.grid().size)
    return inObject.of(tint->object, geometry.axes(), geometry.slice());
  inObject.forget();
  return nullptr;
}

const std::vector<std::array<Vec3, 2>>& SliceView::Private::outline() {
  const std::shared_ptr<const MeshSnapshot> mesh = document.snapshot();
  if (mesh == cutMesh && geometry.slice() == cutSlice) return section;
  section.clear();
  if (mesh)
    planeSection(mesh->mesh.points, mesh->mesh.triangles, geometry.normal(), offsetOf(geometry), section,
                 &sectionFaces);
  cutMesh = mesh;
  cutSlice = geometry.slice();
  return section;
}

//! At once: a view that is not seen paints nothing that would take the place of what it holds.
void SliceView::Private::forgetVolume() {
  slice = {};
  shownKey = {};
  inObject.forget();
  cutMesh.reset();
  cutSlice = -1;
  others = {};
  walls = {};
  pinned = {};
}

Marks SliceView::Private::paintOutline(QPainter& painter) {
  QVector<QLineF> lines, unsupported, held, partly;
  const auto& segments = outline();
  const bool marks = state.meshColouring() == MeshColouring::support && cutMesh &&
                     !document.isShownOutOfDate() && cutMesh->support.covers(cutMesh->mesh.triangles.size());
  const bool isPinned = state.showsConstraints() && cutMesh;
  const auto& parts =
      pinned.of(cutMesh, isPinned ? pinsWithStroke(document, state.brush()) : std::vector<Pin>{});
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const auto face = static_cast<std::size_t>(sectionFaces[i]);
    const QLineF line(geometry.worldToScreen(segments[i][0]), geometry.worldToScreen(segments[i][1]));
    (marks && cutMesh->support.faces[face] == FaceSupport::none ? unsupported : lines).append(line);
    if (!parts.empty() && parts[face] != PinnedSurface::none)
      (parts[face] == PinnedSurface::whole ? held : partly).append(line);
  }
  paintSegments(painter, lines, activeColour(document, kOutline), kOutlineWidth);
  paintSegments(painter, unsupported, unsupportedColour(), kUnsupportedWidth);
  paintSegments(painter, partly, pinColour(), kPartlyWidth);
  paintSegments(painter, held, pinColour(), kPinnedWidth);
  return {!unsupported.isEmpty(), !held.isEmpty() || !partly.isEmpty()};
}

//! Where they lie within a slice of this one.
void SliceView::Private::paintMarkedLoops(QPainter& painter) const {
  const double reach = geometry.grid().spacing[geometry.axes().normal] / 2;
  for (const MarkedLoop& loop : state.markedLoops()) {
    QVector<QLineF> lines;
    for (std::size_t i = 0; i < loop.points.size(); ++i) {
      const Vec3 &from = loop.points[i], &to = loop.points[(i + 1) % loop.points.size()];
      if (std::abs(geometry.distance((from + to) / 2)) <= reach)
        lines.append(QLineF(geometry.worldToScreen(from), geometry.worldToScreen(to)));
    }
    paintSegments(painter, lines, loopColour(loop.kind), kLoopWidth);
  }
}

void SliceView::Private::paintCrosshair(QPainter& painter) const {
  constexpr double kGap = 9;  // what is aimed at stays free
  const QPointF c = geometry.worldToScreen(state.crosshair());
  const auto [vertical, horizontal] = crossedPlanes(plane);
  const auto line = [&](const QPointF& from, const QPointF& to, Plane crossed) {
    QColor colour = planeColour(crossed);
    colour.setAlpha(200);
    painter.setPen(QPen(colour, 1));
    painter.drawLine(from, to);
  };
  line({c.x(), 0}, {c.x(), c.y() - kGap}, vertical);
  line({c.x(), c.y() + kGap}, {c.x(), geometry.size().height()}, vertical);
  line({0, c.y()}, {c.x() - kGap, c.y()}, horizontal);
  line({c.x() + kGap, c.y()}, {geometry.size().width(), c.y()}, horizontal);
}

void SliceView::Private::paintTexts(QPainter& painter) const {
  const double width = geometry.size().width(), height = geometry.size().height();
  const QFont title = overlayFont(1.05, true), letter = overlayFont(1.15, true), small = overlayFont(0.95);
  const double line = QFontMetricsF(small).height();
  const SliceAxes& axes = geometry.axes();
  const auto edge = [&](char text, double x, double y, Qt::Alignment flags) {
    paintText(painter, {x, y}, flags, QString(QChar::fromLatin1(text)), letter);
  };
  edge(axes.left, kOverlayMargin, height / 2, Qt::AlignLeft | Qt::AlignVCenter);
  edge(axes.right, width - kOverlayMargin, height / 2, Qt::AlignRight | Qt::AlignVCenter);
  edge(axes.top, width / 2, kOverlayMargin, Qt::AlignHCenter | Qt::AlignTop);
  edge(axes.bottom, width / 2, height - kOverlayMargin, Qt::AlignHCenter | Qt::AlignBottom);
  paintText(painter, {kOverlayMargin, kOverlayMargin}, Qt::AlignLeft | Qt::AlignTop,
            isOblique(geometry.grid()) ? tr("%1, oblique").arg(planeName(plane)) : planeName(plane), title,
            planeColour(plane).lighter(120));
  double y = kOverlayMargin + 1.2 * line;
  for (const QString& text : slicePlace(geometry, plane, state.crosshair())) {
    paintText(painter, {kOverlayMargin, y}, Qt::AlignLeft | Qt::AlignTop, text, small);
    y += 1.05 * line;
  }
  QLocale plain;
  plain.setNumberOptions(QLocale::OmitGroupSeparator);
  const QString window =
      tr("W %1  L %2").arg(significant(state.window(), 4, plain), significant(state.level(), 4, plain));
  paintText(painter, {kOverlayMargin, height - kOverlayMargin}, Qt::AlignLeft | Qt::AlignBottom, window,
            small, state.windowLevelTool() ? QColor(0xff, 0xd5, 0x4f) : QColor(0xb8, 0xbf, 0xc7));
}

//! Below the place of the slice.
void SliceView::Private::paintLegend(QPainter& painter, const Marks& marks) const {
  const double line = QFontMetricsF(overlayFont(0.95)).height();
  const auto lines = slicePlace(geometry, plane, state.crosshair()).size();
  double y = kOverlayMargin + (1.75 + 1.05 * static_cast<double>(lines)) * line;
  const auto key = [&](const QColor& colour, const QString& text) {
    paintKey(painter, {kOverlayMargin, y}, colour, text);
    y += 1.2 * line;
  };
  if (marks.unsupported) key(unsupportedColour(), tr("no edge in the image"));
  if (marks.pinned) key(pinColour(), tr("pinned"));
}

//! What is being pulled in this slice, and the brush under the mouse.
void SliceView::Private::paintBrushWork(QPainter& painter) const {
  const Brush& brush = state.brush();
  const double radius = brush.radius() / geometry.mmPerPixel();
  if (const auto& pull = brush.pull()) {
    const double reach = geometry.grid().spacing[geometry.axes().normal] / 2;
    const bool isLine = brush.mode() == Brush::Mode::cut;  // it lies in one slice
    if (std::abs(geometry.distance(pull->from)) > reach) return;
    if (isLine && std::abs(geometry.distance(pull->to)) > reach) return;
    const QPointF from = geometry.worldToScreen(pull->from), to = geometry.worldToScreen(pull->to);
    return isLine ? paintCut(painter, from, to) : paintPull(painter, from, to, radius);
  }
  if (!pointer || !brush.isOn() || brush.mode() == Brush::Mode::cut || state.windowLevelTool()) return;
  const std::optional<Vec3> place = interaction.brushPlace(*pointer);
  if (!place) return;
  const QPointF at = geometry.worldToScreen(*place);
  paintBrush(painter, at, radius, brush.mode(), false);
  if (brush.mode() == Brush::Mode::pull) paintGrip(painter, at);
}

void SliceView::Private::paint(QPainter& painter, double pixelRatio, bool focused) {
  const QSizeF size = geometry.size();
  if (!document.hasVolume()) {
    painter.fillRect(QRectF({0, 0}, size), Qt::black);
    paintHint(painter, size, tr("Open a volume: Ctrl+O,\nor drop a file here"));
  } else {
    painter.drawImage(QPointF(0, 0), image(pixelRatio));
    painter.setRenderHint(QPainter::Antialiasing);
    if (isActiveVisible(document) && state.showsConstraints())
      walls.paint(painter, geometry, pixelRatio, document.shownWalls(), state.brush());
    paintCrosshair(painter);
    others.paint(painter, document, geometry);
    const Marks marks = isActiveVisible(document) ? paintOutline(painter) : Marks{};
    if (isActiveVisible(document)) paintMarkedLoops(painter);
    paintSeeds(painter, interaction.circles(), document.selectedSeed());
    paintMeasurements(painter, geometry, document, state.measure());
    paintBrushWork(painter);
    paintScaleBar(painter, size, geometry.mmPerPixel());
    paintTexts(painter);
    paintLegend(painter, marks);
  }
  paintFrame(painter, size, planeColour(plane), focused);
}

SliceView::SliceView(Plane plane, Document& document, ViewState& state, QWidget* parent)
    : QWidget(parent), d_(std::make_unique<Private>(plane, document, state, [this] {
        QMetaObject::invokeMethod(
            this, [this] { update(); }, Qt::QueuedConnection);
      })) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setAccessibleName(tr("%1 slice").arg(planeName(plane)));
  setAccessibleDescription(tr(
      "Arrows and Page Up or Down move the crosshair, Return adds a seed, Shift and Return a click outside "
      "of the object, W changes window and level. B and E turn the brush for walls on and off, with Shift "
      "they paint and erase at the crosshair; L pins with it, Shift and L unpins, M smooths, U pulls."));
  const auto repaint = [this] { update(); };
  connect(&document, &Document::opened, this, &SliceView::startVolume);
  connect(&document, &Document::frameShown, this, [this] {
    d_->slice = {};
    d_->shownKey = {};
    update();
    tellHoverAgain();
  });
  connect(&document, &Document::activeObjectChanged, this, [this] { d_->interaction.leaveObject(); });
  connect(&document, &Document::seedsChanged, this, repaint);
  connect(&document, &Document::selectedSeedChanged, this, repaint);
  connect(&document, &Document::resolvedChanged, this, repaint);
  connect(&document, &Document::snapshotChanged, this, repaint);
  connect(&document, &Document::objectsChanged, this, repaint);
  connect(&document, &Document::constraintsChanged, this, repaint);
  connect(&state, &ViewState::markedLoopsChanged, this, repaint);
  connect(&state.brush(), &Brush::strokeChanged, this, repaint);
  const auto follow = [this] {
    update();
    if (d_->document.hasVolume()) setCursor(d_->interaction.cursorAt(mapFromGlobal(QCursor::pos())));
  };
  connect(&state, &ViewState::changed, this, follow);
  connect(&state.brush(), &Brush::changed, this, follow);
  connect(&state, &ViewState::crosshairChanged, this, &SliceView::followCrosshair);
  installEventFilter(new SliceMeasuring(document, state, d_->geometry, *this));
  startVolume();
}

SliceView::~SliceView() = default;

Plane SliceView::plane() const { return d_->plane; }

void SliceView::resetZoom() {
  d_->geometry.fit();
  update();
  tellHoverAgain();
}

QImage SliceView::picture() {
  QImage image((QSizeF(size()) * devicePixelRatioF()).toSize(), QImage::Format_RGB32);
  image.setDevicePixelRatio(devicePixelRatioF());
  d_->heldVoxels();
  d_->inObject.finish();
  QPainter painter(&image);
  const auto pointer = std::exchange(d_->pointer, std::nullopt);  // of the slice, not of the mouse
  d_->paint(painter, devicePixelRatioF(), false);
  d_->pointer = pointer;
  return image;
}

QSize SliceView::minimumSizeHint() const { return {160, 120}; }
QSize SliceView::sizeHint() const { return {480, 360}; }

void SliceView::startVolume() {
  d_->interaction.cancel();
  d_->forgetVolume();
  d_->geometry = d_->document.hasVolume() ? SliceGeometry(d_->document.volume().grid, d_->plane, size())
                                          : SliceGeometry();
  d_->geometry.resize(size());
  if (d_->document.hasVolume())
    followCrosshair();
  else
    unsetCursor();
  update();
  tellHoverAgain();
}

void SliceView::followCrosshair() {
  if (!d_->document.hasVolume()) return;
  d_->geometry.setSlice(d_->geometry.nearestSlice(d_->state.crosshair()));
  update();
  tellHoverAgain();
}

void SliceView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  d_->paint(painter, devicePixelRatioF(), hasFocus());
}

void SliceView::resizeEvent(QResizeEvent*) {
  d_->geometry.resize(size());
  tellHoverAgain();
}

// --- events go to the interaction; what it does not want goes to the parent ---

void SliceView::mousePressEvent(QMouseEvent* event) {
  if (!d_->document.hasVolume() || !d_->interaction.press(*event)) return QWidget::mousePressEvent(event);
  setCursor(d_->interaction.cursorAt(event->position()));
  update();
}

void SliceView::mouseMoveEvent(QMouseEvent* event) {
  if (!d_->document.hasVolume()) return;
  d_->pointer = event->position();
  if (d_->interaction.move(*event) || d_->state.brush().isOn()) update();
  setCursor(d_->interaction.cursorAt(event->position()));
  tellHoverAgain();
}

void SliceView::mouseReleaseEvent(QMouseEvent* event) {
  if (!d_->document.hasVolume() || !d_->interaction.release(*event)) return QWidget::mouseReleaseEvent(event);
  setCursor(d_->interaction.cursorAt(event->position()));
}

//! Two quick dabs of a tool are two.
void SliceView::mouseDoubleClickEvent(QMouseEvent* event) {
  const bool isTools = d_->state.brush().isOn() || d_->state.windowLevelTool();
  if (event->button() == Qt::LeftButton && !isTools)
    Q_EMIT maximiseRequested();
  else
    mousePressEvent(event);
}

void SliceView::wheelEvent(QWheelEvent* event) {
  if (!d_->document.hasVolume() || !d_->interaction.wheel(*event)) return QWidget::wheelEvent(event);
  event->accept();
  d_->pointer = event->position();
  update();
  tellHoverAgain();
}

bool SliceView::event(QEvent* event) {
  const bool isAsked = event->type() == QEvent::ShortcutOverride && d_->document.hasVolume();
  if (!isAsked || !SliceInteraction::isOwnKey(*static_cast<QKeyEvent*>(event))) return QWidget::event(event);
  event->accept();  // the release of a shortcut would not be told
  return true;
}

void SliceView::keyPressEvent(QKeyEvent* event) {
  if (!d_->document.hasVolume() || !d_->interaction.keyPress(*event)) QWidget::keyPressEvent(event);
}

void SliceView::keyReleaseEvent(QKeyEvent* event) {
  if (!d_->document.hasVolume() || !d_->interaction.keyRelease(*event)) QWidget::keyReleaseEvent(event);
}

void SliceView::leaveEvent(QEvent*) {
  d_->pointer.reset();
  if (d_->state.brush().isOn()) update();
  Q_EMIT left();
}
void SliceView::focusInEvent(QFocusEvent*) { update(); }
void SliceView::focusOutEvent(QFocusEvent*) { update(); }

//! What lies there may have changed under a mouse that rests.
void SliceView::tellHoverAgain() {
  if (!d_->pointer) return;
  if (d_->document.hasVolume())
    tellHover(*d_->pointer);
  else
    Q_EMIT left();
}

void SliceView::tellHover(const QPointF& pixel) {
  const Volume& volume = d_->document.volume();
  const Vec3 index = d_->geometry.toIndex(pixel);
  if (!volume.grid.contains(index)) {
    Q_EMIT left();
    return;
  }
  std::size_t at = 0;
  for (int a = 2; a >= 0; --a) {
    // By the volume's own size: of one that was just opened the geometry may not know yet.
    const long voxel = std::clamp(std::lround(index[a]), 0L, volume.grid.size[a] - 1L);
    at = at * static_cast<std::size_t>(volume.grid.size[a]) + static_cast<std::size_t>(voxel);
  }
  const double intensity =
      visitVoxels(volume, [&](const auto* voxels) { return static_cast<double>(voxels[at]); });
  Q_EMIT hovered(volume.grid.toWorld(index), index, intensity);
}

}  // namespace handlebody::ui
