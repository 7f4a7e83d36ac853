// Volumes and label maps through ITK. ITK's writers do not report a full disk in every format: what was
// written is read back and compared, and where it lies, before it gets its name.

#include <fcntl.h>
#include <itkMetaDataObject.h>
#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <itkNrrdImageIO.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "core/io/atomic_file.h"
#include "core/io/formats/itk_source.h"
#include "core/io/formats/volume_io.h"
#include "core/io/formats/volume_keys.h"
#include "core/io/lowered.h"
#include "core/io/meshes/mesh_io.h"
#include "core/told_error.h"

namespace handlebody {
namespace {

constexpr std::size_t kNiftiHeader = 352;

itk::ImageIOBase::Pointer writerFor(const std::string& path) {
  const std::string name = lowered(path);
  if (name.ends_with(".nii") || name.ends_with(".nii.gz")) return itk::NiftiImageIO::New().GetPointer();
  if (name.ends_with(".nrrd")) return itk::NrrdImageIO::New().GetPointer();
  if (name.ends_with(".mha")) {
    auto io = itk::MetaImageIO::New();
    io->SetDoublePrecision(17);  // 6 by default
    return io.GetPointer();
  }
  throw Told<UsageError>(Finding(FindingKind::noVolumeEnding, {{"file", path}}));
}

itk::IOComponentEnum componentOf(VoxelType type) {
  using E = itk::IOComponentEnum;
  static constexpr E kComponents[] = {E::UCHAR, E::CHAR, E::USHORT, E::SHORT,
                                      E::UINT,  E::INT,  E::FLOAT,  E::DOUBLE};
  return kComponents[static_cast<int>(type)];
}

void describe(itk::ImageIOBase& io, const Volume& volume) {
  itk::ImageIORegion region(3);
  io.SetNumberOfDimensions(3);
  for (unsigned a = 0; a < 3; ++a) {
    const auto n = static_cast<std::size_t>(volume.grid.size[a]);
    io.SetDimensions(a, n);
    region.SetSize(a, n);
    io.SetSpacing(a, volume.grid.spacing[a]);
    io.SetOrigin(a, volume.grid.origin[a]);
    const Vec3 axis = volume.grid.direction.col(a);
    io.SetDirection(a, std::vector<double>{axis[0], axis[1], axis[2]});
  }
  io.SetIORegion(region);
  io.SetPixelType(itk::IOPixelEnum::SCALAR);
  io.SetNumberOfComponents(1);
  io.SetComponentType(componentOf(volume.type));
}

void verify(const Volume& volume, const std::string& temporary, const std::string& path) {
  bool same = false;
  try {
    const Volume back = readVolume(temporary);
    same = back.grid.size == volume.grid.size && isGridKept(back.grid, volume.grid, path) &&
           back.type == volume.type &&
           std::memcmp(back.voxels.get(), volume.voxels.get(),
                       volume.grid.voxelCount() * bytesPerVoxel(volume.type)) == 0;
  } catch (const InputError&) {
    // Said below, with the right name.
  }
  if (!same) refuseOutput(path, FindingKind::notOnDisk);
}

//! NIfTI's library says on standard error what it could not write, and cannot be told not to: without room
//! for all of it, it is not asked. How much a packed file needs nobody knows; of those it says nothing.
void requireRoom(const Volume& volume, const std::string& temporary, const std::string& path) {
  const std::size_t bytes = kNiftiHeader + volume.grid.voxelCount() * bytesPerVoxel(volume.type);
  const int file = ::open(temporary.c_str(), O_WRONLY | O_CLOEXEC);
  if (file < 0) refuseOutput(path, systemFinding(errno));
  const int fault = ::posix_fallocate(file, 0, static_cast<off_t>(bytes));
  ::close(file);
  if (fault == ENOSPC || fault == EDQUOT || fault == EFBIG) refuseOutput(path, systemFinding(fault));
}

}  // namespace

bool isLabelMapPath(const std::string& path) {
  const std::string name = lowered(path);
  for (const char* ending : {".nii", ".nii.gz", ".nrrd", ".mha"})
    if (name.ends_with(ending)) return true;
  return false;
}

void writeVolume(const Volume& volume, const std::string& path) { writeVolumeWithKeys(volume, path, {}); }

void writeVolumeWithKeys(const Volume& volume, const std::string& path,
                         const std::map<std::string, std::string>& keys) {
  const auto io = writerFor(path);
  for (int n : volume.grid.size)
    if (n < 2) refuseOutput(path, FindingKind::volumeTooThin);
  // NIfTI holds sizes in 16 bits.
  if (dynamic_cast<itk::NiftiImageIO*>(io.GetPointer()))
    for (int n : volume.grid.size)
      if (n > 32767) refuseOutput(path, FindingKind::niftiTooLarge);
  writeAtomically(path, [&](const std::string& temporary) {
    if (lowered(path).ends_with(".nii")) requireRoom(volume, temporary, path);
    try {
      const Quiet quiet;
      describe(*io, volume);
      for (const auto& [key, value] : keys)
        itk::EncapsulateMetaData<std::string>(io->GetMetaDataDictionary(), key, value);
      io->SetFileName(temporary);
      io->SetUseCompression(true);
      io->WriteImageInformation();
      io->Write(volume.voxels.get());
    } catch (const itk::ExceptionObject& e) {
      refuseOutput(path, FindingKind::diskMayBeFull);
    }
    verify(volume, temporary, path);
  });
}

}  // namespace handlebody
