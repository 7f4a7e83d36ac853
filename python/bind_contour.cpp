// Contour.

#include <pybind11/stl.h>

#include "core/errors.h"
#include "core/io/report/measures_json.h"
#include "core/io/report/option_error.h"
#include "core/io/report/parse.h"
#include "python/bind.h"
#include "python/convert.h"
#include "python/options.h"
#include "python/work.h"

namespace handlebody::python {

namespace {

using ContourPointer = std::shared_ptr<Contour>;

//! Calls `work` on the contour without the interpreter's lock, while no other thread has it.
template <typename F>
void with(const Contour& contour, F&& work) {
  const std::unique_lock held = contour.hold();
  withoutLock([&] { work(); });
}

ContourPointer contourFrom(const VolumePointer& volume, const py::kwargs& options) {
  Asked asked;
  readOptions(options, asked);
  if (hasNoSeed(asked.clicks) && !asked.constraints.start)
    throw UsageError("a contour needs a seed or seed_ijk.");
  Session session;
  session.seeds = seedsInWorld(parseClicks(asked.clicks), volume->loaded.volume.grid);
  session.requested = asked.parameters;
  session.constraints = std::move(asked.constraints);
  session.volume.selection.decoder = decoderToUse();
  ContourPointer contour;
  withoutLock([&] { contour = std::make_shared<Contour>(volume, std::move(session)); });
  return contour;
}

//! With the value of the option that closes it.
Json leakOf(const Leak& leak) {
  Json json = leakToJson(leak);
  json["wall_disc"] = written(leak.disc);
  json["sentence"] = sentence(leak);
  return json;
}

Json stepToJson(const StepReport& step) {
  Json json = {{"iteration", step.iteration},
               {"moved_vertices", step.movedVertices},
               {"settled_vertices", step.unmovedVertices},
               {"volume_mm3", step.volume},
               {"largest_move_mm", step.largestMove}};
  json["events"] = Json::array();
  for (const Event& event : step.events) json["events"].push_back(eventToJson(event));
  json["leaks"] = Json::array();
  for (const Leak& leak : step.leaks) json["leaks"].push_back(leakOf(leak));
  return json;
}

py::object stepOf(Contour& contour) {
  StepReport step;
  with(contour, [&] { step = contour.step(); });
  return toPython(stepToJson(step));
}

std::string runOf(Contour& contour, std::optional<int> most, bool untilLeak) {
  if (most && *most < 0) throw UsageError("max_steps: it is below 0.");
  with(contour, [&] { contour.run(most, untilLeak); });
  return stopReasonName(contour.stopReason());
}

py::list eventsOf(const Contour& contour) {
  const std::unique_lock held = contour.hold();
  py::list events;
  for (const Event& event : contour.told().events) events.append(toPython(eventToJson(event)));
  return events;
}

py::list leaksOf(const Contour& contour) {
  const std::unique_lock held = contour.hold();
  py::list leaks;
  for (const ToldLeak& told : contour.told().leaks) leaks.append(toPython(leakOf(told.leak)));
  return leaks;
}

py::object parametersOf(const Contour& contour) {
  const std::unique_lock held = contour.hold();
  Json json = resolvedToJson(contour.active().parameters());
  json["seeds"] = seedsToJson(contour.active().parameters().seeds);
  return toPython(json);
}

std::shared_ptr<const TriangleSoup> surfaceOf(const Contour& contour) {
  const std::unique_lock held = contour.hold();
  return contour.surface();
}

std::shared_ptr<PythonMesh> meshOf(const Contour& contour) {
  std::shared_ptr<PythonMesh> mesh;
  with(contour, [&] { mesh = std::make_shared<PythonMesh>(contour.mesh()); });
  return mesh;
}

RunReport reportOf(const Contour& contour, bool isComplete) {
  RunReport report;
  with(contour, [&] { report = contour.report(isComplete); });
  return report;
}

py::object measuresOf(const Contour& contour) {
  ObjectMeasures measures;
  with(contour, [&] { measures = objectMeasures(*contour.mesh().soup(), &contour.volume().loaded.volume); });
  return toPython(measuresToJson(measures));
}

py::array contourLabelMap(const Contour& contour, const py::object& on) {
  const Grid grid = on.is_none() ? contour.volume().loaded.volume.grid : gridOf(on);
  Volume labels;
  with(contour, [&] { labels = contour.mesh().labelMap(grid); });
  return ownVoxels(labels);
}

//! The surface has begun with what was given then, and no other option makes it another one.
void requireSameStart(const Asked& asked) {
  for (const std::string& name : asked.given)
    if (name == "--given" || name.starts_with("--start"))
      throw OptionError(name, FindingKind::startCannotChange);
}

void changeContour(Contour& contour, const py::kwargs& options) {
  Asked asked;
  {
    const std::unique_lock held = contour.hold();
    asked.parameters = contour.active().requested();
    asked.constraints = contour.active().constraints();
  }
  readOptions(options, asked);
  requireSameStart(asked);
  ParameterChange change{0, asked.parameters, {}, std::move(asked.constraints)};
  const std::vector<Click> further = parseClicks(asked.clicks);
  if (!further.empty()) change.seeds = seedsInWorld(further, contour.volume().loaded.volume.grid);
  with(contour, [&] { contour.change(std::move(change)); });
}

void saveContour(const Contour& contour, const py::args& to, const std::string& space,
                 const std::string& name, int label) {
  std::vector<std::string> paths;
  for (const py::handle path : to) paths.push_back(pathOf(py::reinterpret_borrow<py::object>(path)));
  if (paths.empty()) throw py::type_error("save() needs a path.");
  std::vector<Finding> warnings;
  with(contour, [&] {
    const std::lock_guard lock(filesMutex());
    const Session& session = contour.told().session;
    warnings = save(*contour.mesh().soup(), &contour.volume().loaded.info, paths,
                    {space, name, label, session.label}, inputsOf(session));
  });
  warn(warnings);
}

std::string contourName(const Contour& contour) {
  return "<handlebody.Contour iteration " + std::to_string(contour.iteration()) + ", " +
         stopReasonName(contour.stopReason()) + ">";
}

using ContourClass = py::class_<Contour, ContourPointer>;

void bindGrowth(ContourClass& contour) {
  contour.def(py::init(&contourFrom), py::arg("volume").none(false));
  contour.def(
      "step", &stepOf,
      "step()\n\nOne iteration, all or nothing; returns what it did: iteration, moved_vertices, "
      "settled_vertices, volume_mm3, largest_move_mm, events, leaks. Raises UsageError if the growth has "
      "ended.");
  contour.def(
      "run", &runOf, py::arg("max_steps") = py::none(), py::kw_only(), py::arg("until_leak") = false,
      "run(max_steps=None, *, until_leak=False)\n\nSteps until the growth ends, or max_steps of them, or "
      "after a step that tells a leak; returns stop_reason. Ctrl+C ends it with KeyboardInterrupt between "
      "two iterations, and it can go on from there.");
  contour.def(
      "copy",
      [](const Contour& c) {
        const std::unique_lock held = c.hold();
        return std::make_shared<Contour>(c);
      },
      "copy()\n\nA contour that goes on exactly as this one would, bit for bit. The image is shared.");
  contour.def(
      "change", &changeContour,
      "change(**options)\n\nGoes on with other options from here, by the names that the constructor has: "
      "parameters replace those that hold, clicks and constraints come to those that hold. The mesh stays; "
      "what has settled wakes where it must. Once per iteration. Raises as the constructor, and nothing has "
      "changed then.");
  contour.def_property_readonly("iteration", &Contour::iteration, "Of the last step; 0 before the first.");
  contour.def_property_readonly(
      "stop_reason", [](const Contour& c) { return stopReasonName(c.stopReason()); },
      "'running' while step() would go on; else converged, max-iterations, empty, frozen, stuck, or given: "
      "there is nothing to grow.");
  contour.def_property_readonly(
      "events", &eventsOf,
      "All events so far, as in a report: kind, iteration, location (mm LPS), before and "
      "after (components, euler, genus) and more.");
  contour.def_property_readonly(
      "leaks", &leaksOf,
      "Narrow passages that the surface came through, as in a report, and wall_disc, which "
      "closes it as that option.");
  contour.def_property_readonly("parameters", &parametersOf,
                                "Every parameter as used, with what was chosen from the image.");
}

void bindResults(ContourClass& contour) {
  contour.def_property_readonly(
      "vertices", [](const Contour& c) { return verticesView(surfaceOf(c)); },
      "(n, 3) float64, mm LPS, of this iteration in the engine's precision: a view that cannot be written "
      "and stays "
      "as it is when the contour goes on.");
  contour.def_property_readonly(
      "faces", [](const Contour& c) { return facesView(surfaceOf(c)); },
      "(m, 3) int32, indices into vertices of the same iteration: a view like vertices.");
  contour.def(
      "mesh", &meshOf,
      "mesh()\n\nThe Mesh of this iteration, bit for bit what the command line writes: rounded to single "
      "precision and certified. Raises SeedError if nothing is left, RuntimeError if it fails its "
      "certificate.");
  contour.def(
      "certificate", [](const Contour& c) { return toPython(certificateToJson(reportOf(c, false).mesh)); },
      "certificate()\n\nOf mesh(): see Mesh.certificate.");
  contour.def("measure", &measuresOf, "measure()\n\nOf mesh(), with the intensities of the volume inside.");
  contour.def(
      "warnings", [](const Contour& c) { return sentences(reportOf(c, false).warnings, &asArgument); },
      "warnings()\n\nWhat to look at before the result is trusted: sentences, as the command line prints "
      "them.");
  contour.def(
      "report", [](const Contour& c) { return toPython(reportText(reportOf(c, true))); },
      "report()\n\nThe report of `handlebody-cli segment --report` as a dictionary; without times.");
  contour.def(
      "label_map", &contourLabelMap, py::arg("grid") = py::none(),
      "label_map(grid=None)\n\nOf mesh() on a Grid or the grid of a Volume, by default that of the volume: "
      "uint8 array z, y, x, of the caller's own.");
  contour.def(
      "save", &saveContour, py::arg("space") = "LPS", py::arg("name") = "", py::arg("label") = 1,
      "save(*paths, space='LPS', name='', label=1)\n\nWrites mesh() to each path by its extension, as -o of "
      "the command line does: meshes, label maps on the volume's grid, DICOM, tetrahedra. Whole or not at "
      "all. Raises UsageError, OutputError.");
  contour.def(
      "save_session",
      [](const Contour& c, const py::object& to) {
        const std::string path = pathOf(to);
        with(c, [&] { c.writeSession(path); });
      },
      py::arg("path"),
      "save_session(path)\n\nFor `handlebody-cli replay` and the window. The volume must be from a file. Not "
      "over "
      "a file that the contour was made from.");
  contour.def("__repr__", &contourName);
}

}  // namespace

void bindContour(py::module_& module) {
  ContourClass contour(
      module, "Contour",
      "Contour(volume, *, seed=None, seed_ijk=None, background=None, background_ijk=None, "
      "**options)\n\nA surface that grows from seeds in a volume. The options are those of "
      "`handlebody-cli segment` with underscores for dashes (object, range, edge_length, …), as "
      "numbers, sequences of numbers or the text of the command line; what may be given several "
      "times takes a list. None is as if not given. Raises SeedError, UsageError, InputError.");
  module.attr("option_names") = py::cast(optionNames());  // for the tests
  bindGrowth(contour);
  bindResults(contour);
}

}  // namespace handlebody::python
