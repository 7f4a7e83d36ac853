#include "core/io/dicom/dicom_echo.h"

#include <algorithm>

#include "core/io/dicom/dicom_pixels.h"
#include "core/io/dicom/dicom_values.h"

namespace handlebody {
namespace {

using gdcm::Tag;

//! The private block that holds the rest.
const Tag kCreator(0x3001, 0x0010), kSlices(0x3001, 0x1001), kSliceDistance(0x3001, 0x1003);
//! Centimetres, in the data set itself instead of in an ultrasound region.
const Tag kColumnDistance(0x0018, 0x602c), kRowDistance(0x0018, 0x602e);
const Tag kFrameTime(0x0018, 0x1063);  // ms

//! More slices than any probe resolves; a header that says more is damaged.
constexpr std::uint32_t kMaxSlices = 4096;

double millimetres(const gdcm::DataSet& data, const Tag& tag) {
  const double cm = dicom::binary<double>(data, tag).value_or(0);
  return std::isfinite(cm) ? 10 * std::abs(cm) : 0;
}

DicomPlace placeOf(const Vec3& distance, int volume, int slice, std::optional<double> frameTime) {
  DicomPlace place;
  place.rowDirection = Vec3(-1, 0, 0);
  place.columnDirection = Vec3(0, 1, 0);
  place.position = Vec3(0, 0, -distance.z() * slice);
  place.pixelSpacing = Vec3(distance.x(), distance.y(), 0);
  place.time = volume;
  if (frameTime) place.milliseconds = *frameTime * volume;
  return place;
}

void name(DicomFile& f) {
  f.spacingSource = "Philips' Cartesian echo: PhysicalDeltaX, PhysicalDeltaY (0018,602C; 0018,602E)";
  f.positionSource = "Philips' Cartesian echo: distance of slices (3001,1003)";
  f.orientationSource = "assumed";
  f.timeSource = "FrameTime (0018,1063)";
  f.ownFrameOfReference = true;
}

}  // namespace

void readCartesianEcho(const gdcm::DataSet& data, DicomFile& f) {
  if (dicom::text(data, kCreator) != "Philips3D" || !hasPlainPixels(f) || f.samples != 1) return;
  const std::uint32_t slices = dicom::binary<std::uint32_t>(data, kSlices).value_or(0);
  const Vec3 distance(millimetres(data, kColumnDistance), millimetres(data, kRowDistance),
                      millimetres(data, kSliceDistance));
  if (slices < 2 || slices > kMaxSlices || !(distance.minCoeff() > 0)) return;
  std::optional<double> frameTime = dicom::number(data, kFrameTime);
  if (frameTime && !(*frameTime > 0 && std::isfinite(*frameTime))) frameTime.reset();
  f.echo = {static_cast<int>(slices), f.frames};
  f.places.clear();
  for (int volume = 0; volume < f.echo.volumes; ++volume)
    for (int slice = 0; slice < f.echo.slices; ++slice)
      f.places.push_back(placeOf(distance, volume, slice, frameTime));
  f.frames = static_cast<int>(f.places.size());
  name(f);
}

bool keepWholeVolumes(DicomFile& f) {
  if (f.echo.slices == 0 || !f.structure.walked) return false;
  const std::uint64_t bytes = f.pixelsPerFrame() * static_cast<std::uint64_t>(f.echo.slices) *
                              static_cast<std::uint64_t>(f.bitsAllocated / 8);
  if (bytes == 0) return false;
  const int whole = static_cast<int>(
      std::min<std::uint64_t>(f.structure.pixelBytes / bytes, static_cast<std::uint64_t>(f.echo.volumes)));
  if (whole == 0) return false;
  f.frames = whole * f.echo.slices;
  f.places.resize(f.frames);
  return true;
}

Finding missingVolumes(const DicomFile& f) {
  const int whole = f.echo.slices > 0 ? f.frames / f.echo.slices : 0;
  if (whole == f.echo.volumes) return {};
  return {whole == 1 ? FindingKind::breaksOffAfterOne : FindingKind::breaksOff,
          {{"frames", f.echo.volumes}, {"whole", whole}}};
}

}  // namespace handlebody
