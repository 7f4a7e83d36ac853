#include "core/io/formats/stored_voxels.h"

#include "core/io/formats/byte_stream.h"

namespace handlebody {
namespace {

class StoredSource : public VolumeSource {
 public:
  StoredSource(const VolumeHeader& header, const StoredVoxels& voxels, const std::string& path)
      : voxels_(voxels) {
    header_ = header;
    checkDataSize(path, voxels_.file, voxels_.offset + (voxels_.isPacked ? 0 : voxels_.skip),
                  header_.bytesPerFrame() * static_cast<std::uint64_t>(header_.frames), voxels_.isPacked);
  }

 protected:
  void readFrame(int frame, void* to, const ReadProgress& progress) override {
    const std::uint64_t bytes = header_.bytesPerFrame();
    const std::uint64_t before = voxels_.skip + bytes * static_cast<std::uint64_t>(frame);
    ByteStream stream(voxels_.file, voxels_.offset + (voxels_.isPacked ? 0 : before),
                      voxels_.isPacked ? ByteStream::Coding::deflate : ByteStream::Coding::raw);
    if (voxels_.isPacked) stream.skip(before, progress);
    stream.readAll(to, static_cast<std::size_t>(bytes), progress);
    stream.checkEnd(frame + 1 < header_.frames);
    if (voxels_.isSwapped) swapVoxels(header_, to);
  }

 private:
  StoredVoxels voxels_;
};

}  // namespace

SourcePointer storedSource(const VolumeHeader& header, const StoredVoxels& voxels, const std::string& path) {
  return std::make_unique<StoredSource>(header, voxels, path);
}

}  // namespace handlebody
