// Makes pictures of the views for looking at: view_pictures VOLUME MESH SEED(i,j,k) OUT_FOLDER [WIDTH HEIGHT]
#include <QApplication>
#include <QGridLayout>
#include <QTest>
#include <cstdio>

#include "core/io/mesh_io.h"
#include "core/io/volume_io.h"
#include "tests/ui/view/document_double.h"
#include "ui/view/slice_view.h"
#include "ui/view/surface_view.h"

using namespace handlebody;
using namespace handlebody::ui;

namespace {

//! Not a real event: what lies near one vertex, in rings.
EventTrace exampleTrace(const TriangleSoup& mesh) {
  EventTrace trace;
  const Vec3 place = mesh.points[0];
  double longest = 0;
  for (const Triangle& t : mesh.triangles)
    longest = std::max(
        longest,
        (mesh.points[static_cast<std::size_t>(t[0])] - mesh.points[static_cast<std::size_t>(t[1])]).norm());
  for (const Triangle& t : mesh.triangles) {
    std::array<Vec3, 3> face;
    for (std::size_t c = 0; c < 3; ++c) face[c] = mesh.points[static_cast<std::size_t>(t[c])];
    const double distance = (face[0] - place).norm();
    if (distance > 6 * longest) continue;
    (distance < 2 * longest ? trace.collidingFaces : trace.openedFaces).push_back(face);
    if (distance < 2 * longest) trace.handleFaces.push_back(face);
    trace.closedFaces.push_back(face);
  }
  for (const auto& face : trace.collidingFaces) trace.boundaryLoops.push_back({face.begin(), face.end()});
  trace.boundaryLoops.resize(1);
  trace.lambda = {{place}};
  return trace;
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
  if (std::sscanf(argv[3], "%d,%d,%d", &i, &j, &k) != 3) return 1;
  state.setCrosshair(volume.grid.toWorld(Vec3(i, j, k)));
  document.addSeed({state.crosshair(), {}});
  document.addSeed({volume.grid.toWorld(Vec3(i + 12, j, k)), 4});
  document.selectSeed(0);
  axial.setFocus();
  shoot("1_seeds");
  const TriangleSoup mesh = readMesh(argv[2]);
  std::vector<FaceState> states;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
    states.push_back(static_cast<FaceState>(f * 8 / mesh.triangles.size() % 4));
  handlebody::ui::testing::setSnapshot(document, mesh, states);
  shoot("2_mesh");
  state.setSlicesIn3d(false);
  state.setMeshColouring(MeshColouring::edges);
  state.setTint(IntensityRange{state.level() - state.window() / 2, state.level() - state.window() / 5});
  shoot("3_edges_tint");
  state.setMeshColouring(MeshColouring::state);
  state.setColourMap(ColourMap::contrast);
  state.setTint({});
  shoot("4_state_contrast");
  surface.showStage(exampleTrace(mesh), EventStage::colliding);
  state.setColourMap(ColourMap::hot);
  shoot("5_colliding_hot");
  surface.showStage(exampleTrace(mesh), EventStage::handle);
  shoot("6_handle");
  surface.clearStage();
  surface.lookFrom(Plane::axial);
  state.setColourMap(ColourMap::inverted);
  state.setWindowLevelTool(true);
  shoot("7_superior");
  return 0;
}
