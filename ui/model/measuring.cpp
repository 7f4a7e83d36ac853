#include "ui/model/measuring.h"

#include "core/collision/closest_point.h"
#include "ui/model/cancellable.h"
#include "ui/model/translate.h"

namespace handlebody::ui {

namespace {

MeasuredObject measuredOf(const MeasuredSurface& surface, const Volume& volume) {
  const CertifiedMesh& mesh = surface.mesh->get();
  return {surface.name.toStdString(), mesh.mesh, mesh.certificate, objectMeasures(mesh.mesh, &volume)};
}

//! None where there is no second surface, with a warning.
std::optional<MeasuredWall> wallOf(Measured& m, const WantedWall& wanted) {
  const MeasuredObject& first = m.objects.at(static_cast<std::size_t>(wanted.first));
  if (wanted.second) {
    const MeasuredObject& second = m.objects.at(static_cast<std::size_t>(*wanted.second));
    return MeasuredWall{first.name, second.name, wallThickness(first.mesh, second.mesh)};
  }
  const auto [outer, inner] = outerAndInner(first.mesh);
  if (!inner.triangles.empty()) return MeasuredWall{kOuterSurface, kCavities, wallThickness(outer, inner)};
  m.warnings.push_back({FindingKind::noCavity, {{"object", first.name}}});
  return std::nullopt;
}

QString endOfSentence(CentreLineFault fault) {
  switch (fault) {
    case CentreLineFault::firstOutside:
      return tr("the first point lies outside of the object");
    case CentreLineFault::secondOutside:
      return tr("the second point lies outside of the object");
    case CentreLineFault::samePlace:
      return tr("the two points lie in the same place of the object");
    case CentreLineFault::tooLongAndThin:
      return tr("the way between them is too long and thin to be searched");
    case CentreLineFault::noWay:
      return tr("there is no way from one to the other inside of the object");
    default:
      return {};
  }
}

}  // namespace

std::vector<MeasuredSurface> shownSurfaces(const Document& document) {
  std::vector<MeasuredSurface> all;
  const std::vector<std::string> names = document.anonymousNames();
  for (int i = 0; i < document.objectCount(); ++i)
    if (auto mesh = document.finishedMesh(i))
      all.push_back({QString::fromStdString(document.objectInfo(i).label.name), std::move(mesh),
                     QString::fromStdString(names.at(static_cast<std::size_t>(i)))});
  return all;
}

std::map<std::string, std::string> anonymousNames(const std::vector<MeasuredSurface>& surfaces) {
  std::map<std::string, std::string> names;
  for (const MeasuredSurface& s : surfaces) names[s.name.toStdString()] = s.anonymousName.toStdString();
  return names;
}

Measured measureAll(const MeasureQuestion& q, const std::function<void(double)>& progress) {
  Measured m;
  m.path = q.path;
  m.volume = q.volumePath;
  const std::size_t n = q.surfaces.size();
  const double steps = static_cast<double>(n + n * (n - 1) / 2 + (q.wall ? 1 : 0));
  double done = 0;
  const auto step = [&] {
    progress(++done / steps);
    giveUpIfCancelled();
  };
  for (const MeasuredSurface& surface : q.surfaces) {
    m.objects.push_back(measuredOf(surface, q.volume));
    const MeasuredObject& object = m.objects.back();
    for (const Finding& w : object.measures.warnings)
      m.warnings.push_back(n > 1 ? Finding(FindingKind::ofObject, {{"object", object.name}}, w) : w);
    step();
  }
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = 0; i < j; ++i) {
      m.gaps.push_back(
          {m.objects[i].name, m.objects[j].name, surfaceGap(m.objects[i].mesh, m.objects[j].mesh)});
      step();
    }
  if (q.wall) {
    m.wall = wallOf(m, *q.wall);
    step();
  }
  return m;
}

LineAnswer lineOf(const LineQuestion& q) {
  if (q.surfaces.empty()) return {{}, tr("There is no surface yet: grow one first.")};
  for (const MeasuredSurface& surface : q.surfaces) {
    const TriangleSoup& mesh = surface.mesh->get().mesh;
    if (ClosestPoint(mesh).windingNumber(q.from) <= 0) continue;
    CentreLine line = centreLine(mesh, q.from, q.to);
    if (!line.points.empty()) return {MeasuredLine{surface.name.toStdString(), std::move(line)}, {}};
    return {{}, tr("There is no centre line in “%1”: %2.").arg(surface.name, endOfSentence(line.fault))};
  }
  return {{}, tr("The first place lies in none of the objects.")};
}

void Measurer::cancel() { *cancelled_ = true; }

std::shared_ptr<std::atomic<bool>> Measurer::startAnew() {
  cancel();
  cancelled_ = std::make_shared<std::atomic<bool>>(false);
  return cancelled_;
}

void Measurer::measure(MeasureQuestion question, std::function<void(double)> progress,
                       std::function<void(MeasureAnswer)> done) {
  thread_.postInstead([stop = startAnew(), question = std::move(question), progress = std::move(progress),
                       done = std::move(done)] {
    answerWith<MeasureAnswer>(*stop, done, [&] {
      return MeasureAnswer{measureAll(question, [&](double part) {
        if (!*stop) progress(part);
      })};
    });
  });
}

void Measurer::findLine(LineQuestion question, std::function<void(LineAnswer)> done) {
  thread_.postInstead([stop = startAnew(), question = std::move(question), done = std::move(done)] {
    answerWith<LineAnswer>(*stop, done, [&] { return lineOf(question); });
  });
}

}  // namespace handlebody::ui
