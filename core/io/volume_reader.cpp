#include <algorithm>
#include <cmath>
#include <memory>

#include "core/errors.h"
#include "core/io/volume_io.h"
#include "core/io/volume_source.h"

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

template <typename F>
void visitComponents(Component c, const void* p, F&& f) {
  switch (c) {
    case Component::uint8:
      return f(static_cast<const std::uint8_t*>(p));
    case Component::int8:
      return f(static_cast<const std::int8_t*>(p));
    case Component::uint16:
      return f(static_cast<const std::uint16_t*>(p));
    case Component::int16:
      return f(static_cast<const std::int16_t*>(p));
    case Component::uint32:
      return f(static_cast<const std::uint32_t*>(p));
    case Component::int32:
      return f(static_cast<const std::int32_t*>(p));
    case Component::float32:
      return f(static_cast<const float*>(p));
    case Component::float64:
      return f(static_cast<const double*>(p));
    case Component::int64:
      return f(static_cast<const std::int64_t*>(p));
    case Component::uint64:
      return f(static_cast<const std::uint64_t*>(p));
  }
}

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

void convertInto(const VolumeHeader& h, const void* from, Volume& volume, void* to) {
  if (h.components > 1) {
    if (h.component == Component::uint8)
      luminanceInto(h, static_cast<const std::uint8_t*>(from), to);
    else
      luminanceInto(h, static_cast<const std::uint16_t*>(from), to);
  } else if (volume.type == VoxelType::float32) {
    scaleInto<float>(h, from, to);
  } else {
    scaleInto<double>(h, from, to);
  }
}

template <typename T>
void checkFinite(const T* values, const Grid& grid, const std::string& path) {
  std::size_t bad = 0, first = 0;
  for (std::size_t i = 0, n = grid.voxelCount(); i < n; ++i)
    if (!std::isfinite(values[i]) && bad++ == 0) first = i;
  if (bad == 0) return;
  const auto nx = static_cast<std::size_t>(grid.size[0]), ny = static_cast<std::size_t>(grid.size[1]);
  refuseInput(path, std::to_string(bad) +
                        " of its voxels are not a number or infinite, the first at index (" +
                        std::to_string(first % nx) + ", " + std::to_string(first / nx % ny) + ", " +
                        std::to_string(first / (nx * ny)) + ")");
}

void checkFrame(const VolumeSelection& selection, int frames, const std::string& path) {
  if (!selection.frame || (*selection.frame >= 0 && *selection.frame < frames)) return;
  throw UsageError(path + ": there is no frame " + std::to_string(*selection.frame) + "; it has " +
                   (frames == 1 ? "one frame, 0." : "the frames 0 to " + std::to_string(frames - 1) + "."));
}

std::string seriesChoice(const std::vector<SeriesInfo>& series) {
  std::string text = "it holds " + std::to_string(series.size()) + " series, choose one with --series: ";
  for (std::size_t i = 0; i < series.size(); ++i) {
    const SeriesInfo& s = series[i];
    text += (i ? ", " : "") + s.uid + " (" + (s.description.empty() ? "" : s.description + ", ") +
            std::to_string(s.files) + (s.files == 1 ? " file)" : " files)");
  }
  return text;
}

//! Owns its memory without clearing it first: every byte is read from the file or the reading throws.
struct Buffer {
  std::shared_ptr<double[]> memory;  // double: aligned for every voxel type
  Buffer(std::uint64_t bytes, const std::string& path) {
    try {
      memory.reset(new double[static_cast<std::size_t>(bytes) / sizeof(double) + 1]);
    } catch (const std::bad_alloc&) {
      refuseInput(path, "there is not enough memory to read it");
    }
  }
};

}  // namespace

VolumeInfo inspectVolume(const std::string& path, const VolumeSelection& selection) {
  bool several = false;
  const SourcePointer source = openVolume(path, selection, &several);
  const VolumeHeader& h = source->header();
  VolumeInfo info;
  info.path = path;
  info.format = h.format;
  info.series = h.series;
  info.warnings = h.warnings;
  if (several) {
    info.frames = 0;
    info.warnings.push_back("Nothing is chosen: " + seriesChoice(h.series) + ".");
    return info;
  }
  checkFrame(selection, h.frames, path);
  info.grid = h.grid;
  info.type = voxelTypeOf(h);
  info.frames = h.frames;
  if (h.frames > 1 && !selection.frame)
    info.warnings.push_back("There are " + std::to_string(h.frames) + " time points; frame 0 is used.");
  return info;
}

Volume readVolume(const std::string& path, const VolumeSelection& selection) {
  bool several = false;
  const SourcePointer source = openVolume(path, selection, &several);
  const VolumeHeader& h = source->header();
  if (several) refuseInput(path, seriesChoice(h.series));
  checkFrame(selection, h.frames, path);

  Volume volume{h.grid, voxelTypeOf(h), nullptr};
  const bool widen = static_cast<int>(volume.type) != static_cast<int>(h.component);
  Buffer voxels(h.bytesPerFrame(), path);
  source->readFrame(selection.frame.value_or(0), voxels.memory.get());
  if (h.components > 1 || h.scaled() || widen) {
    Buffer converted(h.grid.voxelCount() * bytesPerVoxel(volume.type), path);
    convertInto(h, voxels.memory.get(), volume, converted.memory.get());
    voxels = converted;
  }
  volume.voxels = std::shared_ptr<const void>(voxels.memory, voxels.memory.get());
  if (volume.type == VoxelType::float32) checkFinite(volume.data<float>(), h.grid, path);
  if (volume.type == VoxelType::float64) checkFinite(volume.data<double>(), h.grid, path);
  return volume;
}

}  // namespace handlebody
