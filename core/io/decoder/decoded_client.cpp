// DICOM and TIFF as the rest of the program sees them: decoded by a child process.

#include "core/io/decoder/decoder_process.h"

namespace handlebody {
namespace {

//! Part of the progress that finding and sorting the slices takes.
constexpr double kScanPart = 0.2;

class DecodedClient : public VolumeSource {
 public:
  DecodedClient(const OpenRequest& request, const ReadProgress& progress)
      : decoder_(request.path, request.selection.decoder) {
    decoder_.send(requestToMessage(request));
    const Message answer = decoder_.receive(progress, 0, kScanPart);
    try {
      header_ = headerFromMessage(answer.at("header"));
    } catch (const Message::exception&) {
      refuseInput(request.path, FindingKind::decoderAnswer);
    }
    if (!header_.isChoice) checkHeader(header_, request.path);
  }

  std::shared_ptr<void> read(int frame, const std::string&, const ReadProgress& progress) override {
    const std::uint64_t bytes = header_.bytesPerFrame();
    // The voxels, the slices as they are where they are resampled, and a compressed file.
    constexpr std::uint64_t kForDecoding = 512u << 20;
    decoder_.allowMemory(kForDecoding + 3 * bytes);
    decoder_.send({{"frame", frame}});
    decoder_.receive(progress, kScanPart, 1);
    return decoder_.takeMemory(bytes);
  }

 protected:
  void readFrame(int, void*, const ReadProgress&) override {}  // read() does it

 private:
  DecoderProcess decoder_;
};

}  // namespace

SourcePointer openTiff(const OpenRequest& request, const ReadProgress& progress) {
  OpenRequest tiff = request;
  tiff.format = "TIFF";
  return std::make_unique<DecodedClient>(tiff, progress);
}

SourcePointer openDicom(const OpenRequest& request, const ReadProgress& progress) {
  return std::make_unique<DecodedClient>(request, progress);
}

}  // namespace handlebody
