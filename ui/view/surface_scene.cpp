#include "ui/view/surface_scene.h"

#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTexture.h>

#include <algorithm>
#include <cmath>
#include <list>

#include "core/enum_index.h"
#include "core/mesh/shapes.h"
#include "ui/model/document.h"
#include "ui/view/overlay.h"
#include "ui/view/seed_circles.h"
#include "ui/view/triangle_actor.h"

namespace handlebody::ui {
namespace {

const QColor kMaterial(0xed, 0xbd, 0x70), kSeedBall(0x4f, 0xc3, 0xf7), kHandleColour(0x3d, 0xc9, 0x7c);
const QColor kColliding(0xf0, 0x3e, 0x3e), kAroundColour(0xb9, 0xc3, 0xd0);

constexpr double kThroughAll = -66000;  // units of depth, of 65,000 that there are
constexpr double kWallOpacity = 0.5;
constexpr double kSliceOpacity = 0.55;  // the part of the mesh behind a slice is seen through it

//! Lines and points of one colour.
struct LineActor {
  LineActor() {
    mapper->SetInputData(data);
    mapper->ScalarVisibilityOff();
    // In front of the triangles whose edges they are.
    mapper->SetResolveCoincidentTopologyToPolygonOffset();
    mapper->SetRelativeCoincidentTopologyLineOffsetParameters(-4, -200);
    mapper->SetRelativeCoincidentTopologyPointOffsetParameter(-200);
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
  }
  void setColour(double r, double g, double b) { actor->GetProperty()->SetColor(r, g, b); }
  void set(const std::vector<std::vector<Vec3>>& lists, bool closedLines) {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> lines, dots;
    for (const auto& list : lists) {
      const vtkIdType first = points->GetNumberOfPoints();
      for (const Vec3& p : list) points->InsertNextPoint(p.data());
      const vtkIdType count = points->GetNumberOfPoints() - first;
      for (vtkIdType i = 0; i < count; ++i) {
        const vtkIdType ends[2] = {first + i, first + (i + 1) % count};
        if (closedLines) lines->InsertNextCell(2, ends);
        dots->InsertNextCell(1, ends);
      }
    }
    data->SetPoints(points);
    data->SetLines(closedLines ? lines.Get() : nullptr);
    data->SetVerts(closedLines ? nullptr : dots.Get());
  }
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkActor> actor;
};

//! A picture on a parallelogram.
struct SliceActor {
  SliceActor() {
    vtkNew<vtkPoints> points;
    points->SetNumberOfPoints(4);
    vtkNew<vtkFloatArray> coordinates;
    coordinates->SetNumberOfComponents(2);
    // VTK's rows run up, the picture's down: its first row is given to VTK first and so lies at t = 0.
    for (const auto& [s, t] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}}) coordinates->InsertNextTuple2(s, t);
    const vtkIdType corners[4] = {0, 1, 2, 3};
    vtkNew<vtkCellArray> quad;
    quad->InsertNextCell(4, corners);
    data->SetPoints(points);
    data->SetPolys(quad);
    data->GetPointData()->SetTCoords(coordinates);
    mapper->SetInputData(data);
    texture->SetInputData(image);
    texture->InterpolateOn();
    texture->EdgeClampOn();
    actor->SetMapper(mapper);
    actor->SetTexture(texture);
    actor->GetProperty()->LightingOff();
    actor->GetProperty()->SetOpacity(kSliceOpacity);
    actor->ForceOpaqueOn();  // drawn last among the opaque: VTK's own translucent pass costs 8 ms in software
    actor->VisibilityOff();
  }
  void set(const QImage& picture, const std::array<Vec3, 3>& corners) {
    const QImage rgb = picture.convertToFormat(QImage::Format_RGB888);
    image->SetDimensions(rgb.width(), rgb.height(), 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    for (int y = 0; y < rgb.height(); ++y)
      std::copy_n(rgb.constScanLine(y), 3 * rgb.width(),
                  static_cast<unsigned char*>(image->GetScalarPointer(0, y, 0)));
    image->Modified();
    const Vec3 opposite = corners[1] + corners[2] - corners[0];
    vtkPoints* points = data->GetPoints();
    points->SetPoint(0, corners[0].data());
    points->SetPoint(1, corners[1].data());
    points->SetPoint(2, opposite.data());
    points->SetPoint(3, corners[2].data());
    points->Modified();
    data->Modified();
    filled = true;
  }
  bool filled = false;
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkImageData> image;
  vtkNew<vtkTexture> texture;
  vtkNew<vtkActor> actor;
};

//! The diagonals of a cube in the ball, so that no direction of sight shows fewer than two lines.
void addCross(std::vector<std::vector<Vec3>>& lines, const Vec3& centre, double radius) {
  for (const Vec3& towards : {Vec3(1, 1, 1), Vec3(-1, 1, 1), Vec3(1, -1, 1), Vec3(1, 1, -1)}) {
    const Vec3 arm = radius * towards.normalized();
    lines.push_back({centre - arm, centre + arm});
  }
}

void addLight(vtkRenderer* renderer, const Vec3& from, double intensity) {
  vtkNew<vtkLight> light;
  light->SetLightTypeToCameraLight();
  light->SetPosition(from.x(), from.y(), from.z());
  light->SetFocalPoint(0, 0, 0);
  light->SetIntensity(intensity);
  renderer->AddLight(light);
}

}  // namespace

QColor plainMaterial() { return kMaterial; }

QColor faceStateColour(int state) {
  static const QColor colours[] = {{0xf2, 0xa8, 0x3b}, {0x8f, 0xa6, 0xbf}, kHandleColour, kColliding};
  return colours[state];
}

QColor faceSupportColour(FaceSupport support) {
  return support == FaceSupport::none   ? unsupportedColour()
         : support == FaceSupport::edge ? kMaterial
                                        : kAroundColour;
}

struct SurfaceScene::Private {
  struct Shown {
    TriangleActor actor;
    std::shared_ptr<const MeshSnapshot> mesh;
  };

  void colour(const MeshSnapshot& snapshot, MeshColouring colouring, const QColor& material);
  void updateVisibility();

  vtkRenderer* renderer = nullptr;
  TriangleActor mesh, pinned, seeds, around, red, handle, walls;
  LineActor outside, loops, lambda, box;
  std::array<LineActor, 2> marked;  // by MarkedLoop::Kind
  std::array<SliceActor, 3> slices;
  std::list<Shown> others;
  bool hasMesh = false, hasPinned = false, hasSeeds = false, hasWalls = false, hasOutside = false,
       hasVolume = false, slicesOn = false;
  EventStage stage = EventStage::none;
};

SurfaceScene::SurfaceScene(vtkRenderer* renderer) : d_(std::make_unique<Private>()) {
  d_->renderer = renderer;
  renderer->GradientBackgroundOn();
  renderer->SetBackground(0.065, 0.072, 0.085);
  renderer->SetBackground2(0.135, 0.150, 0.175);
  renderer->AutomaticLightCreationOff();
  addLight(renderer, Vec3(-0.45, 0.65, 0.9), 0.85);
  addLight(renderer, Vec3(0.85, -0.1, 0.5), 0.30);
  addLight(renderer, Vec3(-0.1, -0.9, 0.4), 0.22);
  renderer->GetActiveCamera()->ParallelProjectionOn();
  for (TriangleActor* part : {&d_->mesh, &d_->pinned, &d_->seeds, &d_->around, &d_->red, &d_->handle})
    renderer->AddActor(part->actor());
  for (LineActor* part : {&d_->outside, &d_->loops, &d_->lambda, &d_->box}) renderer->AddActor(part->actor);
  for (LineActor& part : d_->marked) {
    renderer->AddActor(part.actor);
    part.actor->GetProperty()->RenderLinesAsTubesOn();
    // In front of whatever lies nearer to the eye.
    part.mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0, kThroughAll);
  }
  for (const auto kind : {MarkedLoop::Kind::handle, MarkedLoop::Kind::tunnel}) {
    const QColor colour = loopColour(kind);
    d_->marked[indexOf(kind)].setColour(colour.redF(), colour.greenF(), colour.blueF());
  }
  for (const Plane plane : {Plane::axial, Plane::coronal, Plane::sagittal})  // drawn in this order
    renderer->AddActor(d_->slices[indexOf(plane)].actor);
  renderer->AddActor(d_->walls.actor());  // after all that is seen through them
  d_->walls.setColour(wallColour());
  d_->walls.actor()->GetProperty()->SetOpacity(kWallOpacity);
  d_->walls.actor()->ForceOpaqueOn();  // as the slices
  for (TriangleActor* part : {&d_->around, &d_->red, &d_->handle}) part->setEdges(true);
  for (TriangleActor* part : {&d_->pinned, &d_->red, &d_->handle}) part->setInFront();
  d_->seeds.setColour(kSeedBall);
  const QColor outside = outsideColour();
  d_->outside.setColour(outside.redF(), outside.greenF(), outside.blueF());
  d_->outside.actor->GetProperty()->RenderLinesAsTubesOn();
  d_->around.setColour(kAroundColour);
  d_->red.setColour(kColliding);
  d_->handle.setColour(kHandleColour);
  d_->loops.setColour(1, 0.75, 0.15);
  d_->loops.actor->GetProperty()->RenderLinesAsTubesOn();  // core OpenGL has no wide lines
  d_->lambda.setColour(1, 1, 1);
  d_->box.setColour(0.42, 0.46, 0.52);
  d_->updateVisibility();
}

SurfaceScene::~SurfaceScene() = default;

void SurfaceScene::Private::updateVisibility() {
  const bool staged = stage != EventStage::none;
  const bool refined = stage == EventStage::refined;
  const bool open = stage == EventStage::opened || stage == EventStage::handle;
  mesh.actor()->SetVisibility(hasMesh && !staged);
  pinned.actor()->SetVisibility(hasMesh && hasPinned && !staged);
  seeds.actor()->SetVisibility(hasSeeds && !hasMesh && !staged);
  outside.actor->SetVisibility(hasOutside && !hasMesh && !staged);
  for (Shown& other : others) other.actor.actor()->SetVisibility(!staged);
  around.actor()->SetVisibility(staged);
  red.actor()->SetVisibility(stage == EventStage::colliding);
  lambda.actor->SetVisibility(stage == EventStage::colliding || refined);
  loops.actor->SetVisibility(open || refined);
  handle.actor()->SetVisibility(stage == EventStage::handle);
  walls.actor()->SetVisibility(hasWalls && !staged);
  for (LineActor& part : marked) part.actor->SetVisibility(part.data->GetNumberOfLines() > 0 && !staged);
  box.actor->SetVisibility(hasVolume && !staged);
  for (SliceActor& slice : slices) slice.actor->SetVisibility(slice.filled && slicesOn && !staged);
}

void SurfaceScene::Private::colour(const MeshSnapshot& snapshot, MeshColouring colouring,
                                   const QColor& material) {
  const std::size_t faces = snapshot.mesh.triangles.size();
  if (colouring == MeshColouring::state && snapshot.states.size() == faces)
    mesh.setColours({faceStateColour(0), faceStateColour(1), faceStateColour(2), faceStateColour(3)},
                    reinterpret_cast<const unsigned char*>(snapshot.states.data()), faces);
  else if (colouring == MeshColouring::support && !snapshot.support.covers(faces))
    mesh.setColour(kAroundColour);  // what was not compared has neither edge nor none
  else if (colouring == MeshColouring::support)
    mesh.setColours({faceSupportColour(FaceSupport::edge), faceSupportColour(FaceSupport::none),
                     faceSupportColour(FaceSupport::border)},
                    reinterpret_cast<const unsigned char*>(snapshot.support.faces.data()), faces);
  else
    mesh.setColour(material);
}

void SurfaceScene::setMesh(const MeshSnapshot* mesh, MeshColouring colouring, const QColor& material) {
  d_->hasMesh = mesh != nullptr && !mesh->mesh.triangles.empty();
  if (d_->hasMesh) {
    d_->mesh.setMesh(mesh->mesh, colouring != MeshColouring::edges);
    d_->mesh.setEdges(colouring == MeshColouring::edges);
    d_->colour(*mesh, colouring, material);
  }
  d_->updateVisibility();
}

void SurfaceScene::colourFaces(const std::vector<QColor>& palette,
                               const std::vector<unsigned char>& entries) {
  if (d_->hasMesh) d_->mesh.setColours(palette, entries.data(), entries.size());
}

void SurfaceScene::setPinned(const TriangleSoup& mesh, const std::vector<PinnedSurface::Part>& parts) {
  const QColor& whole = pinColour();
  const QColor partly((whole.red() + kMaterial.red()) / 2, (whole.green() + kMaterial.green()) / 2,
                      (whole.blue() + kMaterial.blue()) / 2);
  TriangleSoup held{mesh.points, {}};
  std::vector<unsigned char> colours;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i] == PinnedSurface::none) continue;
    held.triangles.push_back(mesh.triangles[i]);
    colours.push_back(parts[i] == PinnedSurface::whole ? 1 : 0);
  }
  d_->hasPinned = !colours.empty();
  if (d_->hasPinned) {
    d_->pinned.setMesh(held, true);
    d_->pinned.setColours({partly, whole}, colours.data(), colours.size());
  }
  d_->updateVisibility();
}

void SurfaceScene::setOthers(const std::vector<Other>& others) {
  while (d_->others.size() > others.size()) {
    d_->renderer->RemoveActor(d_->others.back().actor.actor());
    d_->others.pop_back();
  }
  while (d_->others.size() < others.size()) d_->renderer->AddActor(d_->others.emplace_back().actor.actor());
  auto shown = d_->others.begin();
  for (const Other& other : others) {
    if (shown->mesh != other.mesh) shown->actor.setMesh(other.mesh->mesh, true);
    shown->mesh = other.mesh;
    shown->actor.setColour(other.colour);
    ++shown;
  }
  d_->updateVisibility();
}

void SurfaceScene::setSeeds(const std::vector<Seed>& seeds) {
  TriangleSoup all;
  std::vector<std::vector<Vec3>> crosses;
  for (const Seed& seed : seeds) {
    const double radius = std::max(1e-3, seed.radius.value_or(1));
    if (seed.background) {
      addCross(crosses, seed.centre, radius);
      continue;
    }
    const TriangleSoup ball = icosphere(seed.centre, radius, radius / 5);
    const int first = static_cast<int>(all.points.size());
    all.points.insert(all.points.end(), ball.points.begin(), ball.points.end());
    for (const Triangle& t : ball.triangles)
      all.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  d_->hasSeeds = !all.triangles.empty();
  if (d_->hasSeeds) d_->seeds.setMesh(all, true);
  d_->hasOutside = !crosses.empty();
  if (d_->hasOutside) d_->outside.set(crosses, true);
  d_->updateVisibility();
}

void SurfaceScene::setWalls(const TriangleSoup& walls) {
  d_->hasWalls = !walls.triangles.empty();
  if (d_->hasWalls) d_->walls.setMesh(walls, true);
  d_->updateVisibility();
}

void SurfaceScene::setLoops(const std::vector<MarkedLoop>& loops) {
  for (const auto kind : {MarkedLoop::Kind::handle, MarkedLoop::Kind::tunnel}) {
    std::vector<std::vector<Vec3>> lines;
    for (const MarkedLoop& loop : loops)
      if (loop.kind == kind) lines.push_back(loop.points);
    d_->marked[indexOf(kind)].set(lines, true);
  }
  d_->updateVisibility();
}

void SurfaceScene::setVolume(const Grid* grid) {
  d_->hasVolume = grid != nullptr;
  if (grid) {
    const auto corner = [&](int i) {
      Vec3 index;
      for (int a = 0; a < 3; ++a) index[a] = (i >> a & 1) != 0 ? grid->size[a] - 0.5 : -0.5;
      return grid->toWorld(index);
    };
    std::vector<std::vector<Vec3>> edges;
    for (int i = 0; i < 8; ++i)
      for (int a = 0; a < 3; ++a)
        if ((i >> a & 1) == 0) edges.push_back({corner(i), corner(i | 1 << a)});
    d_->box.set(edges, true);
  }
  d_->updateVisibility();
}

void SurfaceScene::setSlice(Plane plane, const QImage& picture, const std::array<Vec3, 3>& corners) {
  d_->slices[indexOf(plane)].set(picture, corners);
  d_->updateVisibility();
}

void SurfaceScene::showSlices(bool on) {
  d_->slicesOn = on;
  d_->updateVisibility();
}

void SurfaceScene::showStage(const EventTrace& trace, EventStage stage) {
  d_->stage = stage;
  if (stage != EventStage::none) {
    d_->around.setFaces(stage == EventStage::closed    ? trace.closedFaces
                        : stage == EventStage::refined ? trace.refinedFaces
                                                       : trace.openedFaces);
    d_->red.setFaces(trace.collidingFaces);
    d_->handle.setFaces(trace.handleFaces);
    d_->loops.set(trace.boundaryLoops, true);
    d_->lambda.set(trace.lambda, false);
  }
  d_->updateVisibility();
}

void SurfaceScene::setPixelRatio(double ratio) {
  d_->outside.actor->GetProperty()->SetLineWidth(static_cast<float>(3 * ratio));
  d_->loops.actor->GetProperty()->SetLineWidth(static_cast<float>(4 * ratio));
  for (LineActor& part : d_->marked) part.actor->GetProperty()->SetLineWidth(static_cast<float>(4 * ratio));
  d_->lambda.actor->GetProperty()->SetPointSize(static_cast<float>(5 * ratio));
}

CameraPose SurfaceScene::pose() const {
  vtkCamera* camera = d_->renderer->GetActiveCamera();
  CameraPose pose;
  camera->OrthogonalizeViewUp();
  pose.focus = Vec3(camera->GetFocalPoint());
  pose.towardsEye = (Vec3(camera->GetPosition()) - pose.focus).normalized();
  pose.up = Vec3(camera->GetViewUp());
  pose.height = 2 * camera->GetParallelScale();
  return pose;
}

void SurfaceScene::setPose(const CameraPose& pose) {
  vtkCamera* camera = d_->renderer->GetActiveCamera();
  const Vec3 eye = pose.focus + 2 * pose.height * pose.towardsEye;
  camera->SetFocalPoint(pose.focus.data());
  camera->SetPosition(eye.data());
  camera->SetViewUp(pose.up.data());
  camera->SetParallelScale(pose.height / 2);
}

void SurfaceScene::fitDepth() { d_->renderer->ResetCameraClippingRange(); }

}  // namespace handlebody::ui
