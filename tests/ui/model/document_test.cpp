// Opening, seeds, parameters, undo.

#include "tests/ui/dumbbell.h"
#include "tests/ui/model/document_support.h"

using namespace handlebody;
using namespace handlebody::ui;

namespace {

struct DumbbellFile {
  QTemporaryDir folder;
  QString path = folder.filePath(QStringLiteral("dumbbell.mha"));

  DumbbellFile() { writeVolume(testing::dumbbellVolume(), path.toStdString()); }
};

//! Opens the dumbbell with a seed in its left ball and waits until the objects are known.
bool openToChoose(Document& document, const DumbbellFile& file) {
  if (!openAndWait(document, file.path)) return false;
  document.addSeed({testing::kLeftBall, std::nullopt});
  return waitFor([&] { return document.resolved().has_value(); });
}

//! A way that there is from the object that is taken.
SizeStep anyStep(const Document& document) {
  return neighbour(document.candidateChoice(), SizeStep::larger) ? SizeStep::larger : SizeStep::smaller;
}

bool isResolved(const Document& document) { return document.resolved().has_value(); }

}  // namespace

TEST_CASE("a volume is opened on another thread", "[document]") {
  const TorusFile torus;
  Document document;
  document.open(torus.path);
  CHECK(document.isOpening());
  CHECK_FALSE(document.hasVolume());
  REQUIRE(waitFor([&] { return document.hasVolume(); }));
  CHECK_FALSE(document.isOpening());
  CHECK(document.volume().grid.size == std::array{41, 41, 41});
  CHECK(document.info().format == "MetaImage");
  CHECK(document.path() == torus.path);
  CHECK_FALSE(document.isModified());
}

TEST_CASE("a file that cannot be opened leaves the open work alone", "[document]") {
  const TorusFile torus;
  Document document;
  REQUIRE(openAndWait(document, torus.path));
  document.addSeed(torus.seed);
  QString sentence;
  QObject::connect(&document, &Document::openFailed, [&](const QString& text) { sentence = text; });
  QFile broken(torus.file("broken.nii"));
  REQUIRE(broken.open(QIODevice::WriteOnly));
  broken.write("this is no volume");
  broken.close();
  QFile other(torus.file("other.json"));
  REQUIRE(other.open(QIODevice::WriteOnly));
  other.write("{\"version\": 7}");
  other.close();
  for (const QString& path : {broken.fileName(), other.fileName(), torus.file("missing.mha"), QString()}) {
    sentence.clear();
    CHECK_FALSE(openAndWait(document, path));
    INFO(sentence.toStdString());
    CHECK(sentence.endsWith(QLatin1Char('.')));
    CHECK(document.path() == torus.path);
    CHECK(document.seeds().size() == 1);
  }
}

TEST_CASE("a cancelled opening opens nothing", "[document]") {
  const TorusFile torus;
  Document document;
  document.open(torus.path);
  document.cancelOpening();
  waitMilliseconds(500);
  CHECK_FALSE(document.hasVolume());
}

TEST_CASE("what was read waits for the word where it is to, and what is open stays", "[document]") {
  const TorusFile torus, other;
  Document document;
  int waits = 0, cancelled = 0;
  QObject::connect(&document, &Document::openingWaits, [&] { ++waits; });
  QObject::connect(&document, &Document::openingCancelled, [&] { ++cancelled; });
  REQUIRE(openAndWait(document, torus.path));
  CHECK(waits == 0);
  document.setOpeningWaits(true);
  document.addSeed(torus.seed);
  document.open(other.path);
  CHECK_FALSE(document.isChangedSinceOpen());
  document.addSeed({testing::kMiddle - Vec3(testing::kTorusR, 0, 0), 3.0});
  REQUIRE(waitFor([&] { return waits == 1; }));
  CHECK(document.isOpeningWaiting());
  CHECK(document.isOpening());
  CHECK(document.isChangedSinceOpen());
  CHECK(document.path() == torus.path);
  SECTION("it takes the place of that") {
    document.finishOpening();
    CHECK(document.path() == other.path);
    CHECK_FALSE(document.isModified());
  }
  SECTION("it is not wanted") {
    document.cancelOpening();
    CHECK(cancelled == 1);
    CHECK(document.path() == torus.path);
    CHECK(document.seeds().size() == 2);
    document.finishOpening();
    CHECK(document.path() == torus.path);
  }
  SECTION("another one is opened instead") {
    document.open(torus.path);
    CHECK_FALSE(document.isOpeningWaiting());
    CHECK_FALSE(document.isChangedSinceOpen());
  }
  CHECK_FALSE(document.isOpeningWaiting());
}

TEST_CASE("of two openings the newer one wins", "[document]") {
  const TorusFile torus, other;
  Document document;
  document.open(torus.path);
  document.open(other.path);
  REQUIRE(waitFor([&] { return document.hasVolume(); }));
  CHECK(document.path() == other.path);
}

TEST_CASE("every change of the seeds is undone and done again by its name", "[document]") {
  const TorusFile torus;
  Document document;
  REQUIRE(openAndWait(document, torus.path));
  QUndoStack& undo = *document.undoStack();
  document.addSeed(torus.seed);
  CHECK(undo.undoText() == QStringLiteral("Add seed"));
  CHECK(document.selectedSeed() == 0);
  const Vec3 there = torus.seed.centre + Vec3(1, 2, 3);
  document.moveSeed(0, there);
  CHECK(undo.undoText() == QStringLiteral("Move seed"));
  document.setSeedRadius(0, 2.5);
  CHECK(undo.undoText() == QStringLiteral("Change seed radius"));
  document.removeSeed(0);
  CHECK(undo.undoText() == QStringLiteral("Delete seed"));
  CHECK(document.seeds().empty());
  CHECK(document.selectedSeed() == -1);
  undo.undo();
  REQUIRE(document.seeds().size() == 1);
  CHECK(document.seeds()[0] == Seed{there, 2.5});
  CHECK(document.selectedSeed() == 0);
  undo.undo();
  undo.undo();
  CHECK(document.seeds()[0] == torus.seed);
  undo.undo();
  CHECK(document.seeds().empty());
  CHECK_FALSE(document.isModified());
  while (undo.canRedo()) undo.redo();
  CHECK(document.seeds().empty());
  CHECK(document.isModified());
}

TEST_CASE("a click outside is undone by its own name", "[document]") {
  const TorusFile torus;
  Document document;
  REQUIRE(openAndWait(document, torus.path));
  QUndoStack& undo = *document.undoStack();
  const Seed outside{torus.seed.centre, std::nullopt, true};
  document.addSeed(outside);
  CHECK(undo.undoText() == QStringLiteral("Add click outside"));
  document.moveSeed(0, torus.seed.centre + Vec3(1, 0, 0));
  CHECK(undo.undoText() == QStringLiteral("Move click outside"));
  document.setSeedRadius(0, 2.5);
  CHECK(undo.undoText() == QStringLiteral("Change radius of click outside"));
  CHECK(document.shownRadius(0) == 2.5);
  CHECK(document.seeds()[0].background);
  document.removeSeed(0);
  CHECK(undo.undoText() == QStringLiteral("Delete click outside"));
  CHECK(document.seeds().empty());
  for (int i = 0; i < 3; ++i) undo.undo();
  REQUIRE(document.seeds().size() == 1);
  CHECK(document.seeds()[0] == outside);
}

TEST_CASE("a click that contradicts another is refused, and nothing is changed", "[document]") {
  const TorusFile torus;
  Document document;
  REQUIRE(openAndWait(document, torus.path));
  document.addSeed({torus.seed.centre, std::nullopt});
  QString sentence;
  QObject::connect(&document, &Document::refused, [&](const QString& text) { sentence = text; });
  document.addSeed({torus.seed.centre, std::nullopt, true});
  CHECK(document.seeds().size() == 1);
  CHECK(sentence.contains(QStringLiteral("contradict each other")));
  document.addSeed({torus.seed.centre + 2 * document.volume().grid.spacing, std::nullopt, true});
  CHECK(document.seeds().size() == 2);
}

TEST_CASE("clicks outside alone are nothing to grow from or to save", "[document]") {
  const TorusFile torus;
  Document document;
  REQUIRE(openAndWait(document, torus.path));
  CHECK_FALSE(document.isSeeded());
  document.addSeed({torus.seed.centre + Vec3(0, 0, 8), 3.0, true});
  CHECK_FALSE(document.isSeeded());
  document.run();
  waitMilliseconds(400);  // longer than changes settle
  CHECK(document.state() == GrowthState::none);
  CHECK(document.growthError().contains(QStringLiteral("no seed yet")));
  CHECK_FALSE(document.resolved());
  CHECK(document.resolveError().isEmpty());
  QString sentence;
  QObject::connect(&document, &Document::saveFailed, [&](const QString& text) { sentence = text; });
  document.saveSession(torus.file("outside.json"));
  CHECK(sentence.contains(QStringLiteral("needs a seed")));
  document.addSeed(torus.seed);
  CHECK(document.isSeeded());
}

TEST_CASE("other clicks and another kind of object begin with the likeliest object again", "[document]") {
  const TorusFile torus;
  Document document;
  REQUIRE(openAndWait(document, torus.path));
  document.addSeed(torus.seed);
  const auto chooseSecond = [&] {
    Parameters parameters = document.parameters();
    parameters.candidate = 2;
    document.setParameters(parameters, QStringLiteral("Larger object"));
    CHECK(document.parameters().candidate == 2);
  };
  const auto expectFirstUntilUndone = [&] {
    CHECK(document.parameters().candidate == 1);
    document.undoStack()->undo();
    CHECK(document.parameters().candidate == 2);
  };
  chooseSecond();
  document.addSeed({torus.seed.centre + Vec3(9, 0, 0), std::nullopt, true});
  expectFirstUntilUndone();
  document.moveSeed(0, torus.seed.centre + Vec3(1, 0, 0));
  expectFirstUntilUndone();
  Parameters bright = document.parameters();
  bright.object = ObjectKind::bright;
  document.setParameters(bright, QStringLiteral("Change object"));
  expectFirstUntilUndone();
  document.setSeedRadius(0, 2.0);  // the click lies where it lay
  CHECK(document.parameters().candidate == 2);
}

TEST_CASE("without candidates no step changes anything", "[document]") {
  Document document;
  CHECK(document.candidateChoice().candidates.empty());
  CHECK(document.candidateChoice().chosen == 0);
  for (SizeStep step : {SizeStep::smaller, SizeStep::larger}) document.chooseCandidate(step);
  CHECK(document.undoStack()->count() == 0);
}

TEST_CASE("a smaller or larger object is known at once, and undone by its name", "[document][candidates]") {
  const DumbbellFile file;
  Document document;
  REQUIRE(openToChoose(document, file));
  const CandidateChoice before = document.candidateChoice();
  REQUIRE(before.candidates.size() >= 2);
  CHECK(before.chosen == 1);
  const SizeStep step = anyStep(document);
  const int next = neighbour(before, step).value();
  document.chooseCandidate(step);
  CHECK(document.undoStack()->undoText() ==
        (step == SizeStep::larger ? QStringLiteral("Larger object") : QStringLiteral("Smaller object")));
  CHECK(document.parameters().candidate == next);
  CHECK_FALSE(isResolved(document));  // one can step on without waiting
  CHECK(document.candidateChoice().candidates.size() == before.candidates.size());
  CHECK(document.candidateChoice().chosen == next);
  REQUIRE(waitFor([&] { return isResolved(document); }));
  CHECK(document.resolved()->candidate == next);
  CHECK(document.candidateChoice().candidates.size() == before.candidates.size());
  document.undoStack()->undo();
  CHECK(document.candidateChoice().chosen == 1);
}

TEST_CASE("other clicks and a given range leave no objects of before", "[document][candidates]") {
  const DumbbellFile file;
  Document document;
  REQUIRE(openToChoose(document, file));
  REQUIRE(document.candidateChoice().candidates.size() >= 2);
  document.addSeed({testing::kRightBall, std::nullopt, true});
  CHECK(document.candidateChoice().candidates.empty());
  REQUIRE(waitFor([&] { return isResolved(document); }));
  CHECK_FALSE(document.candidateChoice().candidates.empty());
  Parameters parameters = document.parameters();
  parameters.range = IntensityRange{-std::numeric_limits<double>::infinity(), 100};
  document.setParameters(parameters, QStringLiteral("Change range"));
  CHECK(document.candidateChoice().candidates.empty());
}

TEST_CASE("another object that is taken after the growth is grown with from there on",
          "[document][candidates]") {
  const DumbbellFile file;
  Document document;
  REQUIRE(openToChoose(document, file));
  REQUIRE(document.candidateChoice().candidates.size() >= 2);
  REQUIRE(runToEnd(document));
  document.chooseCandidate(anyStep(document));
  CHECK(document.state() == GrowthState::paused);  // as after any other change of a parameter
  REQUIRE(runToEnd(document));
  CHECK(document.growthError().isEmpty());
  CHECK(document.snapshot()->certificate.passes());
}

TEST_CASE("one drag is one entry, the next drag another", "[document]") {
  const TorusFile torus;
  Document document;
  REQUIRE(openAndWait(document, torus.path));
  document.addSeed(torus.seed);
  for (int gesture : {1, 2})
    for (int i = 1; i <= 5; ++i) document.moveSeed(0, torus.seed.centre + Vec3(i, gesture, 0), gesture);
  CHECK(document.undoStack()->count() == 3);
  document.undoStack()->undo();
  CHECK(document.seeds()[0].centre == Vec3(torus.seed.centre + Vec3(5, 1, 0)));
  document.undoStack()->undo();
  CHECK(document.seeds()[0] == torus.seed);
}

TEST_CASE("the list of what can be undone has an end, so that a long session does not grow", "[document]") {
  Document document;
  QUndoStack& undo = *document.undoStack();
  REQUIRE(undo.undoLimit() > 0);
  for (int i = 0; i < undo.undoLimit() + 50; ++i) {
    Parameters parameters = document.parameters();
    parameters.balloon = 0.1 + 1e-3 * i;
    document.setParameters(parameters, QStringLiteral("Change balloon"));
  }
  CHECK(undo.count() == undo.undoLimit());
}

TEST_CASE("a document with unsaved edits goes without a word", "[document]") {
  const TorusFile torus;
  auto document = std::make_unique<Document>();
  REQUIRE(openAndWait(*document, torus.path));
  document->addSeed(torus.seed);
  REQUIRE(document->isModified());
  int said = 0;  // its undo list is cleared when half of it is gone already
  QObject::connect(document.get(), &Document::modifiedChanged, [&] { ++said; });
  document.reset();
  CHECK(said == 0);
}

TEST_CASE("parameters are undone under the name they were changed by", "[document]") {
  const TorusFile torus;
  Document document;
  REQUIRE(openAndWait(document, torus.path));
  int told = 0;
  QObject::connect(&document, &Document::parametersChanged, [&] { ++told; });
  Parameters p = document.parameters();
  p.curvature = 0.5;
  document.setParameters(p, QStringLiteral("Change curvature"));
  CHECK(document.undoStack()->undoText() == QStringLiteral("Change curvature"));
  document.setParameters(p, QStringLiteral("Change curvature"));
  CHECK(document.undoStack()->count() == 1);
  document.undoStack()->undo();
  CHECK(document.parameters() == Parameters{});
  CHECK(told == 2);
}

TEST_CASE("the automatic parameters follow the seeds", "[document]") {
  const TorusFile torus;
  Document document;
  REQUIRE(openAndWait(document, torus.path));
  CHECK_FALSE(document.resolved().has_value());
  document.addSeed({torus.seed.centre, {}});
  REQUIRE(waitFor([&] { return document.resolved().has_value(); }));
  CHECK(document.resolved()->object == ObjectKind::dark);
  CHECK(document.shownRadius(0) == *document.resolved()->seeds[0].radius);
  document.moveSeed(0, Vec3(1000, 0, 0));
  REQUIRE(waitFor([&] { return !document.resolveError().isEmpty(); }));
  CHECK_FALSE(document.resolved().has_value());
  CHECK(document.resolveError().contains(QStringLiteral("outside the volume")));
  document.undoStack()->undo();
  REQUIRE(waitFor([&] { return document.resolved().has_value(); }));
  CHECK(document.resolveError().isEmpty());
}
