// Random events on the window: nothing may crash, hang or leave an invalid surface. A minute, or as many
// seconds as HANDLEBODY_MONKEY_SECONDS says; HANDLEBODY_MONKEY_SEED repeats a run. It fails when an action
// takes over 5 seconds, and tells those over one second. Left alone the events soon lead to seeds from which
// nothing grows; so the sample is opened anew every half minute, every other time one with time points, and
// the memory told then: the window is each time in the same state, and whatever grows from one time to the
// next is kept for nothing.

#include <malloc.h>
#include <unistd.h>

#include <QElapsedTimer>
#include <QFile>
#include <QMenu>
#include <QMessageBox>
#include <QPixmapCache>
#include <QTimer>
#include <QUndoStack>
#include <ctime>
#include <random>
#include <sstream>
#include <string>

#include "tests/ui/window/time_window_support.h"
#include "ui/view/slice_geometry.h"

using namespace handlebody;
using namespace handlebody::test;
using ui::Command;

namespace {

int fromEnvironment(const char* name, int fallback) {
  bool given = false;
  const int value = qEnvironmentVariableIntValue(name, &given);
  return given ? value : fallback;
}

// Not: what opens a dialog of files or ends the program.
bool isSafe(Command id) {
  switch (id) {
    case Command::openFile:
    case Command::openFolder:
    case Command::openObjects:
    case Command::saveSession:
    case Command::saveSessionAs:
    case Command::exportResult:
    case Command::exportReport:
    case Command::exportAnonymousSession:
    case Command::exportPicture:
    case Command::exportFrameMeshes:
    case Command::exportFrameLabels:
    case Command::quit:
    case Command::fullScreen:
      return false;
    default:
      return true;
  }
}

//! At every change of them Qt keeps some 4 kB for good (the names of what it painted in the colours before).
//! A user changes them now and then; several times a second would hide what else may grow.
bool changesColours(Command id) {
  return id == Command::coloursOfSystem || id == Command::coloursLight || id == Command::coloursDark;
}

constexpr int kRest = 150;  // ms: what grows comes to rest

class Monkey {
 public:
  Monkey(ui::MainWindow& window, unsigned seed) : window_(window), random_(seed) {
    for (const ui::CommandSpec& spec : ui::Commands::table())
      if (isSafe(spec.id))
        (changesColours(spec.id) ? colours_ : commands_).push_back(window.commands()[spec.id]);
  }

  void act() {
    switch (below(7)) {
      case 0:
      case 1:
        return oneOf(below(1000) == 0 ? colours_ : commands_)->trigger();
      case 2:
        return click();
      case 3:
        return key();
      case 4:
        return drag();
      case 5:
        return touch();
      default:
        return wheel();
    }
  }

  //! The brush over the surface, where random places seldom lie: a vertex near the slice, or in 3D the
  //! middle.
  void touch() {
    constexpr Command modes[] = {Command::pinByBrush,     Command::unpinByBrush, Command::smoothByBrush,
                                 Command::pullByDragging, Command::cutByLine,    Command::paintWalls,
                                 Command::eraseWalls};
    window_.commands()[modes[below(std::size(modes))]]->trigger();
    const auto shown = window_.document().snapshot();
    if (!shown || shown->mesh.points.empty()) return window_.document().stepForward();
    if (window_.document().state() == ui::GrowthState::running) window_.document().pause();
    QTest::qWait(kRest);
    constexpr ui::Plane planes[] = {ui::Plane::axial, ui::Plane::coronal, ui::Plane::sagittal};
    const ui::Plane plane = planes[below(3)];
    const Vec3 place = shown->mesh.points[below(static_cast<int>(shown->mesh.points.size()))];
    QWidget* view = &window_.views().surface();
    QPoint at = view->rect().center() + QPoint(below(81) - 40, below(81) - 40);
    if (below(3) != 0) {
      window_.viewState().setCrosshair(place);
      view = &window_.views().slice(plane);
      ui::SliceGeometry geometry(window_.document().volume().grid, plane, view->size());
      at = geometry.worldToScreen(place).toPoint();
    }
    if (!view->isVisible()) return;
    strokeFrom(*view, at, Qt::LeftButton);
  }

 private:
  QAction* oneOf(const std::vector<QAction*>& actions) {
    return actions[below(static_cast<int>(actions.size()))];
  }

  int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(random_); }

  QWidget* target(QPoint& at) {
    const QPoint point(below(window_.width()),
                       60 + below(window_.height() - 60));  // menus are driven by commands
    QWidget* widget = window_.childAt(point);
    if (!widget) widget = &window_;
    at = widget->mapFrom(&window_, point);
    return widget;
  }

  // A file dialog would wait for a person.
  static bool opensDialog(const QWidget* widget) {
    const auto* button = qobject_cast<const QAbstractButton*>(widget);
    return button && (button->text().contains(QChar(0x2026)) || button->text().contains("session"));
  }

  void click() {
    QPoint at;
    QWidget* widget = target(at);
    if (opensDialog(widget)) return;
    QTest::mouseClick(widget, below(8) == 0 ? Qt::MiddleButton : Qt::LeftButton, {}, at);
  }

  void key() {
    constexpr Qt::Key keys[] = {Qt::Key_Space, Qt::Key_Period, Qt::Key_Comma,    Qt::Key_N,
                                Qt::Key_P,     Qt::Key_Return, Qt::Key_Plus,     Qt::Key_Minus,
                                Qt::Key_W,     Qt::Key_Up,     Qt::Key_Left,     Qt::Key_PageUp,
                                Qt::Key_Home,  Qt::Key_Tab,    Qt::Key_Escape,   Qt::Key_Right,
                                Qt::Key_Down,  Qt::Key_1,      Qt::Key_Backspace};
    QWidget* focus = QApplication::focusWidget();
    if (focus && (!window_.isAncestorOf(focus) || opensDialog(focus))) focus = nullptr;
    QTest::keyClick(focus ? focus : &window_, keys[below(std::size(keys))]);
  }

  void drag() {
    QPoint at;
    QWidget* widget = target(at);
    if (opensDialog(widget)) return;
    constexpr Qt::MouseButton buttons[] = {Qt::LeftButton, Qt::RightButton, Qt::MiddleButton};
    strokeFrom(*widget, at, buttons[below(3)]);
  }

  void strokeFrom(QWidget& widget, QPoint at, Qt::MouseButton button) {
    QTest::mousePress(&widget, button, {}, at);
    for (int i = 0; i < 4; ++i) {
      at += QPoint(below(41) - 20, below(41) - 20);
      QMouseEvent move(QEvent::MouseMove, at, widget.mapToGlobal(at), button, button, Qt::NoModifier);
      QApplication::sendEvent(&widget, &move);
    }
    QTest::mouseRelease(&widget, button, {}, at);
  }

  void wheel() {
    QPoint at;
    QWidget* widget = target(at);
    QWheelEvent event(at, widget->mapToGlobal(at), {}, {0, below(2) == 0 ? 120 : -120}, Qt::NoButton,
                      below(4) == 0 ? Qt::ControlModifier : Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(widget, &event);
  }

  ui::MainWindow& window_;
  std::mt19937 random_;
  std::vector<QAction*> commands_, colours_;
};

//! What is wrong with a snapshot, for the log: a failure must be understood from it alone.
std::string described(const ui::MeshSnapshot& snapshot, int actions) {
  const Certificate& c = snapshot.certificate;
  std::ostringstream out;
  out << "iteration " << snapshot.iteration << " after " << actions << " actions: closed " << c.closed
      << ", manifold " << c.manifold << ", oriented " << c.oriented << ", self-intersections "
      << c.selfIntersections << ", faces " << c.faces << ", components " << c.components << ", volume "
      << c.volume << " mm3";
  return out.str();
}

constexpr qint64 kHang = 5000;    // ms
constexpr qint64 kAnew = 30'000;  // ms

double residentMegabytes() {
  QFile statm(QStringLiteral("/proc/self/statm"));
  if (!statm.open(QIODevice::ReadOnly)) return 0;
  return statm.readAll().split(' ').at(1).toDouble() * double(sysconf(_SC_PAGESIZE)) / 1e6;
}

//! What is in use by malloc and new, without what they keep for later.
double usedMegabytes() {
  const struct mallinfo2 info = mallinfo2();
  return double(info.uordblks + info.hblkhd) / 1e6;
}

//! What was done since the sample was opened, to see that the engine had its share.
struct Done {
  int iterations = 0, changes = 0, undo = 0, pins = 0, edits = 0;

  void look(const ui::Document& document) {
    iterations = std::max(iterations, document.lastIteration());
    changes = std::max(changes, static_cast<int>(document.events().size()));
    undo = std::max(undo, document.undoStack()->count());
    pins = std::max(pins, static_cast<int>(document.constraints().pins.size()));
    edits = std::max(edits, static_cast<int>(document.constraints().edits.size()));
  }
};

void tell(qint64 milliseconds, int actions, const Done& done) {
  qInfo(
      "%4lld s, %d actions: up to %d iterations, %d events, %d pins, %d edits, %d entries to undo; sample "
      "anew: %.0f MB "
      "resident, %.1f MB in use",
      static_cast<long long>(milliseconds / 1000), actions, done.iterations, done.changes, done.pins,
      done.edits, done.undo, residentMegabytes(), usedMegabytes());
}

//! A surface, for the brush.
bool growALittle(ui::MainWindow& window) {
  constexpr int kIterations = 10;
  window.document().run();
  const bool done = QTest::qWaitFor([&] { return window.document().iteration() >= kIterations; }, kPatience);
  window.document().pause();
  QTest::qWait(kRest);
  return done;
}

//! As a user who answers "discard", with the views as they were at first: a view that fills the window keeps
//! larger buffers. Qt keeps up to 10 MB of pixels of what styles and views painted, in any number of small
//! pixmaps: random events fill that for most of an hour, so it is emptied.
bool openAnew(ui::MainWindow& window, const QString& path) {
  QSignalSpy opened(&window.document(), &ui::Document::opened);
  window.document().open(path);
  const bool done = (!opened.isEmpty() || opened.wait(kPatience)) &&
                    QTest::qWaitFor([&] { return window.document().resolved().has_value(); }, kPatience) &&
                    growALittle(window);
  for (Command id : {Command::fourViews, Command::resetViews, Command::stepSeed})
    window.commands()[id]->trigger();
  QTest::qWait(100);
  QPixmapCache::clear();
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  return done;
}

//! Of this thread: a machine that is busy with other things makes an action slow as well.
double busySeconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

void closePopups() {
  while (QWidget* popup = QApplication::activePopupWidget()) popup->close();
  if (QWidget* modal = QApplication::activeModalWidget()) modal->close();
}

}  // namespace

class MonkeyTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void randomEventsDoNoHarm();
};

void MonkeyTest::randomEventsDoNoHarm() {
  const unsigned seed = static_cast<unsigned>(fromEnvironment("HANDLEBODY_MONKEY_SEED", 1));
  const int seconds = fromEnvironment("HANDLEBODY_MONKEY_SECONDS", 60);
  qInfo("HANDLEBODY_MONKEY_SEED=%u", seed);
  auto window = shownWindow();
  BeatingSample beating;
  QVERIFY(beating.make());
  QVERIFY(window && open(*window, sample("cyst_session.json")) && growALittle(*window));
  QTimer closer;  // a dialog that waits in a loop of its own
  connect(&closer, &QTimer::timeout, this, closePopups);
  closer.start(200);
  Monkey monkey(*window, seed);
  QElapsedTimer clock, answer;
  clock.start();
  qint64 slowest = 0;
  int actions = 0;
  Done done;
  tell(0, 0, done);
  const auto touch = [&] {  // later, after random seeds and parameters, there is seldom a surface at rest
    constexpr int kTouches = 20;
    for (int i = 0; i < kTouches; ++i) {
      monkey.touch();
      done.look(window->document());
    }
  };
  touch();
  qint64 nextOpened = kAnew;
  bool isBeating = false;
  for (; clock.elapsed() < seconds * 1000LL; ++actions) {
    if (clock.elapsed() > nextOpened) {
      isBeating = !isBeating;
      QVERIFY(openAnew(*window, isBeating ? beating.session : sample("cyst_session.json")));
      tell(clock.elapsed(), actions, done);
      done = {};
      nextOpened += kAnew;
      touch();
    }
    answer.start();
    const double busy = busySeconds();
    monkey.act();
    QApplication::processEvents();
    // What an event loop does by itself, and processEvents() alone does not.
    QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    slowest = std::max(slowest, answer.elapsed());
    if (answer.elapsed() > 1000)
      qInfo("action %d took %lld ms, of which this thread worked %.0f", actions,
            static_cast<long long>(answer.elapsed()), 1000 * (busySeconds() - busy));
    QVERIFY2(answer.elapsed() < kHang, "the window did not answer");
    const auto snapshot = window->document().snapshot();
    // A surface may shrink away (an own range, both directions); then there is nothing to certify.
    const bool certain = !snapshot || snapshot->mesh.triangles.empty() || snapshot->certificate.passes();
    if (!certain) QFAIL(described(*snapshot, actions).c_str());
    QVERIFY(window->document().iteration() <= window->document().lastIteration());
    done.look(window->document());
  }
  QVERIFY(openAnew(*window, sample("cyst_session.json")));
  tell(clock.elapsed(), actions, done);
  malloc_trim(0);
  qInfo("%.0f MB resident without what malloc keeps for later", residentMegabytes());
  qInfo("%d actions, the slowest took %lld ms", actions, static_cast<long long>(slowest));
}

int main(int argc, char** argv) {
  // QtTest ends a function after five minutes; a long run is asked for by its seconds.
  if (!qEnvironmentVariableIsSet("QTEST_FUNCTION_TIMEOUT"))
    qputenv("QTEST_FUNCTION_TIMEOUT",
            QByteArray::number(1000 * (fromEnvironment("HANDLEBODY_MONKEY_SECONDS", 60) + 300)));
  QApplication application(argc, argv);
  QApplication::setOrganizationName("Handlebody");
  QApplication::setApplicationName("handlebody-monkey");
  MonkeyTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "monkey_test.moc"
