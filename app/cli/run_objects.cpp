#include "app/cli/run_objects.h"

#include <algorithm>
#include <memory>
#include <set>
#include <stdexcept>

#include "app/cli/command.h"
#include "app/picture/picture.h"
#include "core/collision/body_contact.h"
#include "core/errors.h"
#include "core/io/atomic_file.h"
#include "core/io/report/option_error.h"
#include "core/io/report/start_surface.h"
#include "core/io/report/wall_map.h"

namespace handlebody::cli {

namespace {

//! Does the work for one object, whose name then stands before whatever goes wrong.
template <typename F>
auto namingErrors(const std::string& name, F&& work) {
  const auto named = [&](const std::exception& error) { return "object '" + name + "': " + error.what(); };
  try {
    return work();
  } catch (const UsageError& error) {
    throw UsageError(named(error));
  } catch (const SeedError& error) {
    throw SeedError(named(error));
  } catch (const InputError& error) {
    throw InputError(named(error));
  } catch (const OutputError& error) {
    throw OutputError(named(error));
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(named(error));
  }
}

//! The guarantee, looked at once more on the meshes as they are written, by a way of its own.
void requireApart(const std::vector<WallObject>& finished, const TriangleSoup& mesh) {
  for (const WallObject& other : finished)
    if (bodyContact(*other.mesh, mesh) != BodyContact::none)
      throw std::runtime_error("its mesh meets that of the object '" + other.name +
                               "', and nothing was written.");
}

void addWalls(Session& session, const std::vector<WallObject>& finished) {
  session.constraints.walls.objects = finished;
  for (ParameterChange& change : session.changes)
    if (change.constraints) change.constraints->walls.objects = finished;
}

std::vector<const TriangleSoup*> meshesBut(const std::vector<GrownObject>& grown, std::size_t without) {
  std::vector<const TriangleSoup*> meshes;
  for (std::size_t j = 0; j < grown.size(); ++j)
    if (j != without) meshes.push_back(&grown[j].mesh);
  return meshes;
}

//! One after the other, each with all others as they are by then in its way.
void polishAll(std::vector<GrownObject>& grown, const Volume& volume, const RunOutputs& outputs) {
  for (std::size_t i = 0; i < grown.size(); ++i) {
    const std::string name = grown[i].report.session.label.name;
    namingErrors(name, [&] { polishAmong(grown[i], meshesBut(grown, i), volume, outputs); });
  }
  for (std::size_t i = 0; i < grown.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (bodyContact(grown[j].mesh, grown[i].mesh) != BodyContact::none)
        throw std::runtime_error("object '" + grown[i].report.session.label.name +
                                 "': its polished mesh meets that of the object '" +
                                 grown[j].report.session.label.name + "', and nothing was written.");
}

}  // namespace

namespace {

//! Before the first of them grows; of those that are given only if nothing grows.
void requireAllRepeatable(const std::vector<Session*>& all) {
  const bool areAllGiven = std::all_of(all.begin(), all.end(), [](const Session* s) { return isGiven(*s); });
  for (const Session* session : all)
    if (areAllGiven || !isGiven(*session))
      namingErrors(session->label.name, [&] { requireRepeatable(*session); });
}

}  // namespace

std::vector<GrownObject> growObjects(LoadedSession first, std::vector<Session> others,
                                     const RunOutputs& outputs) {
  const Volume volume = first.volume;
  const VolumeInfo info = first.info;
  std::vector<Session*> all{&first.session};
  for (Session& session : others) all.push_back(&session);
  if (outputs.sensitivity.runs > 0) requireAllRepeatable(all);
  std::vector<ObjectLabel> labels;
  for (const Session* session : all) labels.push_back(session->label);
  checkNames(labels, info, outputs);
  loadStarts(all);
  std::vector<GrownObject> grown;
  std::vector<WallObject> finished;
  const auto growNext = [&](LoadedSession loaded) {
    const std::string name = loaded.session.label.name;
    addWalls(loaded.session, finished);
    grown.push_back(namingErrors(name, [&] {
      GrownObject object = grow(std::move(loaded), outputs, Among::others, name);
      requireApart(finished, object.mesh);
      return object;
    }));
    finished.push_back({name, std::make_shared<const TriangleSoup>(grown.back().mesh)});
  };
  growNext(std::move(first));
  for (Session& session : others) {
    Stopwatch watch;
    loadWalls(session, volume.grid);
    growNext({std::move(session), volume, info, watch.lap()});
  }
  polishAll(grown, volume, outputs);
  return grown;
}

namespace {

Timings sumOf(const std::vector<GrownObject>& grown) {
  Timings sum;
  for (const GrownObject& object : grown) {
    const Timings& s = object.report.seconds;
    sum.load += s.load;
    sum.prepare += s.prepare;
    sum.evolve += s.evolve;
    sum.exported += s.exported;
    sum.tunnels += s.tunnels;
    sum.sensitivity += s.sensitivity;
  }
  return sum;
}

//! For the report alone: it may take long.
std::vector<PairGap> gapsOf(const std::vector<ExportedObject>& objects, const RunOutputs& outputs) {
  if (outputs.report.empty()) return {};
  std::vector<const TriangleSoup*> meshes;
  for (const ExportedObject& object : objects) meshes.push_back(&object.mesh);
  return pairGaps(meshes);
}

void writeSideFiles(std::vector<RunReport> reports, const Timings& seconds, const std::vector<PairGap>& gaps,
                    const RunOutputs& outputs) {
  std::vector<Session> sessions;
  for (RunReport& report : reports) {
    if (outputs.content.anonymous) report = anonymous(std::move(report));
    sessions.push_back(report.session);
  }
  if (!outputs.session.empty()) writeSessions(sessions, outputs.session);
  if (!outputs.trace.empty()) writeTextAtomically(outputs.trace, traceText(reports));
  if (!outputs.report.empty()) writeTextAtomically(outputs.report, reportText(reports, seconds, gaps));
}

TriangleSoup together(const std::vector<ExportedObject>& objects) {
  TriangleSoup all;
  for (const ExportedObject& object : objects) {
    const int first = static_cast<int>(all.points.size());
    all.points.insert(all.points.end(), object.mesh.points.begin(), object.mesh.points.end());
    for (const Triangle& t : object.mesh.triangles)
      all.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  return all;
}

}  // namespace

void requireDistinct(const std::vector<ObjectLabel>& objects) {
  std::set<std::string> names;
  std::set<int> values;
  for (const ObjectLabel& object : objects) {
    if (!names.insert(object.name).second)
      throw OptionError("--object-name", "two objects have the name '" + object.name + "'.");
    if (!values.insert(object.value).second)
      throw OptionError("--label-value", "two objects have the value " + std::to_string(object.value) + ".");
  }
}

int runObjects(LoadedSession first, std::vector<Session> others, const RunOutputs& outputs) {
  if (!outputs.sensitivity.surface.empty())
    throw OptionError("--sensitivity-surface", "there are several objects, and it is the surface of one.");
  std::optional<Volume> shown;
  if (!outputs.picture.empty()) shown = first.volume;
  std::vector<GrownObject> grown = growObjects(std::move(first), std::move(others), outputs);
  Stopwatch watch;
  std::vector<ExportedObject> objects;
  std::vector<RunReport> reports;
  Timings seconds = sumOf(grown);
  for (GrownObject& object : grown) {
    Timings& s = object.report.seconds;
    s.total = s.load + s.prepare + s.evolve + s.exported + s.tunnels + s.sensitivity;
    objects.push_back({labelInFiles(object.report, outputs), std::move(object.mesh)});
    reports.push_back(std::move(object.report));
  }
  const std::vector<PairGap> gaps = gapsOf(objects, outputs);
  {
    DeferSignals whole;
    const auto results = [&] {
      writeObjects(objects, reports[0], outputs);
      if (shown) writePicture(*shown, together(objects), outputs.picture);
    };
    writeAll(results, [&] {
      seconds.exported += watch.lap();
      seconds.total = seconds.load + seconds.prepare + seconds.evolve + seconds.exported + seconds.tunnels +
                      seconds.sensitivity;
      writeSideFiles(reports, seconds, gaps, outputs);
    });
  }
  for (const RunReport& report : reports)
    if (!outputs.quiet) printSummary(report, report.session.label.name);
  return exitCodeOf(reports);
}

}  // namespace handlebody::cli
