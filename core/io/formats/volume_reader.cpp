#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "core/cancellation.h"
#include "core/errors.h"
#include "core/io/formats/volume_io.h"
#include "core/io/formats/volume_source.h"
#include "core/phase.h"
#include "core/told_error.h"
#include "core/volume/not_a_number.h"

namespace handlebody {
namespace {

//! The type of the voxels we hand out: the file's own, widened where it must be.
VoxelType voxelTypeOf(const VolumeHeader& h) {
  const bool wide =
      bytesOf(h.component) == 8 || h.component == Component::int32 || h.component == Component::uint32;
  if (h.scaled()) return wide ? VoxelType::float64 : VoxelType::float32;
  switch (h.component) {
    case Component::int64:
    case Component::uint64:
      return VoxelType::float64;
    default:
      return static_cast<VoxelType>(h.component);
  }
}
static_assert(static_cast<int>(VoxelType::uint8) == static_cast<int>(Component::uint8));
static_assert(static_cast<int>(VoxelType::float64) == static_cast<int>(Component::float64));

template <typename To>
void scaleInto(const VolumeHeader& h, const void* from, void* to) {
  auto* out = static_cast<To*>(to);
  visitComponents(h.component, from, [&](const auto* in) {
    for (std::size_t i = 0, n = h.grid.voxelCount(); i < n; ++i)
      out[i] = static_cast<To>(h.slope * static_cast<double>(in[i]) + h.intercept);
  });
}

template <typename T>
void luminanceInto(const VolumeHeader& h, const T* in, void* to) {
  auto* out = static_cast<T*>(to);
  const auto step = static_cast<std::size_t>(h.components);
  for (std::size_t i = 0, n = h.grid.voxelCount(); i < n; ++i, in += step)
    out[i] = static_cast<T>(std::lround(0.2125 * in[0] + 0.7154 * in[1] + 0.0721 * in[2]));
}

void convertInto(const VolumeHeader& h, const void* from, VoxelType type, void* to) {
  if (h.components > 1) {
    if (h.component == Component::uint8)
      luminanceInto(h, static_cast<const std::uint8_t*>(from), to);
    else
      luminanceInto(h, static_cast<const std::uint16_t*>(from), to);
  } else if (type == VoxelType::float32) {
    scaleInto<float>(h, from, to);
  } else {
    scaleInto<double>(h, from, to);
  }
}

//! How many are not a number, or too large a one: they get one below the least of the others.
template <typename T>
std::size_t fillNotANumber(T* values, const Grid& grid, const std::string& path) {
  const std::size_t n = grid.voxelCount();
  std::size_t none = 0, infinite = 0, first = 0;
  T least = std::numeric_limits<T>::max();
  for (std::size_t i = 0; i < n; ++i) {
    const T v = values[i];
    if (isVoxelValue(v))
      least = std::min(least, v);
    else if (!std::isinf(v))
      ++none;
    else if (infinite++ == 0)
      first = i;
  }
  const auto nx = static_cast<std::size_t>(grid.size[0]), ny = static_cast<std::size_t>(grid.size[1]);
  if (infinite > 0) {
    const std::array<std::size_t, 3> at{first % nx, first / nx % ny, first / (nx * ny)};
    refuseInput(path, {infinite == 1 ? FindingKind::infiniteVoxel : FindingKind::infiniteVoxels,
                       {{"voxels", infinite},
                        {"index", placeValue(Vec3(static_cast<double>(at[0]), static_cast<double>(at[1]),
                                                  static_cast<double>(at[2])))}}});
  }
  if (none == n) refuseInput(path, FindingKind::noNumbers);
  if (none == 0) return 0;
  const T below = notANumberBelow(least);
  for (std::size_t i = 0; i < n; ++i)
    if (!isVoxelValue(values[i])) values[i] = below;
  return none;
}

void checkFrame(const VolumeSelection& selection, int frames, const std::string& path) {
  if (!selection.frame || (*selection.frame >= 0 && *selection.frame < frames)) return;
  throw Told<UsageError>(Finding(frames == 1 ? FindingKind::onlyFrame : FindingKind::frameMissing,
                                 {{"file", path}, {"frame", *selection.frame}, {"last", frames - 1}}));
}

//! "1.2.3#1 (MR head, 20 files, 256 x 256 x 20 voxels of 0.9, 0.9, 5 mm)"
Finding seriesFacts(const SeriesInfo& s) {
  const bool isOne = s.files == 1;
  const std::string size =
      std::to_string(s.size[0]) + " x " + std::to_string(s.size[1]) + " x " + std::to_string(s.size[2]);
  Finding::Values values = {{"series", s.uid.empty() ? "\"\"" : s.uid},
                            {"what", s.description.empty() ? "" : s.description + ", "},
                            {"files", s.files}};
  if (s.note.any())
    return {isOne ? FindingKind::brokenSeriesOfFile : FindingKind::brokenSeriesOfFiles, std::move(values)};
  values.emplace_back("size", size);
  values.emplace_back("spacing_mm", placeValue(s.spacing));
  return {isOne ? FindingKind::seriesOfFile : FindingKind::seriesOfFiles, std::move(values)};
}

Finding seriesChoice(const std::vector<SeriesInfo>& series) {
  std::vector<Finding> choices;
  for (const SeriesInfo& s : series) choices.push_back(seriesFacts(s));
  return {FindingKind::seriesToChoose, {{"series", series.size()}}, std::move(choices)};
}

void setSpacing(const VolumeSelection& selection, VolumeHeader& header, const std::string& path) {
  if (!selection.spacing) return;
  const Vec3& given = *selection.spacing;
  if (!given.allFinite() || given.minCoeff() <= 0)
    throw Told<UsageError>(Finding(FindingKind::spacingNotPositive, {{"file", path}}));
  if (header.calibrated && (given - header.grid.spacing).norm() > 1e-6 * given.norm())
    header.warnings.push_back({FindingKind::spacingOverridden,
                               {{"x_mm", header.grid.spacing.x()},
                                {"y_mm", header.grid.spacing.y()},
                                {"z_mm", header.grid.spacing.z()}}});
  if (header.dicom && !(header.calibrated && given == header.grid.spacing))
    header.dicom->displaced = FindingKind::spacingGiven;
  header.grid.spacing = given;
  header.calibrated = true;
  for (std::string& source : header.sources.spacing) source = "given by the user";
}

//! The images of one time point, of those of all.
std::shared_ptr<const DicomOrigin> originOf(const VolumeHeader& h, int frame) {
  if (!h.dicom || h.frames == 1 || h.hasLayers) return h.dicom;
  auto origin = std::make_shared<DicomOrigin>(*h.dicom);
  std::vector<DicomImage>& images = origin->images;
  const auto count = static_cast<std::ptrdiff_t>(images.size()) / h.frames;
  images = {images.begin() + count * frame, images.begin() + count * (frame + 1)};
  return origin;
}

VolumeInfo infoOf(const VolumeHeader& h, const VolumeSelection& selection, const std::string& path) {
  checkFrame(selection, h.frames, path);
  VolumeInfo info;
  info.path = path;
  info.format = h.format;
  info.series = h.series;
  info.warnings = h.warnings;
  info.grid = h.grid;
  info.type = voxelTypeOf(h);
  (h.hasLayers ? info.layers : info.frames) = h.frames;
  info.calibrated = h.calibrated;
  info.sources = h.sources;
  info.dicom = originOf(h, selection.frame.value_or(0));
  if (h.frames > 1 && !selection.frame)
    info.warnings.push_back(h.hasLayers ? Finding(FindingKind::firstLayerUsed, {{"layers", h.frames}})
                                        : Finding(FindingKind::frameZeroUsed, {{"frames", h.frames}}));
  if (!h.calibrated) info.warnings.push_back(FindingKind::uncalibrated);
  return info;
}

//! Voxels of the type that is handed out, from those of the file.
std::shared_ptr<void> converted(const VolumeHeader& h, VoxelType type, std::shared_ptr<void> stored,
                                const std::string& path) {
  const bool widen = static_cast<int>(type) != static_cast<int>(h.component);
  if (h.components == 1 && !h.scaled() && !widen) return stored;
  std::shared_ptr<void> result = allocate(h.grid.voxelCount() * bytesPerVoxel(type), path);
  convertInto(h, stored.get(), type, result.get());
  return result;
}

//! `voxels`: of the volume, before anybody else has them.
void fillNotANumber(void* voxels, LoadedVolume& loaded, const std::string& path) {
  const Volume& v = loaded.volume;
  std::size_t none = 0;
  if (v.type == VoxelType::float32) none = fillNotANumber(static_cast<float*>(voxels), v.grid, path);
  if (v.type == VoxelType::float64) none = fillNotANumber(static_cast<double*>(voxels), v.grid, path);
  if (none > 0)
    loaded.info.warnings.push_back(
        {FindingKind::voxelsNotNumbers, {{"none", none}, {"voxels", v.grid.voxelCount()}}});
}

LoadedVolume load(const OpenRequest& request, const ReadProgress& progress) {
  const Phase phase("reading");
  const std::string& path = request.path;
  const SourcePointer source = openVolume(request, progress);
  VolumeHeader& h = source->header();
  if (h.isChoice)
    throw SeriesChoiceNeeded({FindingKind::fileRefused, {{"file", path}}, seriesChoice(h.series)}, h.series);
  setSpacing(request.selection, h, path);
  LoadedVolume loaded{{}, infoOf(h, request.selection, path)};
  Volume& volume = loaded.volume;
  volume = {h.grid, loaded.info.type, nullptr};
  const std::shared_ptr<void> voxels =
      converted(h, volume.type, source->read(request.selection.frame.value_or(0), path, progress), path);
  fillNotANumber(voxels.get(), loaded, path);
  volume.voxels = voxels;
  tellProgress(progress, 1);
  return loaded;
}

}  // namespace

void tellProgress(const ReadProgress& progress, double part) {
  giveUpIfCancelled();
  if (progress) progress(std::clamp(part, 0.0, 1.0));
}

VolumeInfo inspectVolume(const std::string& path, const VolumeSelection& selection) {
  const Phase phase("reading");
  const SourcePointer source = openVolume({path, selection}, {});
  VolumeHeader& h = source->header();
  if (!h.isChoice) {
    setSpacing(selection, h, path);
    return infoOf(h, selection, path);
  }
  VolumeInfo info;
  info.path = path;
  info.format = h.format;
  info.series = h.series;
  info.frames = 0;
  info.warnings = h.warnings;
  info.warnings.push_back({FindingKind::nothingChosen, {}, seriesChoice(h.series)});
  return info;
}

Grid checkedGrid(const Grid& grid, VoxelType type, const std::string& name) {
  VolumeHeader header;
  header.grid = grid;
  header.component = static_cast<Component>(type);
  checkHeader(header, name);
  return header.grid;
}

LoadedVolume fillVolume(const Grid& grid, VoxelType type, const std::string& name,
                        const std::function<void(void*)>& fill) {
  VolumeHeader header;
  header.grid = checkedGrid(grid, type, name);
  header.component = static_cast<Component>(type);
  header.sources = {"given", {"given", "given", "given"}, "given", "given"};
  LoadedVolume loaded{{header.grid, type, nullptr}, infoOf(header, {}, name)};
  const std::shared_ptr<void> voxels = allocate(header.bytesPerFrame(), name);
  fill(voxels.get());
  fillNotANumber(voxels.get(), loaded, name);
  loaded.volume.voxels = voxels;
  return loaded;
}

Volume readVolume(const std::string& path, const VolumeSelection& selection) {
  return load({path, selection}, {}).volume;
}

LoadedVolume loadVolume(const std::string& path, const VolumeSelection& selection,
                        const ReadProgress& progress) {
  return load({path, selection}, progress);
}

}  // namespace handlebody
