// What the surface may not do: walls, vetoes, pins, and what is allowed again.

#include <QLocale>
#include <algorithm>

#include "core/evolution/painted_pins.h"
#include "core/evolution/painted_walls.h"
#include "ui/model/document_private.h"

namespace handlebody::ui {

namespace {

//! What a seed keeps at least, mm: about the shortest edge of a mesh, and what stays free before a wall.
double leastRoom(const Document& document) {
  constexpr double kShortest = 0.55, kFree = 0.1;  // edge lengths, voxels
  const double voxel = document.volume().grid.meanSpacing();
  const double edge = document.resolved() ? document.resolved()->edgeLength : voxel;
  return kShortest * edge + kFree * voxel;
}

QString written(const Vec3& place) {
  const auto number = [](double value) { return QLocale().toString(value, 'f', 1); };
  return QStringLiteral("%1, %2, %3").arg(number(place.x()), number(place.y()), number(place.z()));
}

}  // namespace

const Constraints& Document::constraints() const { return d_->active().edits().constraints; }

void Document::setConstraints(const Constraints& constraints, const QString& undoText, int gesture) {
  if (constraints == this->constraints()) return;
  Edits after = d_->active().edits();
  after.constraints = constraints;
  d_->push(undoText, std::move(after), gesture);
}

bool Document::paintWalls(const std::vector<WallBall>& stroke) {
  const Grid& grid = volume().grid;
  const std::vector<WallBall> inside = reachingInto(grid, stroke);
  if (inside.empty()) {
    Q_EMIT refused(tr("The wall would lie outside of the volume: it is not kept."));
    return false;
  }
  if (const int seed = coveredSeed(seeds(), inside, leastRoom(*this)); seed >= 0) {
    Q_EMIT refused(
        tr("The wall would lie over the seed at %1 mm: it is not kept.").arg(written(seeds()[seed].centre)));
    return false;
  }
  Constraints after = constraints();
  after.walls = painted(std::move(after.walls), inside);
  setConstraints(after, tr("Paint wall"));
  return true;
}

void Document::eraseWalls(const std::vector<WallBall>& eraser) {
  Constraints after = constraints();
  after.walls = erased(std::move(after.walls), eraser);
  setConstraints(after, tr("Erase wall"));
}

const std::optional<WallConflict>& Document::wallConflict() const { return d_->active().wallConflict(); }

bool Document::Private::mayPin() {
  const auto shown = q.snapshot();
  const bool rests = q.state() != GrowthState::running && q.state() != GrowthState::preparing;
  if (!shown || !rests || !mayChange()) return false;
  if (active().growth().isUpToDate()) return true;
  Q_EMIT q.refused(tr("The surface has not come to rest yet: nothing is pinned."));
  return false;
}

bool Document::pin(const Vec3& centre, double radius) { return d_->pin({{centre, radius}}, tr("Pin here")); }

bool Document::pin(const std::vector<WallBall>& stroke) { return d_->pin(stroke, tr("Pin")); }

bool Document::Private::pin(const std::vector<WallBall>& stroke, const QString& undoText) {
  if (stroke.empty() || !mayPin()) return false;
  const auto shown = q.snapshot();
  const std::vector<Vec3>& points = shown->mesh.points;
  Constraints after = q.constraints();
  const auto known = heldBy(after.pins, points, shown->pinnedVertices, shown->iteration);
  const std::vector<bool> none(points.size(), false);
  const std::vector<Pin> fresh = pinsOf(stroke, points, known, shown->iteration);
  if (fresh.empty()) {
    const bool isAny = !pinsOf(stroke, points, none, shown->iteration).empty();
    const QString where = written(stroke.front().centre);
    Q_EMIT q.refused(isAny ? tr("This part of the surface is pinned already.")
                           : tr("No vertex of the surface lies within %1 mm of %2 mm: nothing is pinned.")
                                 .arg(QLocale().toString(stroke.front().radius, 'g', 4), where));
    return false;
  }
  after.pins.insert(after.pins.end(), fresh.begin(), fresh.end());
  q.setConstraints(after, undoText);
  return true;
}

void Document::unpin(const std::vector<WallBall>& eraser) {
  if (!d_->mayPin()) return;
  const auto shown = snapshot();
  Constraints after = constraints();
  const auto held = heldBy(after.pins, shown->mesh.points, shown->pinnedVertices, shown->iteration);
  after.pins = unpinned(std::move(after.pins), eraser, shown->mesh.points, held);
  setConstraints(after, tr("Unpin"));
}

void Document::goOnBeforeWalls() {
  if (d_->mayChange()) d_->active().goOnBeforeWalls();
}

void Document::forbid(int index) {
  const Event& event = events().at(static_cast<std::size_t>(index));
  if (event.edit) return leaveOutEdit(event.iteration);
  const bool isMeeting = event.kind == EventKind::handleInserted;
  Edits after = d_->active().edits();
  after.constraints.vetoes.push_back({event.iteration, event.location});
  if (!d_->mayChange()) return;
  goTo(event.iteration - 1);
  d_->push(isMeeting ? tr("Keep apart") : tr("Keep as it is"), std::move(after), -1);
}

void Document::wallAt(int index) {
  const FoundLeak found = leaks().at(static_cast<std::size_t>(index));
  Edits after = d_->active().edits();
  after.constraints.walls.discs.push_back(found.leak.disc);
  if (!d_->mayChange()) return;
  goTo(found.before);
  d_->push(tr("Wall here"), std::move(after), -1);
}

void Document::allow(const HeldPlace& held) {
  Edits after = d_->active().edits();
  std::vector<Veto>& vetoes = after.constraints.vetoes;
  const auto distance = [&](const Veto& v) {
    return v.iteration == held.iteration ? (v.place - held.place).norm() : 1e300;
  };
  const auto nearest = std::min_element(
      vetoes.begin(), vetoes.end(), [&](const Veto& a, const Veto& b) { return distance(a) < distance(b); });
  if (!held.isVetoed)
    after.constraints.topology.allowed.push_back(held.place);
  else if (nearest != vetoes.end())
    vetoes.erase(nearest);
  d_->push(tr("Let it happen"), std::move(after), -1);
}

void Document::keepHeld(const HeldPlace& held) {
  Edits after = d_->active().edits();
  after.constraints.topology.kept.push_back(held.place);
  d_->push(tr("Hold it"), std::move(after), -1);
}

std::vector<HeldPlace> Document::openQuestions() const {
  const auto shown = snapshot();
  const TopologyLimits& limits = constraints().topology;
  if (!shown || !limits.asks) return {};
  const auto isIn = [](const std::vector<Vec3>& places, const Vec3& place) {
    return std::find(places.begin(), places.end(), place) != places.end();
  };
  std::vector<HeldPlace> open;
  for (const HeldPlace& held : shown->held)
    if (!held.isVetoed && !held.isDecided && !isIn(limits.kept, held.place) &&
        !isIn(limits.allowed, held.place))
      open.push_back(held);
  std::stable_sort(open.begin(), open.end(),
                   [](const HeldPlace& a, const HeldPlace& b) { return a.iteration < b.iteration; });
  return open;
}

}  // namespace handlebody::ui
