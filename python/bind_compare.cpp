// compare.

#include <pybind11/stl.h>

#include <cmath>

#include "core/errors.h"
#include "core/io/report/comparison_json.h"
#include "python/bind.h"
#include "python/convert.h"
#include "python/work.h"

namespace handlebody::python {

namespace {

//! One of the two, before it is looked at without the lock.
struct Side {
  std::string name;
  std::shared_ptr<const TriangleSoup> mesh{};
  VolumePointer labels{};
  std::optional<int> label{};  //!< with neither mesh nor labels `name` is a path
};

Side sideFrom(const py::object& given, const char* name, std::optional<int> label) {
  if (py::isinstance<PythonMesh>(given)) return {name, given.cast<std::shared_ptr<PythonMesh>>()->soup()};
  if (py::isinstance<Contour>(given))
    throw py::type_error(std::string(name) + ": a contour is compared by its mesh().");
  if (py::isinstance<PythonVolume>(given)) return {name, nullptr, given.cast<VolumePointer>(), label};
  return {pathOf(given), nullptr, nullptr, label};
}

ComparedObject comparedSide(const Side& side, const DecoderSettings& decoder,
                            std::vector<Finding>& warnings) {
  if (side.mesh) return comparedMesh(side.name, *side.mesh);
  if (!side.labels) return readCompared(side.name, side.label, warnings, decoder);
  if (!holdsWholeNumbers(side.labels->loaded.volume))
    throw InputError(side.name + ": it is no label map: it has voxels whose values are no whole numbers.");
  return comparedLabels(side.name, side.labels->loaded.volume, side.label);
}

void compareSampled(ComparedPair& pair, const ComparisonOptions& how) try {
  compare(pair, how);
} catch (const TooManySamples& error) {
  throw UsageError(std::string("sampling: ") + error.what());
}

py::object comparison(const py::object& a, const py::object& b, std::optional<int> label,
                      std::optional<int> labelA, std::optional<int> labelB, std::optional<double> sampling,
                      int threads) {
  if (sampling && !(*sampling > 0 && std::isfinite(*sampling)))
    throw UsageError("sampling: it is not a finite number above 0.");
  if (threads < 1) throw UsageError("threads: it is below 1.");
  const Side first = sideFrom(a, "a", labelA ? labelA : label),
             second = sideFrom(b, "b", labelB ? labelB : label);
  const DecoderSettings decoder = decoderToUse();
  ComparedPair pair;
  withoutLock([&] {
    const std::lock_guard lock(filesMutex());
    pair.a = comparedSide(first, decoder, pair.warnings);
    pair.b = comparedSide(second, decoder, pair.warnings);
    compareSampled(pair, {sampling.value_or(0), threads});
  });
  return toPython(comparisonToJson(pair));
}

}  // namespace

void bindCompare(py::module_& module) {
  module.def(
      "compare", &comparison, py::arg("a"), py::arg("b"), py::kw_only(), py::arg("label") = py::none(),
      py::arg("label_a") = py::none(), py::arg("label_b") = py::none(), py::arg("sampling") = py::none(),
      py::arg("threads") = 1,
      "compare(a, b, *, label=None, label_a=None, label_b=None, sampling=None, threads=1)\n\nTwo objects, "
      "each "
      "a Mesh, a label map as Volume, or the path of either: the dictionary that `handlebody-cli compare "
      "--json` prints, with dice, iou, distances, volumes and topology. Raises InputError, UsageError.");
}

}  // namespace handlebody::python
