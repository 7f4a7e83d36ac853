// Tunnels and pieces in the step Correct, by mouse: found, shown, closed, undone.

#include <QPushButton>
#include <QTableWidget>
#include <QUndoStack>

#include "core/io/formats/volume_io.h"
#include "tests/support/test_volume.h"
#include "tests/ui/window/window_support.h"
#include "ui/window/correct/tunnels_list.h"

using namespace handlebody;
using namespace handlebody::test;
using ui::Command;
using ui::GrowthState;

namespace {

const Vec3 kMiddle(20, 20, 20);
constexpr double kLarge = 11.5, kSmall = 6;  // radii of a torus round the z axis, mm

QString writeTorus(const QTemporaryDir& folder) {
  const QString path = folder.filePath("torus.nii.gz");
  const auto intensity = [](int i, int j, int k) {
    const Vec3 q = Vec3(i, j, k) - kMiddle;
    const double distance = std::hypot(std::hypot(q.x(), q.y()) - kLarge, q.z()) - kSmall;
    // No two voxels are quite alike, so that the background is not taken for padding.
    return 20 + 180 * std::clamp(distance + 0.5, 0.0, 1.0) + 0.5 * std::sin(i + 37.1 * j + 1234.5 * k);
  };
  writeVolume(testing::volumeByIndex(testing::cubicGrid(41), intensity), path.toStdString());
  return path;
}

struct Grown {
  QTemporaryDir folder;
  std::unique_ptr<ui::MainWindow> window = shownWindow();
  bool ok = false;

  Grown() {
    if (!window || !open(*window, writeTorus(folder))) return;
    document().addSeed({kMiddle + Vec3(kLarge, 0, 0), 3.0});
    document().run();
    if (!waitFor(*window, GrowthState::finished)) return;
    window->showStep(Command::stepCorrect);
    ok = list() != nullptr;
  }
  ui::Document& document() { return window->document(); }
  ui::TunnelsList* list() { return window->findChild<ui::TunnelsList*>(); }
  QTableWidget* table() { return list()->findChild<QTableWidget*>(); }
  int genus() {
    int sum = 0;
    for (const int g : document().snapshot()->certificate.genus) sum += g;
    return sum;
  }
  QPushButton* button(const QString& text) {
    const auto all = list()->findChildren<QPushButton*>();
    for (QPushButton* b : all)
      if (b->text() == text) return b;
    return nullptr;
  }
  bool isOffered(const QString& text) { return button(text) && button(text)->isVisible(); }
  void click(const QString& text) { QTest::mouseClick(button(text), Qt::LeftButton); }
  bool find() {
    click("Find tunnels and pieces");
    return QTest::qWaitFor([&] { return table()->isVisible() && table()->rowCount() > 0; }, kPatience);
  }
  bool choose(const QString& what) {
    for (int row = 0; row < table()->rowCount(); ++row)
      if (table()->item(row, 0)->text() == what) {
        table()->selectRow(row);
        return true;
      }
    return false;
  }
  //! The window as it is seen, into the folder where the tests are; to be looked at.
  void keepPicture(const char* name) {
    const QString folderOfPictures = qEnvironmentVariable("HANDLEBODY_KEEP_PICTURES");
    if (!folderOfPictures.isEmpty()) {
      QTest::qWait(300);
      window->grab().save(folderOfPictures + '/' + name);
    }
  }
};

}  // namespace

class TunnelsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theTunnelIsFoundShownFilledAndUndone();
  void anotherIterationClearsTheList();
  void anEditIsLeftOutFromTheList();
  void withoutASurfaceThereIsNothingToFind();
};

void TunnelsTest::theTunnelIsFoundShownFilledAndUndone() {
  Grown grown;
  QVERIFY(grown.ok);
  const int before = grown.document().iteration();
  QVERIFY(grown.find());
  QVERIFY(grown.choose("Tunnel"));
  // Lengths as theory has them.
  const auto& loops = grown.window->viewState().markedLoops();
  QCOMPARE(static_cast<int>(loops.size()), 2);
  const auto lengthOf = [](const std::vector<Vec3>& points) {
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
      sum += (points[(i + 1) % points.size()] - points[i]).norm();
    return sum;
  };
  QVERIFY(std::abs(lengthOf(loops[0].points) - 2 * M_PI * kSmall) < 2);
  QVERIFY(std::abs(lengthOf(loops[1].points) - 2 * M_PI * (kLarge - kSmall)) < 2);
  QVERIFY((grown.window->viewState().crosshair() - kMiddle).norm() < kLarge + kSmall + 1);
  QVERIFY(grown.isOffered("Cut handle") && grown.isOffered("Fill tunnel"));
  QVERIFY(!grown.isOffered("Remove") && !grown.isOffered("Leave out"));
  grown.keepPicture("tunnel_found.png");

  QSignalSpy edited(&grown.document(), &ui::Document::meshEdited);
  grown.click("Fill tunnel");
  QVERIFY(!edited.isEmpty() || edited.wait(kPatience));
  QCOMPARE(grown.document().iteration(), before + 1);
  QCOMPARE(grown.genus(), 0);
  QVERIFY(grown.document().snapshot()->certificate.boundsBody());
  const QString said = grown.window->messages().text();
  QVERIFY2(said.startsWith("Tunnel closed: ") && said.contains("ml, was "), qPrintable(said));
  QVERIFY(grown.window->viewState().markedLoops().empty());
  // It looks again by itself: the tunnel is gone, and the edit stands in the list.
  QVERIFY(QTest::qWaitFor([&] { return grown.choose("Component"); }, kPatience));
  QVERIFY(!grown.choose("Tunnel"));
  QVERIFY(grown.choose("Tunnel filled"));
  QCOMPARE(grown.document().undoStack()->undoText(), QString("Fill tunnel"));
  grown.keepPicture("tunnel_filled.png");

  grown.document().undoStack()->undo();
  QVERIFY(QTest::qWaitFor([&] { return grown.document().iteration() == before; }, kPatience));
  QCOMPARE(grown.genus(), 1);
}

void TunnelsTest::anotherIterationClearsTheList() {
  Grown grown;
  QVERIFY(grown.ok);
  QVERIFY(grown.find());
  QVERIFY(grown.choose("Tunnel"));
  const int before = grown.document().iteration();
  grown.document().stepBack();
  QVERIFY(QTest::qWaitFor([&] { return grown.document().iteration() == before - 1; }, kPatience));
  QCOMPARE(grown.table()->rowCount(), 0);
  QVERIFY(!grown.table()->isVisible());
  QVERIFY(grown.window->viewState().markedLoops().empty());
  // Another page, and the loops are seen no more.
  QVERIFY(grown.find());
  QVERIFY(grown.choose("Tunnel"));
  QVERIFY(!grown.window->viewState().markedLoops().empty());
  grown.window->showStep(Command::stepGrow);
  QVERIFY(grown.window->viewState().markedLoops().empty());
}

void TunnelsTest::anEditIsLeftOutFromTheList() {
  Grown grown;
  QVERIFY(grown.ok);
  const int before = grown.document().iteration();
  QVERIFY(grown.find());
  QVERIFY(grown.choose("Tunnel"));
  QSignalSpy edited(&grown.document(), &ui::Document::meshEdited);
  grown.click("Cut handle");
  QVERIFY(!edited.isEmpty() || edited.wait(kPatience));
  QVERIFY(QTest::qWaitFor([&] { return grown.choose("Handle cut"); }, kPatience));
  QVERIFY(grown.isOffered("Leave out"));
  grown.click("Leave out");
  QVERIFY(QTest::qWaitFor([&] { return grown.document().iteration() == before; }, kPatience));
  QVERIFY(grown.document().constraints().edits.empty());
  QCOMPARE(grown.genus(), 1);
}

void TunnelsTest::withoutASurfaceThereIsNothingToFind() {
  auto window = shownWindow();
  QVERIFY(window);
  window->showStep(Command::stepCorrect);
  const auto* list = window->findChild<ui::TunnelsList*>();
  QVERIFY(list);
  QVERIFY(!list->findChild<QPushButton*>()->isEnabled());
}

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  QApplication::setOrganizationName("Handlebody");
  QApplication::setApplicationName("handlebody-test");
  TunnelsTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "tunnels_test.moc"
