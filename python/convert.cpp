#include "python/convert.h"

#include <algorithm>

#include "core/errors.h"

namespace handlebody::python {

py::object toPython(const Json& json) {
  switch (json.type()) {
    case Json::value_t::object: {
      py::dict dict;
      for (const auto& [key, value] : json.items()) dict[py::str(key)] = toPython(value);
      return dict;
    }
    case Json::value_t::array: {
      py::list list;
      for (const Json& value : json) list.append(toPython(value));
      return list;
    }
    case Json::value_t::string:
      return py::str(json.get_ref<const std::string&>());
    case Json::value_t::boolean:
      return py::bool_(json.get<bool>());
    case Json::value_t::number_integer:
    case Json::value_t::number_unsigned:
      return py::int_(json.get<long long>());
    case Json::value_t::number_float:
      return py::float_(json.get<double>());
    default:
      return py::none();
  }
}

py::object toPython(const std::string& jsonText) { return toPython(Json::parse(jsonText)); }

std::string asArgument(std::string_view option) {
  std::string name(option);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

namespace {

//! Of memory that `owner` keeps.
py::array sharing(const py::dtype& type, std::vector<py::ssize_t> shape, const void* data,
                  std::shared_ptr<const void> owner) {
  auto* kept = new std::shared_ptr<const void>(std::move(owner));
  const py::capsule base(kept, [](void* p) { delete static_cast<std::shared_ptr<const void>*>(p); });
  return py::array(type, std::move(shape), {}, data, base);
}

py::array locked(py::array array) {
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

}  // namespace

py::array verticesView(const std::shared_ptr<const TriangleSoup>& mesh) {
  static_assert(sizeof(Vec3) == 3 * sizeof(double));
  const auto count = static_cast<py::ssize_t>(mesh->points.size());
  return locked(sharing(py::dtype::of<double>(), {count, 3}, mesh->points.data(), mesh));
}

py::array facesView(const std::shared_ptr<const TriangleSoup>& mesh) {
  static_assert(sizeof(Triangle) == 3 * sizeof(std::int32_t));
  const auto count = static_cast<py::ssize_t>(mesh->triangles.size());
  return locked(sharing(py::dtype::of<std::int32_t>(), {count, 3}, mesh->triangles.data(), mesh));
}

py::array voxelsView(const Volume& volume) { return locked(ownVoxels(volume)); }

py::array ownVoxels(const Volume& volume) {
  const auto [nx, ny, nz] = volume.grid.size;
  return sharing(py::dtype(voxelTypeName(volume.type)), {nz, ny, nx}, volume.voxels.get(), volume.voxels);
}

namespace {

//! As a contiguous array of T with rows of three. Throws UsageError.
template <typename T>
py::array_t<T, py::array::c_style | py::array::forcecast> rowsOfThree(const py::object& value,
                                                                      const char* kinds,
                                                                      const std::string& what) {
  const auto array = py::array::ensure(value);
  if (!array || array.ndim() != 2 || array.shape(1) != 3 ||
      std::string(kinds).find(array.dtype().kind()) == std::string::npos) {
    PyErr_Clear();
    throw UsageError(what);
  }
  return py::array_t<T, py::array::c_style | py::array::forcecast>(array);
}

}  // namespace

TriangleSoup soupFrom(const py::object& vertices, const py::object& faces) {
  const auto points =
      rowsOfThree<double>(vertices, "fiu", "vertices: they are not an (n, 3) array of numbers.");
  const auto corners =
      rowsOfThree<std::int64_t>(faces, "iu", "faces: they are not an (m, 3) array of whole numbers.");
  if (points.shape(0) > std::numeric_limits<std::int32_t>::max())
    throw UsageError("vertices: there are more than 32-bit indices can count.");
  TriangleSoup soup;
  soup.points.resize(points.shape(0));
  for (py::ssize_t i = 0; i < points.shape(0); ++i) {
    Vec3& p = soup.points[i];
    p = {points.at(i, 0), points.at(i, 1), points.at(i, 2)};
    if (!p.allFinite())
      throw UsageError("vertices: number " + std::to_string(i) + " is not a number or infinite.");
  }
  for (py::ssize_t i = 0; i < corners.shape(0); ++i) {
    Triangle& t = soup.triangles.emplace_back();
    for (py::ssize_t c = 0; c < 3; ++c) {
      const std::int64_t corner = corners.at(i, c);
      if (corner < 0 || corner >= points.shape(0))
        throw UsageError("faces: number " + std::to_string(i) + " has a corner " + std::to_string(corner) +
                         " where there are " + std::to_string(points.shape(0)) + " vertices.");
      t[c] = static_cast<int>(corner);
    }
  }
  return soup;
}

Vec3 vectorFrom(const py::object& value, const std::string& what) {
  const auto array = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(value);
  if (!array) PyErr_Clear();
  if (!array || array.ndim() != 1 || array.shape(0) != 3)
    throw UsageError(what + ": it is not three numbers.");
  Vec3 vector(array.at(0), array.at(1), array.at(2));
  if (!vector.allFinite()) throw UsageError(what + ": it is not three finite numbers.");
  return vector;
}

}  // namespace handlebody::python
