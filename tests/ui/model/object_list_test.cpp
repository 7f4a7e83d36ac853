// The Document's list of objects: how it is changed, what each object keeps, what becomes of those that come
// later.

#include <QUndoStack>
#include <set>

#include "core/collision/body_contact.h"
#include "tests/ui/model/objects_support.h"

using namespace handlebody;
using namespace handlebody::ui;

TEST_CASE("a click into what grows is grown also where another object becomes active at once", "[objects]") {
  ObjectsWork work;
  Document& document = work.document;
  document.addSeed(work.torus.seed);
  document.addObject();
  document.setActiveObject(0);
  document.run();
  REQUIRE(waitFor([&] { return document.iteration() >= 5; }));
  document.addSeed({testing::kMiddle - Vec3(testing::kTorusR, 0, 0), 2.0});
  document.setActiveObject(1);
  const auto isDone = [&] { return document.objectInfo(0).state == GrowthState::finished; };
  CHECK(waitFor(isDone, 60));
  document.setActiveObject(0);
  CHECK(document.corrections().size() == 1);
}

TEST_CASE("whoever shows the iteration of a locked object is told that it stays", "[objects]") {
  ObjectsWork work;
  Document& document = work.document;
  work.growFirst(5);
  document.setObjectLocked(0, true);
  int told = 0;
  QObject::connect(&document, &Document::stateChanged, [&] { ++told; });
  document.goTo(2);
  CHECK(told == 1);
  CHECK(document.iteration() == 5);
}

TEST_CASE("the list of objects is changed and every change undone by its name", "[objects]") {
  ObjectsWork work;
  Document& document = work.document;
  QUndoStack& undo = *document.undoStack();
  CHECK(document.objectCount() == 1);
  CHECK(nameOf(document, 0) == "Object");
  document.addObject();
  CHECK(document.activeObject() == 1);
  rename(document, 1, "Cyst");
  document.addObject();
  CHECK(namesOf(document) == "Object,Cyst,Object 3");
  document.moveObject(2, 0);
  CHECK(namesOf(document) == "Object 3,Object,Cyst");
  CHECK(document.activeObject() == 0);
  document.removeObject(0);
  CHECK(namesOf(document) == "Object,Cyst");
  CHECK(document.activeObject() == 0);
  document.setObjectVisible(1, false);
  document.setObjectLocked(1, true);
  CHECK_FALSE(document.objectInfo(1).visible);
  CHECK(document.objectInfo(1).locked);

  for (const char* text : {"Lock object", "Hide object", "Delete object"}) {
    CHECK(undo.undoText() == QLatin1String(text));
    undo.undo();
  }
  CHECK(namesOf(document) == "Object 3,Object,Cyst");
  CHECK(document.objectInfo(2).visible);
  for (const char* text : {"Move object in the list", "Add object", "Rename object", "Add object"}) {
    CHECK(undo.undoText() == QLatin1String(text));
    undo.undo();
  }
  CHECK(namesOf(document) == "Object");
  CHECK_FALSE(document.isModified());
  while (undo.canRedo()) undo.redo();
  CHECK(namesOf(document) == "Object,Cyst");
  document.removeObject(1);  // locked
  CHECK(work.failed.contains(QLatin1String("locked")));
  CHECK(document.objectCount() == 2);
  undo.undo();
  document.removeObject(1);
  document.removeObject(0);  // the last one stays
  CHECK(document.objectCount() == 1);
}

TEST_CASE("names, label values and colours are such as no other object has", "[objects]") {
  ObjectsWork work;
  Document& document = work.document;
  for (int i = 0; i < 12; ++i) document.addObject();
  std::set<std::string> names;
  std::set<int> values;
  for (int i = 0; i < document.objectCount(); ++i) {
    const ObjectLabel label = document.objectInfo(i).label;
    names.insert(label.name);
    values.insert(label.value);
    CHECK(document.objectLabelFault(i, label).isEmpty());
  }
  CHECK(names.size() == 13);
  CHECK(values.size() == 13);
  ObjectLabel label = document.objectInfo(1).label;
  label.name = "Object";
  CHECK(document.objectLabelFault(1, label).contains(QLatin1String("Object")));
  label.name = "a|b";
  CHECK_FALSE(document.objectLabelFault(1, label).isEmpty());
  label.name = "Cyst";
  label.value = 1;
  CHECK_FALSE(document.objectLabelFault(1, label).isEmpty());
}

TEST_CASE("each object keeps its own seeds, parameters and growth", "[objects]") {
  ObjectsWork work;
  Document& document = work.document;
  work.growFirst(8);
  const auto first = document.snapshot();
  document.addObject();
  CHECK(document.seeds().empty());
  CHECK(document.iteration() == -1);
  CHECK(document.state() == GrowthState::none);
  CHECK(document.objectInfo(0).snapshot == first);
  Parameters p = document.parameters();
  p.curvature = 0.4;
  document.setParameters(p, QStringLiteral("Change curvature"));
  document.setActiveObject(0);
  CHECK(document.parameters().curvature == 0.2);
  CHECK(document.seeds().size() == 1);
  CHECK(document.iteration() == 8);
  CHECK(document.snapshot() == first);
  SECTION("and the timeline of one that was not shown can be gone back in") {
    REQUIRE(showIteration(document, 3));
    REQUIRE(work.stepTo(8));
    CHECK(isSame(document.snapshot()->mesh, first->mesh));
  }
  SECTION("undoing a change of another one makes that active") {
    document.undoStack()->undo();
    CHECK(document.activeObject() == 1);
    CHECK(document.parameters().curvature == 0.2);
  }
  SECTION("one that is deleted comes back with its growth") {
    document.removeObject(0);
    CHECK(document.objectCount() == 1);
    CHECK(document.iteration() == -1);
    document.undoStack()->undo();
    CHECK(document.activeObject() == 0);
    CHECK(document.iteration() == 8);
    CHECK(isSame(document.snapshot()->mesh, first->mesh));
  }
  SECTION("a copy has the seeds and parameters, not the growth") {
    document.duplicateObject(0);
    CHECK(document.activeObject() == 1);
    CHECK(document.seeds().size() == 1);
    CHECK(document.iteration() == -1);
    CHECK(document.objectCount() == 3);
  }
}

TEST_CASE("one that grows goes on while another is shown", "[objects]") {
  ObjectsWork work;
  Document& document = work.document;
  document.addSeed(work.torus.seed);
  document.addObject();
  document.setActiveObject(0);
  document.run();
  document.setActiveObject(1);
  document.addSeed(work.opposite());
  CHECK(waitFor([&] { return document.objectInfo(0).state == GrowthState::finished; }));
  CHECK(document.activeObject() == 1);
  CHECK(document.iteration() == -1);
}

TEST_CASE("what was made with an earlier surface is told, not exported where they meet, and grown anew",
          "[objects]") {
  ObjectsWork work;
  Document& document = work.document;
  work.growFirst();
  work.growSecond();
  const auto second = document.snapshot();
  document.setActiveObject(0);
  SECTION("one that grew on") {
    document.run();
    REQUIRE(waitFor([&] { return document.state() == GrowthState::finished; }));
    CHECK(document.objectInfo(1).madeWithEarlier == QLatin1String("Object"));
    CHECK(document.objectInfo(1).state == GrowthState::paused);
    CHECK(document.notReplayed() == QStringList{QStringLiteral("Object 2")});
    const QString file = work.torus.file("all.seg.nrrd");
    CHECK_FALSE(work.exportAll(file));
    CHECK(work.failed.contains(QLatin1String("Object 2")));
    CHECK_FALSE(QFile::exists(file));
  }
  SECTION("one that went a step back") {
    document.stepBack();
    REQUIRE(waitFor([&] { return document.iteration() == 24; }));
    CHECK(document.objectInfo(1).madeWithEarlier == QLatin1String("Object"));
    CHECK(work.exportAll(work.torus.file("all.seg.nrrd")));  // it only shrank: they do not meet
    document.setActiveObject(1);
    document.run();
    REQUIRE(waitFor([&] { return document.state() == GrowthState::finished; }));
    CHECK(document.objectInfo(1).madeWithEarlier.isEmpty());
    CHECK_FALSE(isSame(document.snapshot()->mesh, second->mesh));
    CHECK(bodyContact(document.objectInfo(0).snapshot->mesh, document.snapshot()->mesh) == BodyContact::none);
  }
  SECTION("one that went back and came again as it was") {
    REQUIRE(showIteration(document, 3));
    CHECK_FALSE(document.objectInfo(1).madeWithEarlier.isEmpty());
    REQUIRE(showIteration(document, 25));
    CHECK(document.objectInfo(1).madeWithEarlier.isEmpty());
    CHECK(document.objectInfo(1).state == GrowthState::finished);
  }
  SECTION("another order, and undo") {
    document.moveObject(1, 0);
    CHECK_FALSE(document.objectInfo(0).madeWithEarlier.isEmpty());
    CHECK_FALSE(document.objectInfo(1).madeWithEarlier.isEmpty());
    CHECK(work.exportAll(work.torus.file("all.seg.nrrd")));
    document.undoStack()->undo();
    CHECK(document.objectInfo(1).madeWithEarlier.isEmpty());
  }
  SECTION("all are grown in their order") {
    REQUIRE(showIteration(document, 12));
    document.runAll();
    REQUIRE(waitFor([&] {
      return document.objectInfo(0).state == GrowthState::finished && !document.objectInfo(1).snapshot &&
             document.objectInfo(1).state == GrowthState::none;
    }));  // nothing is left of the torus: the second one's seed lies in the first
  }
}

TEST_CASE(
    "who is told of a change finds the active object in the list, when it is deleted while it grows too",
    "[objects]") {
  ObjectsWork work;
  Document& document = work.document;
  document.addObject();
  document.addSeed(work.torus.seed);
  int told = 0, lost = 0;
  const auto look = [&] {
    ++told;
    if (document.activeObject() < 0) ++lost;
  };
  for (auto changed : {&Document::stateChanged, &Document::snapshotChanged, &Document::objectsChanged})
    QObject::connect(&document, changed, &document, look);
  document.run();
  REQUIRE(waitFor([&] { return document.iteration() >= 1; }));
  told = 0;
  document.removeObject(1);
  CHECK(told > 0);
  document.undoStack()->undo();  // back, and shown
  CHECK(document.activeObject() == 1);
  document.undoStack()->redo();
  CHECK(document.activeObject() == 0);
  CHECK(lost == 0);
}

TEST_CASE("a locked object is not changed", "[objects]") {
  ObjectsWork work;
  Document& document = work.document;
  work.growFirst(6);
  document.setObjectLocked(0, true);
  document.addSeed(work.opposite());
  CHECK(document.seeds().size() == 1);
  CHECK(work.failed.contains(QLatin1String("locked")));
  document.stepForward();
  document.stepBack();
  document.run();
  waitMilliseconds(100);
  CHECK(document.iteration() == 6);
  CHECK(document.state() == GrowthState::paused);
}

TEST_CASE("changes of one gesture in two objects are two, and none goes into the other object", "[objects]") {
  ObjectsWork work;
  Document& document = work.document;
  const Seed first = work.torus.seed, second = work.opposite();
  document.addSeed(first);
  document.addObject();
  document.addSeed(second);
  document.setActiveObject(0);
  document.setSeedRadius(0, 2.5, 7);
  document.setActiveObject(1);
  document.setSeedRadius(0, 3.5, 7);
  QUndoStack& undo = *document.undoStack();
  const int all = undo.count();
  undo.undo();
  CHECK(document.activeObject() == 1);
  CHECK(document.seeds() == std::vector{second});
  undo.undo();
  CHECK(document.activeObject() == 0);
  CHECK(document.seeds() == std::vector{first});
  undo.redo();
  CHECK(document.seeds() == std::vector{Seed{first.centre, 2.5}});
  undo.redo();
  CHECK(document.activeObject() == 1);
  CHECK(document.seeds() == std::vector{Seed{second.centre, 3.5}});
  CHECK(undo.index() == all);
}
