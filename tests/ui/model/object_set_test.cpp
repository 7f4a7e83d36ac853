#include "ui/model/object_set.h"

#include "tests/support/catch.h"
#include "ui/model/corrected_frames.h"

using namespace handlebody;
using namespace handlebody::ui;

namespace {

//! Nothing is open, and nobody listens.
struct QuietHost : ObjectHost {
  const Volume* openVolume() const override { return nullptr; }
  std::vector<FinishedWall> wallsFor(const ObjectWork&) const override { return {}; }
  bool mustWait(const ObjectWork&) const override { return false; }
  void changed(const ObjectWork&, Part) override {}
  void worthKeeping(const ObjectWork&) override {}
  void traced(const ObjectWork&, int, const EventTrace&) override {}
  void leaked(const ObjectWork&, int) override {}
  void asked(const ObjectWork&) override {}
  void edited(const ObjectWork&) override {}
  void editRefused(ObjectWork&, const MeshEdit&, const QString&) override {}
};

struct ThreeObjects {
  QuietHost host;
  std::vector<ObjectSet::Object> made;
  ObjectSet objects;

  ThreeObjects() {
    for (const char* name : {"a", "b", "c"}) {
      made.push_back(std::make_shared<ObjectWork>(host));
      made.back()->traits.label.name = name;
    }
    objects.hold(made, made[1]);
  }
};

}  // namespace

TEST_CASE("objects are found by their place, and those after one in their order", "[objects]") {
  const ThreeObjects t;
  for (int i = 0; i < 3; ++i) {
    CHECK(t.objects.indexOf(*t.made[i]) == i);
    CHECK(&t.objects.at(i) == t.made[i].get());
  }
  CHECK(t.objects.active() == t.made[1]);
  CHECK(t.objects.after(*t.made[0]) == std::vector{t.made[1], t.made[2]});
  CHECK(t.objects.after(*t.made[2]).empty());
  QuietHost host;
  const ObjectWork other(host);
  CHECK(t.objects.indexOf(other) == -1);
  CHECK(t.objects.after(other).empty());
  CHECK_THROWS_AS(t.objects.at(3), std::out_of_range);
}

TEST_CASE("the list of objects holds them with what they are called, and which is active", "[objects]") {
  ThreeObjects t;
  const ObjectList list = t.objects.list();
  REQUIRE(list.entries.size() == 3);
  CHECK(list.entries[2].object == t.made[2]);
  CHECK(list.entries[2].traits.label.name == "c");
  CHECK(list.active == t.made[1]);
  t.objects.hold({t.made[2]}, t.made[2]);
  CHECK(t.objects.size() == 1);
  CHECK(t.objects.labels().front().name == "c");
  t.objects.add(t.made[0]);
  t.objects.activate(t.made[0]);
  CHECK(t.objects.list().entries[1].object == t.made[0]);
  CHECK(t.objects.active() == t.made[0]);
}

TEST_CASE("objects without a growth are walls for nobody, and nobody waits for them", "[objects]") {
  const ThreeObjects t;
  CHECK(t.objects.wallsFor(*t.made[2]).empty());
  CHECK_FALSE(t.objects.mustWait(*t.made[2]));
  CHECK(t.objects.madeWithEarlier(*t.made[2]).isEmpty());
  CHECK_FALSE(t.objects.isGrown());
  CHECK_FALSE(t.objects.isSeeded());
  CHECK(t.objects.isAsSaved());
  Edits edits;
  edits.seeds.push_back({Vec3(1, 2, 3), 1.0});
  t.made[2]->start(edits);
  CHECK(t.objects.isSeeded());
  t.made[0]->setSavedIteration(3);
  CHECK_FALSE(t.objects.isAsSaved());
}

TEST_CASE("while a frame is corrected the object of the grown frame is put away once, and taken back",
          "[objects]") {
  const ThreeObjects t;
  CorrectedFrames corrected;
  CHECK_FALSE(corrected.isOpen());
  corrected.add({4, t.made[0], {}});
  corrected.add({5, t.made[1], {}});
  CHECK(corrected.at(4)->object == t.made[0]);
  CHECK(corrected.of(t.made[1])->frame == 5);
  CHECK_FALSE(corrected.at(6));
  CHECK_FALSE(corrected.of(t.made[2]));
  corrected.putAway(t.made[2], {});
  corrected.putAway(t.made[0], {});  // from one frame to another
  CHECK(corrected.home() == t.made[2]);
  corrected.forget();
  CHECK_FALSE(corrected.at(4));
  CHECK(corrected.isOpen());
  CHECK(corrected.takeBack().first == t.made[2]);
  CHECK_FALSE(corrected.isOpen());
}
