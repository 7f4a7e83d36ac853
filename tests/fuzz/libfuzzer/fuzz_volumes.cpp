// NIfTI, NRRD and MetaImage: headers, checks of sizes, and voxels.

#include "core/io/decoder/decoder_channel.h"
#include "core/io/formats/volume_io.h"
#include "core/io/formats/volume_source.h"
#include "tests/fuzz/libfuzzer/scratch_file.h"

namespace handlebody {

// What a child process decodes is no part of this target.
SourcePointer openDicom(const OpenRequest& request, const ReadProgress&) {
  refuseInput(request.path, "not here");
}
SourcePointer openTiff(const OpenRequest& request, const ReadProgress&) {
  refuseInput(request.path, "not here");
}

}  // namespace handlebody

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t n) {
  static const handlebody::test::ScratchFile file("v");
  return handlebody::test::answeredOrRefused([&] { handlebody::readVolume(file.write(bytes, n)); });
}
