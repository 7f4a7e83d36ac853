// The step Correct at the crosshair: pins, and edits by hand.

#include <QPushButton>
#include <QTableWidget>
#include <set>

#include "tests/ui/window/correct_support.h"
#include "ui/window/grow/held_section.h"

using namespace handlebody;
using namespace handlebody::test;
using ui::Command;
using ui::GrowthState;

namespace {

std::set<std::array<double, 3>> coordinates(const TriangleSoup& mesh) {
  std::set<std::array<double, 3>> all;
  for (const Vec3& p : mesh.points) all.insert({p.x(), p.y(), p.z()});
  return all;
}

}  // namespace

class LocalEditsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aPinIsPutDownByKeyListedFoundAndLifted();
  void theSurfaceIsSmoothedWhereItIsNearestToTheCrosshair();
  void theNearestPointOfTheSurfaceIsPulledToTheCrosshair();
  void theSurfaceIsCutAlongTheChosenPlaneAndOneSideIsKept_data();
  void theSurfaceIsCutAlongTheChosenPlaneAndOneSideIsKept();
  void withoutASurfaceOrOnALockedObjectNothingIsPinnedOrEdited();
};

void LocalEditsTest::aPinIsPutDownByKeyListedFoundAndLifted() {
  Opened o;
  QVERIFY(o.ok && o.grow());
  const Vec3 place = o.document().snapshot()->mesh.points.front();
  const int iteration = o.document().iteration();
  o.window->viewState().setCrosshair(Vec3(5, 36, 36));  // far from the surface
  const int entries = o.document().undoStack()->count();
  o.localRadius()->setValue(2);
  QTest::keyClick(o.window.get(), Qt::Key_P, Qt::ShiftModifier);
  QVERIFY2(o.window->messages().text().contains("nothing is pinned"),
           qPrintable(o.window->messages().text()));
  QCOMPARE(o.document().undoStack()->count(), entries);

  o.window->viewState().setCrosshair(place);
  QTest::mouseClick(o.choice("Pin"), Qt::LeftButton);
  QVERIFY(o.window->messages().text().startsWith("The surface is pinned here"));
  QVERIFY(o.document().constraints().pins == std::vector<Pin>({{place, 2, iteration}}));
  QCOMPARE(o.document().undoStack()->undoText(), QString("Pin here"));
  o.keepPicture("pinned");
  auto* section = o.window->findChild<ui::HeldSection*>();
  auto* table = section->findChild<QTableWidget*>();
  QCOMPARE(table->rowCount(), 1);
  QVERIFY(table->item(0, 0)->text().startsWith("Pin at iteration"));
  o.window->viewState().setCrosshair(kRight);
  QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, table->visualItemRect(table->item(0, 0)).center());
  QCOMPARE(o.window->viewState().crosshair(), place);
  QTest::mouseClick(section->findChild<QPushButton*>(), Qt::LeftButton);
  QVERIFY(o.document().constraints().empty());
  QCOMPARE(o.document().undoStack()->undoText(), QString("Lift the pin"));
  for (int i = 0; i < 2; ++i) QTest::keyClick(o.window.get(), Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(o.document().constraints().empty());
  QCOMPARE(o.document().undoStack()->undoText(), QString("Add seed"));
}

void LocalEditsTest::theSurfaceIsSmoothedWhereItIsNearestToTheCrosshair() {
  Opened o;
  QVERIFY(o.ok && o.grow());
  const TriangleSoup before = o.document().snapshot()->mesh;
  const int iteration = o.document().iteration();
  o.window->viewState().setCrosshair(kLeft - Vec3(11, 0, 0));  // beside the end of the left ball
  o.localRadius()->setValue(6);
  QSignalSpy edited(&o.document(), &ui::Document::meshEdited);
  QTest::keyClick(o.window.get(), Qt::Key_S, Qt::ShiftModifier);
  QVERIFY(!edited.isEmpty() || edited.wait(kPatience));
  QCOMPARE(o.document().iteration(), iteration + 1);
  QVERIFY(o.document().snapshot()->certificate.passes());
  QCOMPARE(o.document().undoStack()->undoText(), QString("Smooth here"));
  const MeshEdit& edit = o.document().constraints().edits.at(0);
  QVERIFY(edit.kind == MeshEditKind::smooth && edit.radius == 6);
  const TriangleSoup after = o.document().snapshot()->mesh;
  QCOMPARE(after.points.size(), before.points.size());
  const std::set<std::array<double, 3>> there = coordinates(after);
  int moved = 0;
  for (const Vec3& p : before.points) {
    if (there.contains({p.x(), p.y(), p.z()})) continue;
    ++moved;
    QVERIFY((p - edit.place).norm() <= 6);
    QVERIFY(p.x() < kLeft.x());
  }
  QVERIFY2(moved > 10, qPrintable(QString::number(moved)));
  QVERIFY2(o.window->messages().text().startsWith("Smoothed by hand: "),
           qPrintable(o.window->messages().text()));
  o.keepPicture("smoothed");
  QTest::keyClick(o.window.get(), Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(QTest::qWaitFor([&] { return o.document().iteration() == iteration; }, kPatience));
  QVERIFY(o.document().snapshot()->mesh.points == before.points);
  QVERIFY(o.document().constraints().empty());
}

void LocalEditsTest::theNearestPointOfTheSurfaceIsPulledToTheCrosshair() {
  Opened o;
  QVERIFY(o.ok && o.grow());
  const TriangleSoup before = o.document().snapshot()->mesh;
  const int iteration = o.document().iteration();
  const Vec3 there = kLeft - Vec3(11, 0, 0);
  QVERIFY(!coordinates(before).contains({there.x(), there.y(), there.z()}));
  o.window->viewState().setCrosshair(there);
  QSignalSpy edited(&o.document(), &ui::Document::meshEdited);
  QTest::keyClick(o.window.get(), Qt::Key_U, Qt::ShiftModifier);
  QVERIFY(!edited.isEmpty() || edited.wait(kPatience));
  QCOMPARE(o.document().iteration(), iteration + 1);
  QVERIFY(o.document().snapshot()->certificate.passes());
  QVERIFY(coordinates(o.document().snapshot()->mesh).contains({there.x(), there.y(), there.z()}));
  QCOMPARE(o.document().undoStack()->undoText(), QString("Pull here"));
  o.keepPicture("pulled");
  QTest::keyClick(o.window.get(), Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(QTest::qWaitFor([&] { return o.document().iteration() == iteration; }, kPatience));
  QVERIFY(o.document().snapshot()->mesh.points == before.points);
}

void LocalEditsTest::theSurfaceIsCutAlongTheChosenPlaneAndOneSideIsKept_data() {
  QTest::addColumn<bool>("fromTheLeft");
  QTest::newRow("columns to the left") << false;
  QTest::newRow("columns to the right") << true;
}

void LocalEditsTest::theSurfaceIsCutAlongTheChosenPlaneAndOneSideIsKept() {
  QFETCH(bool, fromTheLeft);
  Opened o(fromTheLeft);
  QVERIFY(o.ok && o.grow());
  const int iteration = o.document().iteration();
  const auto bodies = [&] { return o.document().snapshot()->certificate.genus.size(); };
  QCOMPARE(bodies(), std::size_t(1));
  QVERIFY(o.button("Superior") && !o.button("Left"));
  QTest::mouseClick(o.choice("Plane: Sagittal"), Qt::LeftButton);
  QVERIFY(o.button("Left") && o.button("Right") && !o.button("Superior"));
  o.window->viewState().setCrosshair(kNeck);
  QSignalSpy edited(&o.document(), &ui::Document::meshEdited);
  QTest::keyClick(o.window.get(), Qt::Key_C, Qt::ShiftModifier);
  QVERIFY(!edited.isEmpty() || edited.wait(kPatience));
  QCOMPARE(bodies(), std::size_t(2));
  QVERIFY(o.document().snapshot()->certificate.passes());
  QCOMPARE(o.document().undoStack()->undoText(), QString("Cut here"));
  o.keepPicture("cut");
  QTest::keyClick(o.window.get(), Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(QTest::qWaitFor([&] { return o.document().iteration() == iteration; }, kPatience));
  QCOMPARE(bodies(), std::size_t(1));

  for (const bool left : {true, false}) {  // larger x is further left: LPS
    QTest::mouseClick(o.choice(left ? "Keep: Left" : "Keep: Right"), Qt::LeftButton);
    edited.clear();
    QTest::mouseClick(o.button("Cut"), Qt::LeftButton);
    QVERIFY(!edited.isEmpty() || edited.wait(kPatience));
    QCOMPARE(bodies(), std::size_t(1));
    QCOMPARE(o.furthest() > kRight.x(), left);
    QTest::keyClick(o.window.get(), Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(QTest::qWaitFor([&] { return o.document().iteration() == iteration; }, kPatience));
  }
  // A plane that meets nothing: said, and no entry of the undo list is left.
  const int entries = o.document().undoStack()->count();
  o.window->viewState().setCrosshair(Vec3(1, 20, 20));
  QSignalSpy refused(&o.document(), &ui::Document::refused);
  QTest::mouseClick(o.button("Cut"), Qt::LeftButton);
  QVERIFY(!refused.isEmpty() || refused.wait(kPatience));
  QVERIFY(o.document().constraints().empty());
  QVERIFY(o.document().undoStack()->count() <= entries);
}

void LocalEditsTest::withoutASurfaceOrOnALockedObjectNothingIsPinnedOrEdited() {
  Opened o;
  QVERIFY(o.ok);
  const ui::Commands& commands = o.window->commands();
  const auto isAny = [&](bool wanted) {
    for (const Command id : {Command::pinHere, Command::smoothHere, Command::pullHere, Command::cutHere})
      if (commands[id]->isEnabled() == wanted) return true;
    return false;
  };
  QVERIFY(!isAny(true));
  o.document().run();
  QVERIFY(!isAny(true));
  QVERIFY(waitFor(*o.window, GrowthState::finished));
  QVERIFY(!isAny(false));
  o.document().setObjectLocked(0, true);
  QVERIFY(!isAny(true));
  o.document().setObjectLocked(0, false);
  QVERIFY(!isAny(false));
  o.document().addObject();
  QVERIFY(!isAny(true));
}

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  QApplication::setOrganizationName("Handlebody");
  QApplication::setApplicationName("handlebody-test");
  LocalEditsTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "local_edits_test.moc"
