// How fast the views draw; prints one line per figure. Run under tests/ui/with_display.sh with a release
// build.
#include <QApplication>
#include <QElapsedTimer>
#include <QTest>
#include <cmath>
#include <cstdio>
#include <ctime>

#include "core/mesh/plane_section.h"
#include "core/mesh/shapes.h"
#include "tests/ui/view/document_double.h"
#include "ui/view/slice_view.h"
#include "ui/view/surface_view.h"

using namespace handlebody;
using namespace handlebody::ui;

namespace {

//! 512 × 512 × 300 int16 with something to see.
Volume largeVolume() {
  Grid grid;
  grid.size = {512, 512, 300};
  grid.spacing = Vec3(0.7, 0.7, 1);
  void* buffer = nullptr;
  Volume volume = makeVolume(grid, VoxelType::int16, &buffer);
  auto* out = static_cast<std::int16_t*>(buffer);
  for (int k = 0; k < 300; ++k)
    for (int j = 0; j < 512; ++j)
      for (int i = 0; i < 512; ++i) *out++ = static_cast<std::int16_t>((i ^ j ^ k) + 2 * i);
  return volume;
}

//! About 20,000 triangles: a sphere of 90 mm with a bump that travels.
TriangleSoup bumpySphere(int step) {
  static const TriangleSoup sphere = icosphere(Vec3(180, 180, 150), 90, 3.5);
  TriangleSoup mesh = sphere;
  for (Vec3& p : mesh.points) {
    const Vec3 d = p - Vec3(180, 180, 150);
    p += 0.05 * std::sin(0.2 * d.x() + 0.3 * step) * d;
  }
  return mesh;
}

template <typename F>
void measure(const char* what, int times, F&& once) {
  once(0);
  QElapsedTimer timer;
  timer.start();
  const std::clock_t start = std::clock();
  for (int i = 1; i <= times; ++i) once(i);
  const double ms = static_cast<double>(timer.nsecsElapsed()) / 1e6 / times;
  // Processor time of all threads: on a machine with other work a fairer figure than the time that passed.
  const double busy = 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / times;
  std::printf("%-52s %7.2f ms %7.1f per second, %7.2f ms of processor\n", what, ms, 1000 / ms, busy);
  std::fflush(stdout);
}

void measureSlices(Document& document, ViewState& state, const QSize& size) {
  const char* const names[] = {"sagittal", "coronal", "axial"};
  for (Plane plane : {Plane::axial, Plane::coronal, Plane::sagittal}) {
    SliceView view(plane, document, state);
    view.resize(size);
    view.show();
    (void)QTest::qWaitForWindowExposed(&view);
    const std::string what = std::string(names[static_cast<int>(plane)]) + " slice scroll, " +
                             std::to_string(size.width()) + " x " + std::to_string(size.height());
    const Grid& grid = document.volume().grid;
    measure(what.c_str(), 60, [&](int i) {
      state.setCrosshair(grid.toWorld(Vec3(200 + i % 60, 200 + i % 60, 120 + i % 60)));
      view.repaint();
    });
  }
}

void measureSurface(Document& document, ViewState& state) {
  SurfaceView view(document, state);
  view.setFlightTime(0);
  view.resize(1000, 600);
  view.show();
  (void)QTest::qWaitForWindowExposed(&view);
  if (!view.hasOpenGl()) {
    std::printf("SKIPPED: no OpenGL\n");
    return;
  }
  const auto change = [&](int i) {
    handlebody::ui::testing::setSnapshot(document, bumpySphere(i));
    view.repaint();
  };
  for (bool slices : {true, false}) {
    state.setSlicesIn3d(slices);
    const std::string with = slices ? ", with slices" : "";
    state.setMeshColouring(MeshColouring::plain);
    measure(("3D 1000 x 600, mesh changes" + with).c_str(), 40, change);
    state.setMeshColouring(MeshColouring::edges);
    measure(("3D 1000 x 600, mesh with edges changes" + with).c_str(), 40, change);
    state.setMeshColouring(MeshColouring::state);
    measure(("3D 1000 x 600, mesh by state changes" + with).c_str(), 40, change);
    state.setMeshColouring(MeshColouring::support);
    measure(("3D 1000 x 600, mesh by support changes" + with).c_str(), 40, change);
    measure(("3D 1000 x 600, camera turns" + with).c_str(), 40, [&](int i) {
      QTest::mousePress(&view, Qt::LeftButton, {}, {500, 300});
      QTest::mouseMove(&view, {500 + 3 * (i % 2 ? 1 : -1), 300});
      QTest::mouseRelease(&view, Qt::LeftButton, {}, {500, 300});
      view.update();
      view.repaint();
    });
  }
}

}  // namespace

int main(int argc, char** argv) {
  QApplication app(argc, argv);
  Document document;
  ViewState state;
  const Volume volume = largeVolume();
  handlebody::ui::testing::setVolume(document, volume);
  measure("automatic window", 3, [&](int) { state.setAutomaticWindow(volume); });
  state.startWith(volume);
  measureSlices(document, state, {800, 500});
  const TriangleSoup mesh = bumpySphere(0);
  std::printf("%zu triangles\n", mesh.triangles.size());
  handlebody::ui::testing::setSnapshot(document, mesh);
  measureSlices(document, state, {800, 500});
  measureSlices(document, state, {1600, 1000});
  std::vector<std::array<Vec3, 2>> section;
  measure("outline of one slice", 100,
          [&](int i) { planeSection(mesh.points, mesh.triangles, Vec3::UnitZ(), 100 + i, section); });
  measureSurface(document, state);
  return 0;
}
