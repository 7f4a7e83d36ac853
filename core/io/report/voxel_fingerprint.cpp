#include "core/io/report/voxel_fingerprint.h"

#include <algorithm>

#include "core/cancellation.h"
#include "core/io/formats/sha256.h"
#include "core/told_error.h"

namespace handlebody {

namespace {

using K = FindingKind;

//! One that cannot be read is not the one.
bool hasVoxels(const VolumeReference& reference, const std::string& series) try {
  VolumeSelection selection = reference.selection;
  selection.series = series;
  return sha256OfVoxels(readVolume(reference.path, selection)) == reference.voxels;
} catch (const InputError&) {
  return false;
} catch (const UsageError&) {  // it has no such frame
  return false;
}

}  // namespace

std::string sha256OfVoxels(const Volume& volume) {
  std::string head = voxelTypeName(volume.type);
  for (const int n : volume.grid.size) head += ' ' + std::to_string(n);
  return sha256OfBytes(head + '\n', volume.voxels.get(),
                       volume.grid.voxelCount() * bytesPerVoxel(volume.type));
}

void keepVoxels(VolumeReference& reference, const Volume& volume) {
  if (reference.selection.series) reference.voxels = sha256OfVoxels(volume);
}

void findSeries(VolumeReference& reference) {
  if (reference.voxels.empty() || reference.selection.series) return;
  const std::vector<SeriesInfo> found = inspectVolume(reference.path, reference.selection).series;
  if (found.size() < 2) return;
  for (const SeriesInfo& series : found) {
    giveUpIfCancelled();
    if (series.note.any() || !hasVoxels(reference, series.uid)) continue;
    reference.selection.series = series.uid;
    return;
  }
  throw Told<InputError>(Finding(K::seriesNotFound, {{"file", reference.path}}));
}

void verifyVoxels(const VolumeReference& reference, const Volume& volume) {
  if (reference.voxels.empty() || sha256OfVoxels(volume) == reference.voxels) return;
  if (!reference.selection.series)
    throw Told<InputError>(Finding(K::volumeChanged, {{"file", reference.path}}));
  throw Told<InputError>(
      Finding(K::seriesChanged, {{"file", reference.path}, {"series", *reference.selection.series}}));
}

}  // namespace handlebody
