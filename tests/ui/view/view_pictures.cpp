// Makes pictures of the views for looking at: view_pictures VOLUME I,J,K ITERATIONS OUT_FOLDER [WIDTH
// HEIGHT]
#include <QApplication>
#include <QGridLayout>
#include <QTest>
#include <cstdio>

#include "core/evolution/active_contour.h"
#include "core/io/formats/volume_io.h"
#include "tests/ui/view/document_double.h"
#include "ui/view/slice_view.h"
#include "ui/view/surface_view.h"

using namespace handlebody;
using namespace handlebody::ui;

namespace {

struct Grown {
  TriangleSoup mesh;
  std::vector<FaceState> states;
  EventTrace trace;  // of the first handle, else of the first event
};

Grown grow(const Volume& volume, const Seed& seed, int iterations) {
  ActiveContour contour(volume, {seed}, {});
  contour.recordTraces(true);
  Grown grown;
  bool handle = false;
  while (contour.stopReason() == StopReason::running && contour.iteration() < iterations)
    for (const Event& event : contour.step().events) {
      const bool first =
          grown.trace.closedFaces.empty() || (!handle && event.kind == EventKind::handleInserted);
      if (first && !event.trace.closedFaces.empty()) grown.trace = event.trace;
      handle |= event.kind == EventKind::handleInserted;
    }
  std::vector<int> vertices;
  grown.mesh = contour.mesh().compact(&vertices);
  std::vector<bool> converged(grown.mesh.points.size(), false);
  for (int v = 0; v < contour.mesh().vertexSlots(); ++v)
    if (contour.mesh().isVertex(v)) converged[vertices[v]] = contour.isConverged(v);
  for (const Triangle& t : grown.mesh.triangles)
    grown.states.push_back(converged[t[0]] ? FaceState::converged : FaceState::moving);
  return grown;
}

}  // namespace

int main(int argc, char** argv) {
  QApplication app(argc, argv);
  if (argc < 5) return 1;
  const QString folder = QString::fromLocal8Bit(argv[4]);
  Document document;
  ViewState state;
  QWidget window;
  auto* layout = new QGridLayout(&window);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(3);
  SliceView axial(Plane::axial, document, state), coronal(Plane::coronal, document, state),
      sagittal(Plane::sagittal, document, state);
  SurfaceView surface(document, state);
  surface.setFlightTime(0);
  layout->addWidget(&axial, 0, 0);
  layout->addWidget(&coronal, 1, 0);
  layout->addWidget(&sagittal, 1, 1);
  layout->addWidget(&surface, 0, 1);
  window.resize(argc > 6 ? QSize(atoi(argv[5]), atoi(argv[6])) : QSize(1600, 1000));
  window.show();
  (void)QTest::qWaitForWindowExposed(&window);
  const auto shoot = [&](const char* name) {
    QTest::qWait(300);
    const bool done = window.grab().save(folder + "/" + name + ".png");
    std::printf("%s %s\n", name, done ? "written" : "NOT written");
  };
  shoot("0_empty");
  const Volume volume = readVolume(argv[1]);
  handlebody::ui::testing::setVolume(document, volume);
  state.startWith(volume);
  int i = 0, j = 0, k = 0;
  if (std::sscanf(argv[2], "%d,%d,%d", &i, &j, &k) != 3) return 1;
  state.setCrosshair(volume.grid.toWorld(Vec3(i, j, k)));
  document.addSeed({state.crosshair(), {}});
  document.addSeed({volume.grid.toWorld(Vec3(i + 12, j, k)), 4});
  document.selectSeed(0);
  axial.setFocus();
  shoot("1_seeds");
  const Grown grown = grow(volume, {state.crosshair(), {}}, atoi(argv[3]));
  handlebody::ui::testing::setSnapshot(document, grown.mesh, grown.states);
  shoot("2_mesh");
  state.setSlicesIn3d(false);
  state.setMeshColouring(MeshColouring::edges);
  state.setTint(Tint{nullptr, {state.level() - state.window() / 2, state.level() - state.window() / 5}});
  shoot("3_edges_tint");
  state.setMeshColouring(MeshColouring::state);
  state.setColourMap(ColourMap::contrast);
  state.setTint({});
  shoot("4_state_contrast");
  surface.showStage(grown.trace, EventStage::colliding);
  state.setColourMap(ColourMap::hot);
  shoot("5_colliding_hot");
  surface.showStage(grown.trace, EventStage::opened);
  shoot("6_opened");
  surface.showStage(grown.trace, EventStage::handle);
  shoot("6_handle");
  surface.showStage(grown.trace, EventStage::closed);
  shoot("6_closed");
  surface.clearStage();
  surface.lookFrom(Plane::axial);
  state.setColourMap(ColourMap::inverted);
  state.setWindowLevelTool(true);
  shoot("7_superior");
  return 0;
}
