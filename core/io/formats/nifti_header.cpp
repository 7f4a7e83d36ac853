#include "core/io/formats/nifti_header.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/indices.h"
#include "core/io/formats/byte_stream.h"

namespace handlebody {
namespace {

//! The bytes of a header, and whether they stand in the other order.
struct Bytes {
  std::array<unsigned char, 540> bytes{};
  bool swapped = false;

  template <typename T>
  T at(std::size_t offset) const {
    T value;
    std::memcpy(&value, bytes.data() + offset, sizeof value);
    if (swapped) swapBytes(&value, 1, sizeof value);
    return value;
  }
};

template <typename Index, typename Real>
void readArrays(const Bytes& b, std::size_t dim, std::size_t pixdim, std::size_t quaternion, std::size_t rows,
                NiftiHeader& h) {
  for (std::size_t i = 0; i < 8; ++i) {
    h.dim[i] = b.at<Index>(dim + i * sizeof(Index));
    h.pixdim[i] = static_cast<double>(b.at<Real>(pixdim + i * sizeof(Real)));
  }
  for (std::size_t i = 0; i < 3; ++i) {
    h.quaternion[i] = static_cast<double>(b.at<Real>(quaternion + i * sizeof(Real)));
    h.offset[i] = static_cast<double>(b.at<Real>(quaternion + (3 + i) * sizeof(Real)));
  }
  for (std::size_t i = 0; i < 12; ++i) h.rows[i] = static_cast<double>(b.at<Real>(rows + i * sizeof(Real)));
}

void readFirst(const Bytes& b, NiftiHeader& h) {
  readArrays<std::int16_t, float>(b, 40, 76, 256, 280, h);
  h.datatype = b.at<std::int16_t>(70);
  const float offset = b.at<float>(108);
  h.voxOffset = offset >= 0 && offset < 1e9f ? static_cast<std::int64_t>(offset) : -1;
  h.slope = static_cast<double>(b.at<float>(112));
  h.intercept = static_cast<double>(b.at<float>(116));
  h.units = b.bytes[123];
  h.qform = b.at<std::int16_t>(252);
  h.sform = b.at<std::int16_t>(254);
}

void readSecond(const Bytes& b, NiftiHeader& h) {
  h.version = 2;
  readArrays<std::int64_t, double>(b, 16, 104, 352, 400, h);
  h.datatype = b.at<std::int16_t>(12);
  h.voxOffset = b.at<std::int64_t>(168);
  h.slope = b.at<double>(176);
  h.intercept = b.at<double>(184);
  h.units = b.at<std::int32_t>(500);
  h.qform = b.at<std::int32_t>(344);
  h.sform = b.at<std::int32_t>(348);
}

//! Voxel index to RAS, as the quaternion gives it.
Eigen::Matrix3d rotationOf(const NiftiHeader& h) {
  double b = h.quaternion[0], c = h.quaternion[1], d = h.quaternion[2];
  const double rest = 1 - (b * b + c * c + d * d);
  double a = 0;
  if (rest < 1e-7) {
    const double length = std::sqrt(b * b + c * c + d * d);
    b /= length, c /= length, d /= length;
  } else {
    a = std::sqrt(rest);
  }
  Eigen::Matrix3d r = Eigen::Quaterniond(a, b, c, d).toRotationMatrix();
  if (h.pixdim[0] < 0) r.col(2) *= -1;
  return r;
}

//! A voxel size of 0 means 1 in the standard's own library, one below 0 its amount; here the former is no
//! size that the file gives. One that is not a number is refused with the header.
void setVoxelSize(const NiftiHeader& h, VolumeHeader& header) {
  for (int a = 0; a < 3; ++a) {
    const double d = std::abs(h.pixdim[a + 1]);
    header.grid.spacing[a] = d == 0 ? 1 : d;
    header.sources.spacing[a] = d == 0 ? "assumed" : "pixdim";
    header.calibrated = header.calibrated && d != 0;
  }
}

Vec3 toLps(const Vec3& ras) { return {-ras.x(), -ras.y(), ras.z()}; }

void useQform(const NiftiHeader& h, VolumeHeader& header) {
  const Eigen::Matrix3d r = rotationOf(h);
  for (int a = 0; a < 3; ++a) header.grid.direction.col(a) = toLps(r.col(a));
  header.grid.origin = toLps(Vec3(h.offset[0], h.offset[1], h.offset[2]));
  header.sources = {"dim", {}, "qoffset (qform)", "quatern (qform)"};
  setVoxelSize(h, header);
}

void useSform(const NiftiHeader& h, VolumeHeader& header, const std::string& path) {
  for (int a = 0; a < 3; ++a) {
    const auto i = static_cast<std::size_t>(a);
    const Vec3 axis(h.rows[i], h.rows[4 + i], h.rows[8 + i]);
    const double length = axis.norm();
    if (!(length > 0)) refuseInput(path, FindingKind::sformWithoutLength);
    header.grid.spacing[a] = length;
    header.grid.direction.col(a) = toLps(axis / length);
  }
  header.grid.origin = toLps(Vec3(h.rows[3], h.rows[7], h.rows[11]));
  header.sources = {"dim", {"srow (sform)", "srow (sform)", "srow (sform)"}, "srow (sform)", "srow (sform)"};
}

//! Largest distance (mm) between where the sform and the grid put a corner of the volume.
double distanceFromSform(const NiftiHeader& h, const Grid& grid) {
  double largest = 0;
  for (int corner = 0; corner < 8; ++corner) {
    Vec3 index(0, 0, 0);
    for (int a = 0; a < 3; ++a)
      if (corner >> a & 1) index[a] = grid.size[a];
    Vec3 world;
    for (int r = 0; r < 3; ++r) {
      const double* row = &h.rows[idx(4) * idx(r)];
      world[r] = row[0] * index[0] + row[1] * index[1] + row[2] * index[2] + row[3];
    }
    largest = std::max(largest, (toLps(world) - grid.toWorld(index)).norm());
  }
  return largest;
}

//! Lengths in metres or micrometres become millimetres.
void setUnit(const NiftiHeader& h, VolumeHeader& header) {
  const int unit = h.units & 7;
  if (unit != 1 && unit != 3) return;
  const double factor = unit == 1 ? 1000 : 0.001;
  for (int a = 0; a < 3; ++a)
    if (header.sources.spacing[a] != "assumed") header.grid.spacing[a] *= factor;
  header.grid.origin *= factor;
  header.warnings.push_back(unit == 1 ? FindingKind::lengthsInMetres : FindingKind::lengthsInMicrometres);
}

}  // namespace

NiftiHeader readNiftiHeader(const std::string& path) {
  Bytes b;
  ByteStream stream(path, 0, isGzip(path) ? ByteStream::Coding::deflate : ByteStream::Coding::raw);
  const std::size_t got = stream.read(b.bytes.data(), b.bytes.size());
  std::int32_t size = b.at<std::int32_t>(0);
  b.swapped = size != 348 && size != 540;
  size = b.at<std::int32_t>(0);
  if (size != 348 && size != 540) refuseInput(path, FindingKind::notNifti);
  if (got < static_cast<std::size_t>(size))
    refuseInput(path,
                {FindingKind::headerCutOff, {{"format", std::string(size == 540 ? "NIfTI-2" : "NIfTI")}}});
  NiftiHeader h;
  h.swapped = b.swapped;
  const unsigned char* magic = b.bytes.data() + (size == 540 ? 4 : 344);
  const unsigned char version = size == 540 ? '2' : '1';
  h.pair = magic[0] == 'n' && magic[1] == 'i' && magic[2] == version;
  const bool single = magic[0] == 'n' && magic[1] == '+' && magic[2] == version;
  if (!h.pair && !single)
    size == 540 ? refuseHeader(path, "NIfTI-2", "magic") : refuseInput(path, FindingKind::analyzeFile);
  if (size == 540)
    readSecond(b, h);
  else
    readFirst(b, h);
  return h;
}

void setNiftiGeometry(const NiftiHeader& nifti, VolumeHeader& header, const std::string& path) {
  if (nifti.qform > 0) {
    useQform(nifti, header);
  } else if (nifti.sform > 0) {
    useSform(nifti, header, path);
  } else {
    header.grid.direction.diagonal() = Vec3(-1, -1, 1);
    header.sources = {"dim", {}, "assumed", "assumed (RAS axes)"};
    setVoxelSize(nifti, header);
    header.warnings.push_back(FindingKind::placeUnknown);
  }
  const bool hasBoth = nifti.qform > 0 && nifti.sform > 0;
  if (hasBoth && std::any_of(nifti.rows.begin(), nifti.rows.end(), [](double v) { return std::isnan(v); }))
    refuseInput(path, FindingKind::sformNoNumber);
  const double apart = hasBoth ? distanceFromSform(nifti, header.grid) : 0;
  if (apart > 0.1)
    header.warnings.push_back({FindingKind::formsDisagree, {{"apart_mm", std::ceil(std::min(apart, 1e9))}}});
  setUnit(nifti, header);
}

}  // namespace handlebody
