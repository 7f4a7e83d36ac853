// Grid, Volume, Phantom, read_volume, phantom.

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "core/errors.h"
#include "core/io/report/parse.h"
#include "python/bind.h"
#include "python/convert.h"
#include "python/work.h"
#include "sample_volumes/phantom.h"

namespace handlebody::python {

namespace {

py::tuple tupleOf(const Vec3& v) { return py::make_tuple(v.x(), v.y(), v.z()); }

Eigen::Matrix3d directionFrom(const py::object& value) {
  const auto array = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(value);
  if (!array) PyErr_Clear();
  if (!array || array.size() != 9 || (array.ndim() != 1 && !(array.ndim() == 2 && array.shape(0) == 3)))
    throw UsageError("direction: it is not a matrix of 3 x 3 numbers.");
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(array.data());
}

Grid gridFrom(const std::array<int, 3>& size, const py::object& spacing, const py::object& origin,
              const py::object& direction) {
  Grid grid;
  grid.size = size;
  grid.spacing = vectorFrom(spacing, "spacing");
  grid.origin = vectorFrom(origin, "origin");
  if (!direction.is_none()) grid.direction = directionFrom(direction);
  return grid;
}

py::array directionOf(const Grid& grid) {
  py::array_t<double> array({3, 3});
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) array.mutable_at(row, column) = grid.direction(row, column);
  return array;
}

//! What files hold of that type, too. Throws InputError.
VoxelType voxelTypeOf(const py::dtype& type) {
  const char kind = type.kind();
  const auto bytes = type.itemsize();
  if (kind == 'b') return VoxelType::uint8;
  if (kind == 'u' && bytes <= 4)
    return bytes == 1 ? VoxelType::uint8 : bytes == 2 ? VoxelType::uint16 : VoxelType::uint32;
  if (kind == 'i' && bytes <= 4)
    return bytes == 1 ? VoxelType::int8 : bytes == 2 ? VoxelType::int16 : VoxelType::int32;
  if (kind == 'f' && bytes <= 4) return VoxelType::float32;
  if (bytes == 8 && (kind == 'f' || kind == 'i' || kind == 'u')) return VoxelType::float64;
  throw InputError("array: values of type " + type.attr("name").cast<std::string>() +
                   " are not supported; give whole or floating-point numbers of up to 64 bits.");
}

py::array arrayFrom(const py::object& given) {
  if (py::isinstance(given, py::module_::import("numpy.ma").attr("MaskedArray")))
    throw InputError("array: it is masked; fill what is masked first, as by array.filled(0).");
  const py::array array = py::array::ensure(given);
  if (!array) throw py::error_already_set();
  if (array.ndim() != 3)
    throw InputError("array: it has " + std::to_string(array.ndim()) +
                     (array.ndim() == 1 ? " dimension" : " dimensions") +
                     ", and a volume has three, in the order z, y, x.");
  for (py::ssize_t axis = 0; axis < 3; ++axis)
    if (array.shape(axis) > std::numeric_limits<int>::max())
      throw InputError("array: an axis of " + std::to_string(array.shape(axis)) + " voxels is too long.");
  return array;
}

VolumePointer volumeFrom(const py::object& given, const py::object& spacing, const py::object& origin,
                         const py::object& direction) {
  const py::array array = arrayFrom(given);
  const auto along = [&array](py::ssize_t axis) { return static_cast<int>(array.shape(axis)); };
  const Grid grid = gridFrom({along(2), along(1), along(0)}, spacing, origin, direction);
  const VoxelType type = voxelTypeOf(array.dtype());
  // NumPy knows all strides, byte orders and conversions.
  const auto fill = [&](void* memory) {
    const py::capsule borrowed(memory, [](void*) {});
    const py::array to(py::dtype(voxelTypeName(type)), std::vector<py::ssize_t>{along(0), along(1), along(2)},
                       {}, memory, borrowed);
    py::module_::import("numpy").attr("copyto")(to, array, py::arg("casting") = "unsafe");
  };
  auto volume = std::make_shared<PythonVolume>();
  volume->loaded = fillVolume(grid, type, "array", fill);
  volume->loaded.info.path.clear();
  volume->loaded.info.format = "array";
  warn(volume->loaded.info.warnings);
  return volume;
}

VolumePointer readVolumeOf(const py::object& path, const py::object& series, std::optional<int> frame,
                           const py::object& spacing, const std::string& uneven) {
  VolumeReference reference{pathOf(path), {}, {}};
  reference.selection.decoder = decoderToUse();
  if (!series.is_none()) reference.selection.series = series.cast<std::string>();
  reference.selection.frame = frame;
  if (!spacing.is_none()) reference.selection.spacing = vectorFrom(spacing, "spacing");
  if (uneven != "resample" && uneven != "refuse")
    throw UsageError("uneven: '" + uneven + "' is not resample or refuse.");
  if (uneven == "refuse") reference.selection.uneven = UnevenSlices::refuse;
  auto volume = std::make_shared<PythonVolume>();
  withoutLock([&] {
    const std::lock_guard lock(filesMutex());
    reference.sha256 = sha256OfPath(reference.path);
    volume->loaded = loadVolume(reference.path, reference.selection);
  });
  volume->reference = std::move(reference);
  warn(volume->loaded.info.warnings);
  return volume;
}

void saveVolume(const PythonVolume& volume, const py::object& to) {
  const std::string path = pathOf(to);
  requireOther(path, volume.reference.path);
  withoutLock([&] {
    const std::lock_guard lock(filesMutex());
    writeVolume(volume.loaded.volume, path);
  });
}

std::string volumeName(const PythonVolume& volume) {
  const Grid& grid = volume.loaded.volume.grid;
  std::string text = "<handlebody.Volume ";
  for (std::size_t axis : {0, 1, 2}) text += (axis ? " x " : "") + std::to_string(grid.size[axis]);
  return text + " voxels of " + written(grid.spacing) + " mm, " + voxelTypeName(volume.loaded.volume.type) +
         ">";
}

void bindGrid(py::module_& module) {
  py::class_<Grid> grid(
      module, "Grid",
      "Grid(size, spacing=(1, 1, 1), origin=(0, 0, 0), direction=None)\n\nWhere voxels lie, as "
      "in SimpleITK: size, spacing (mm) and origin (mm, LPS) in the order x, y, z; the columns "
      "of direction are the directions of the axes.");
  grid.def(py::init([](const std::array<int, 3>& size, const py::object& spacing, const py::object& origin,
                       const py::object& direction) {
             return checkedGrid(gridFrom(size, spacing, origin, direction), VoxelType::uint8, "grid");
           }),
           py::arg("size"), py::arg("spacing") = py::make_tuple(1, 1, 1),
           py::arg("origin") = py::make_tuple(0, 0, 0), py::arg("direction") = py::none());
  grid.def_property_readonly(
      "size", [](const Grid& g) { return py::make_tuple(g.size[0], g.size[1], g.size[2]); },
      "Voxels along x, y, z.");
  grid.def_property_readonly(
      "shape", [](const Grid& g) { return py::make_tuple(g.size[2], g.size[1], g.size[0]); },
      "Of an array on this grid: z, y, x.");
  grid.def_property_readonly(
      "spacing", [](const Grid& g) { return tupleOf(g.spacing); }, "mm, x, y, z.");
  grid.def_property_readonly(
      "origin", [](const Grid& g) { return tupleOf(g.origin); }, "Centre of the first voxel, mm LPS.");
  grid.def_property_readonly("direction", &directionOf, "3 x 3; its columns are the axes.");
  grid.def(
      "to_world",
      [](const Grid& g, const py::object& index) { return tupleOf(g.toWorld(vectorFrom(index, "index"))); },
      py::arg("index"), "to_world(index)\n\nContinuous voxel index (i, j, k), along x, y, z, to mm LPS.");
  grid.def(
      "to_index",
      [](const Grid& g, const py::object& world) { return tupleOf(g.toIndex(vectorFrom(world, "world"))); },
      py::arg("world"), "to_index(world)\n\nmm LPS to the continuous voxel index (i, j, k), along x, y, z.");
}

void bindVolumeClass(py::module_& module) {
  py::class_<PythonVolume, VolumePointer> volume(
      module, "Volume",
      "Volume(array, spacing=(1, 1, 1), origin=(0, 0, 0), direction=None)\n\nVoxels with spacing, origin and "
      "direction. The array's axes are z, y, x, as in SimpleITK's GetArrayFromImage; spacing and origin are "
      "in "
      "the order x, y, z. The voxels are copied.");
  volume.def(py::init(&volumeFrom), py::arg("array"), py::arg("spacing") = py::make_tuple(1, 1, 1),
             py::arg("origin") = py::make_tuple(0, 0, 0), py::arg("direction") = py::none());
  volume.def_property_readonly(
      "array", [](const PythonVolume& v) { return voxelsView(v.loaded.volume); },
      "The voxels, z, y, x: a view without a copy that cannot be written.");
  volume.def_property_readonly(
      "grid", [](const PythonVolume& v) { return v.loaded.volume.grid; }, "Where the voxels lie.");
  volume.def_property_readonly(
      "path",
      [](const PythonVolume& v) -> py::object {
        if (v.reference.path.empty()) return py::none();
        return py::module_::import("os").attr("fsdecode")(py::bytes(v.reference.path));
      },
      "Of the file or folder; None if there is none.");
  volume.def_property_readonly(
      "frames", [](const PythonVolume& v) { return v.loaded.info.frames; }, "Time points in the file.");
  volume.def_property_readonly(
      "calibrated", [](const PythonVolume& v) { return v.loaded.info.calibrated; },
      "False: a spacing is assumed, and lengths in mm mean nothing.");
  volume.def_property_readonly(
      "warnings", [](const PythonVolume& v) { return sentences(v.loaded.info.warnings, &asArgument); },
      "What is doubtful about the file: sentences.");
  volume.def(
      "save", &saveVolume, py::arg("path"),
      "save(path)\n\nWrites .nii.gz, .nii, .nrrd or .mha, whole or not at all. Not over the file that it "
      "was read from.");
  volume.def("__repr__", &volumeName);
}

VoxelType phantomTypeOf(const std::string& name) {
  for (VoxelType type : {VoxelType::uint8, VoxelType::int16, VoxelType::float32})
    if (name == voxelTypeName(type)) return type;
  throw UsageError("type: '" + name + "' is not uint8, int16 or float32.");
}

VolumePointer volumeOf(const Volume& made, const std::string& name) {
  auto volume = std::make_shared<PythonVolume>();
  volume->loaded.volume = made;
  volume->loaded.info.grid = made.grid;
  volume->loaded.info.type = made.type;
  volume->loaded.info.format = "phantom " + name;
  return volume;
}

struct PythonPhantom {
  std::string name;
  VolumePointer volume, truth;
  Seed seed;
  std::vector<int> genus;
};

PythonPhantom phantomOf(const std::string& name, const std::array<int, 3>& size, const py::object& spacing,
                        const py::object& rotate, const std::string& type, double noise, double bias,
                        double gap, std::uint32_t randomSeed) {
  PhantomOptions options;
  options.size = size;
  options.spacing = vectorFrom(spacing, "spacing");
  if (!(options.spacing.minCoeff() > 0)) throw UsageError("spacing: it is not above 0.");
  options.rotationDegrees = vectorFrom(rotate, "rotate");
  options.type = phantomTypeOf(type);
  options.noise = noise;
  options.bias = bias;
  options.gapVoxels = gap;
  options.randomSeed = randomSeed;
  Phantom made;
  withoutLock([&] { made = makePhantom(name, options); });
  return {made.name,
          volumeOf(made.volume, name),
          volumeOf(made.truth, name),
          {made.seed, made.seedRadius},
          made.genus};
}

void bindPhantom(py::module_& module) {
  py::class_<PythonPhantom> phantom(module, "Phantom", "A volume of known shape: see phantom().");
  phantom.def_readonly("name", &PythonPhantom::name, "Of the shape.");
  phantom.def_readonly("volume", &PythonPhantom::volume, "The image; the object is dark.");
  phantom.def_readonly("truth", &PythonPhantom::truth, "Its label map: 1 inside.");
  phantom.def_readonly("genus", &PythonPhantom::genus, "Of each component, the largest component first.");
  phantom.def_property_readonly(
      "seed",
      [](const PythonPhantom& p) {
        return py::make_tuple(p.seed.centre.x(), p.seed.centre.y(), p.seed.centre.z(), *p.seed.radius);
      },
      "X, Y, Z and radius, mm LPS: as the option seed takes it.");
  module.def(
      "phantom", &phantomOf, py::arg("name"), py::kw_only(), py::arg("size") = py::make_tuple(0, 0, 0),
      py::arg("spacing") = py::make_tuple(1, 1, 1), py::arg("rotate") = py::make_tuple(0, 0, 0),
      py::arg("type") = "uint8", py::arg("noise") = -1.0, py::arg("bias") = 1.0, py::arg("gap") = 0.0,
      py::arg("random_seed") = 1u,
      "phantom(name, *, size=(0, 0, 0), spacing=(1, 1, 1), rotate=(0, 0, 0), type='uint8', noise=-1, "
      "bias=1, gap=0, random_seed=1)\n\nThe volume that `handlebody-cli phantom` writes: cyst, cube, "
      "genus3, torus, sphere, dumbbell, wall, neck, rings, trefoil, tree, balls, plate or gyroid. A size of "
      "0: the phantom's own extent; a noise below 0: its own.");
}

}  // namespace

void bindVolume(py::module_& module) {
  bindGrid(module);
  bindVolumeClass(module);
  bindPhantom(module);
  module.def(
      "read_volume", &readVolumeOf, py::arg("path"), py::kw_only(), py::arg("series") = py::none(),
      py::arg("frame") = py::none(), py::arg("spacing") = py::none(), py::arg("uneven") = "resample",
      "read_volume(path, *, series=None, frame=None, spacing=None, uneven='resample')\n\nReads a file or a "
      "folder with a DICOM series, as the command line does. What is doubtful is a HandlebodyWarning. "
      "Raises InputError, UsageError.");
}

}  // namespace handlebody::python
