// How the window feels, in figures; one line each. With a release build:
//   sh tests/ui/with_display.sh build/release/tests/ui/window/window_bench
// Start to the first picture of the paper's cyst (199 × 99 × 171 voxels); frames per second while its surface
// of 20,000 triangles changes at every step; slices per second of 512 × 512 × 300 voxels under the wheel; how
// long a pause takes; moves of the brush for walls. All in the whole window at 1600 × 1000 with all four
// views.

#include <unistd.h>
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QProcess>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <vector>

#include "core/io/formats/volume_io.h"
#include "tests/ui/window/window_support.h"
#include "ui/window/commands.h"

using namespace handlebody;
using namespace handlebody::test;

namespace {

const QSize kWindow(1600, 1000);
constexpr int kLargeMesh = 15'000;  // triangles; the last part of the growth, up to 20,000

//! Counts the pictures that a view draws, and the longest time between two.
class Paints : public QObject {
 public:
  explicit Paints(QWidget& view) { view.installEventFilter(this); }

  void restart() {
    count = 0;
    longest = 0;
    since_.start();
  }
  bool eventFilter(QObject*, QEvent* event) override {
    if (event->type() == QEvent::Paint) {
      ++count;
      longest = std::max(longest, since_.restart());
    }
    return false;
  }

  int count = 0;
  qint64 longest = 0;  // ms

 private:
  QElapsedTimer since_;
};

//! Milliseconds of processor that this thread has used: with other work on the machine a fairer figure than
//! the time.
double busyMilliseconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return 1e3 * double(t.tv_sec) + 1e-6 * double(t.tv_nsec);
}

//! Seconds since this process was started, by the kernel's account; its ticks are hundredths.
double secondsAlive() {
  QFile stat("/proc/self/stat"), uptime("/proc/uptime");
  if (!stat.open(QIODevice::ReadOnly) || !uptime.open(QIODevice::ReadOnly)) return 0;
  const QByteArray text = stat.readAll();
  const QList<QByteArray> fields = text.mid(text.lastIndexOf(')') + 2).split(' ');
  return uptime.readAll().split(' ').front().toDouble() -
         fields.at(19).toDouble() / double(sysconf(_SC_CLK_TCK));
}

bool makeCyst(const QString& path) {
  return QProcess::execute(HANDLEBODY_CLI, {"phantom", "cyst", "-o", path}) == 0;
}

void makeLarge(const QString& path) {
  Grid grid;
  grid.size = {512, 512, 300};
  grid.spacing = Vec3(0.7, 0.7, 1);
  void* buffer = nullptr;
  const Volume volume = makeVolume(grid, VoxelType::int16, &buffer);
  auto* out = static_cast<std::int16_t*>(buffer);
  for (int k = 0; k < 300; ++k)
    for (int j = 0; j < 512; ++j)
      for (int i = 0; i < 512; ++i) *out++ = static_cast<std::int16_t>((i ^ j ^ k) + 2 * i);
  writeVolume(volume, path.toStdString());
}

bool openAndDraw(ui::MainWindow& window, const QString& path) {
  QSignalSpy opened(&window.document(), &ui::Document::opened);
  window.document().open(path);  // without the question about unsaved work
  if (opened.isEmpty() && !opened.wait(kPatience)) return false;
  Paints paints(window.views().slice(ui::Plane::axial));
  return QTest::qWaitFor([&] { return paints.count > 0; }, kPatience);
}

void measureStart(ui::MainWindow& window, const QString& cyst) {
  if (!openAndDraw(window, cyst)) return;
  std::printf("%-58s %6.2f s\n", "process started to the picture of the cyst", secondsAlive());
}

//! Grows to the end and counts the frames of the 3D view while the mesh is large.
void measureGrowth(ui::MainWindow& window) {
  ui::Document& document = window.document();
  document.addSeed({Vec3(77, 49, 85), 8.0});
  Paints paints(window.views().surface());
  QElapsedTimer timer;
  int first = -1;
  double busy = 0;
  QObject listener;
  QObject::connect(&document, &ui::Document::snapshotChanged, &listener, [&] {
    const auto snapshot = document.snapshot();
    if (!snapshot || snapshot->mesh.triangles.size() < kLargeMesh) return;
    if (first < 0) {
      first = snapshot->iteration;
      timer.start();
      paints.restart();
      busy = busyMilliseconds();
    }
  });
  window.commands()[ui::Command::run]->trigger();
  if (!waitFor(window, ui::GrowthState::finished)) return;
  const double seconds = double(timer.elapsed()) / 1000;
  const int steps = document.iteration() - first;
  const double each = (busyMilliseconds() - busy) / std::max(1, paints.count);
  std::printf(
      "%-58s %6.1f per second (%.1f ms of processor each; longest gap %lld ms; %.1f steps per second)\n",
      "3D frames while the surface grows", paints.count / seconds, each,
      static_cast<long long>(paints.longest), steps / seconds);
}

//! A stroke across the grown surface with a thousand walls there already: every move is drawn before the
//! next.
void measurePainting(ui::MainWindow& window) {
  ui::Document& document = window.document();
  if (!document.snapshot()) return;
  Constraints walls;
  for (int i = 0; i < 1000; ++i)  // beside the object, in the slice that is shown
    walls.walls.balls.push_back({Vec3(3 + 2 * (i % 50), 3 + 0.5 * (i / 50), 85), 2.0});
  document.setConstraints(walls, QStringLiteral("A thousand walls"));
  window.viewState().setCrosshair(Vec3(77, 49, 85));
  window.viewState().brush().setMode(ui::Brush::Mode::paintWalls);
  window.viewState().brush().setRadius(3);
  QTest::qWait(1000);  // the 3D view
  ui::SliceView& view = window.views().slice(ui::Plane::axial);
  Paints paints(view);
  constexpr int kMoves = 200;
  const auto at = [&](int i) {
    const double t = 2 * 3.14159265 * i / kMoves;
    return QPoint(static_cast<int>(view.width() * (0.5 + 0.3 * std::cos(t))),
                  static_cast<int>(view.height() * (0.5 + 0.3 * std::sin(2 * t))));
  };
  QTest::mousePress(&view, Qt::LeftButton, {}, at(0));
  QElapsedTimer timer;
  timer.start();
  paints.restart();
  const double busy = busyMilliseconds();
  for (int i = 1; i <= kMoves; ++i) {
    QMouseEvent move(QEvent::MouseMove, at(i), view.mapToGlobal(at(i)), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(&view, &move);
    const int before = paints.count;
    while (paints.count == before && timer.elapsed() < kPatience) QCoreApplication::processEvents();
  }
  std::printf("%-58s %6.1f per second (%.1f ms of processor each; longest %lld ms)\n",
              "moves of the brush, 1,000 walls there, all slices drawn",
              1000.0 * kMoves / double(timer.elapsed()), (busyMilliseconds() - busy) / kMoves,
              static_cast<long long>(paints.longest));
  const auto balls = window.viewState().brush().stroke().size();
  timer.start();
  const double ending = busyMilliseconds();
  QTest::mouseRelease(&view, Qt::LeftButton, {}, at(kMoves));
  const double ended = busyMilliseconds() - ending;
  std::printf("%-58s %6lld ms (%zu balls, over a surface of %zu triangles)\n", "the end of that stroke",
              static_cast<long long>(timer.elapsed()), balls, document.snapshot()->mesh.triangles.size());
  // What comes after it: the longest that one event keeps the window.
  double longest = 0;
  while (timer.elapsed() < 2000) {
    const double before = busyMilliseconds();
    QCoreApplication::processEvents();
    longest = std::max(longest, busyMilliseconds() - before);
  }
  std::printf("%-58s %6.1f ms of processor (%.1f ms for the end itself)\n",
              "the longest after it, in two seconds", longest, ended);
  window.viewState().brush().setMode(ui::Brush::Mode::off);
  document.setConstraints({}, QStringLiteral("No walls"));
}

//! The same on the surface: at the outline of a slice, and over the 3D view.
void measureTouching(ui::MainWindow& window) {
  ui::Document& document = window.document();
  if (!document.snapshot()) return;
  window.viewState().brush().setMode(ui::Brush::Mode::pin);
  window.viewState().brush().setRadius(3);
  QTest::qWait(500);
  QWidget* views[] = {&window.views().slice(ui::Plane::axial), &window.views().surface()};
  const char* names[] = {"moves of the brush that pins, in a slice", "moves of the brush that pins, in 3D"};
  for (int which = 0; which < 2; ++which) {
    QWidget& view = *views[which];
    Paints paints(view);
    constexpr int kMoves = 100;
    const auto at = [&](int i) {
      const double t = 2 * 3.14159265 * i / kMoves;
      return QPoint(static_cast<int>(view.width() * (0.5 + 0.05 * std::cos(t))),
                    static_cast<int>(view.height() * (0.5 + 0.05 * std::sin(t))));
    };
    QTest::mousePress(&view, Qt::LeftButton, {}, at(0));
    QElapsedTimer timer;
    timer.start();
    paints.restart();
    const double busy = busyMilliseconds();
    for (int i = 1; i <= kMoves; ++i) {
      QMouseEvent move(QEvent::MouseMove, at(i), view.mapToGlobal(at(i)), Qt::NoButton, Qt::LeftButton, {});
      QApplication::sendEvent(&view, &move);
      const int before = paints.count;
      while (paints.count == before && timer.elapsed() < kPatience) QCoreApplication::processEvents();
    }
    const auto balls = window.viewState().brush().stroke().size();
    std::printf("%-58s %6.1f per second (%.1f ms of processor each; longest %lld ms; %zu balls)\n",
                names[which], 1000.0 * kMoves / double(timer.elapsed()), (busyMilliseconds() - busy) / kMoves,
                static_cast<long long>(paints.longest), balls);
    const double end = busyMilliseconds();
    QTest::mouseRelease(&view, Qt::LeftButton, {}, at(kMoves));
    std::printf("%-58s %6.1f ms of processor\n", "the end of that stroke", busyMilliseconds() - end);
  }
  window.viewState().brush().setMode(ui::Brush::Mode::off);
  document.setConstraints({}, QStringLiteral("No pins"));
}

//! From the command to the last step that the worker still does.
void measurePause(ui::MainWindow& window) {
  ui::Document& document = window.document();
  qint64 longest = 0, longestSaid = 0;
  std::vector<int> iterations{20, 40, 60, 80, 100, 120};
  if (qEnvironmentVariableIsSet("HANDLEBODY_BENCH_BRIEF")) iterations.resize(1);
  for (const int from : iterations) {
    document.goTo(0);
    Parameters p = document.parameters();
    p.curvature = p.curvature == 0.2 ? 0.21 : 0.2;  // grown anew
    document.setParameters(p, QStringLiteral("Change curvature"));
    document.run();
    if (!QTest::qWaitFor([&] { return document.lastIteration() >= from; }, kPatience)) return;
    QElapsedTimer timer;
    timer.start();
    qint64 last = 0;
    QObject listener;
    QObject::connect(&document, &ui::Document::summariesChanged, &listener, [&] { last = timer.elapsed(); });
    QObject::connect(&document, &ui::Document::snapshotChanged, &listener, [&] { last = timer.elapsed(); });
    window.commands()[ui::Command::run]->trigger();
    while (document.state() != ui::GrowthState::paused) QCoreApplication::processEvents();
    longestSaid = std::max(longestSaid, timer.elapsed());
    QTest::qWait(500);
    longest = std::max(longest, last);
  }
  std::printf("%-58s %6lld ms (until the last step is shown: %lld ms)\n",
              qPrintable(QStringLiteral("pause, the slowest of %1").arg(iterations.size())),
              static_cast<long long>(longestSaid), static_cast<long long>(longest));
}

void measureScroll(ui::MainWindow& window, const QString& path) {
  if (!openAndDraw(window, path)) return;
  QTest::qWait(1000);  // the 3D view and the histogram
  constexpr int kSlices = 100;
  for (ui::Plane plane : {ui::Plane::axial, ui::Plane::coronal, ui::Plane::sagittal}) {
    ui::SliceView& view = window.views().slice(plane);
    Paints paints(view);
    QElapsedTimer timer;
    timer.start();
    paints.restart();
    const double busy = busyMilliseconds();
    for (int i = 0; i < kSlices; ++i) {
      const QPointF at = view.rect().center();
      QWheelEvent event(at, view.mapToGlobal(at), {}, {0, i % 50 < 25 ? 120 : -120}, Qt::NoButton, {},
                        Qt::NoScrollPhase, false);
      QApplication::sendEvent(&view, &event);
      const int before = paints.count;
      while (paints.count == before && timer.elapsed() < kPatience) QCoreApplication::processEvents();
    }
    std::printf(
        "%-58s %6.1f per second (%.1f ms of processor each; longest %lld ms)\n",
        qPrintable(QStringLiteral("slices under the wheel, 512 x 512 x 300, %1").arg(view.accessibleName())),
        1000.0 * kSlices / double(timer.elapsed()), (busyMilliseconds() - busy) / kSlices,
        static_cast<long long>(paints.longest));
  }
}

}  // namespace

int main(int argc, char** argv) {
  const QTemporaryDir folder;
  const QString cyst = QString::fromLocal8Bit(qgetenv("HANDLEBODY_BENCH_CYST"));
  if (cyst.isEmpty()) {  // the files first, then the same program anew, whose start is measured
    QCoreApplication application(argc, argv);
    const QString path = folder.filePath("cyst.nii.gz");
    if (!makeCyst(path)) return 1;
    makeLarge(folder.filePath("large.nii"));
    qputenv("HANDLEBODY_BENCH_CYST", path.toLocal8Bit());
    return QProcess::execute(QCoreApplication::applicationFilePath(), {});
  }
  QApplication application(argc, argv);
  QApplication::setOrganizationName("Handlebody");
  QApplication::setApplicationName("handlebody-bench");
  ui::MainWindow window;
  window.resize(kWindow);
  window.show();
  measureStart(window, cyst);
  measureGrowth(window);
  measurePainting(window);
  measureTouching(window);
  measurePause(window);
  measureScroll(window, QFileInfo(cyst).dir().filePath("large.nii"));
  return 0;
}
