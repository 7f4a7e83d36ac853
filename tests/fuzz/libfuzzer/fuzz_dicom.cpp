// The walk through a DICOM file before GDCM sees it, what it says of segments, and the messages of the child
// process that decodes.

#include "core/io/decoder/decoder_channel.h"
#include "core/io/dicom/dicom_segments.h"
#include "core/io/dicom/dicom_structure.h"
#include "tests/fuzz/libfuzzer/scratch_file.h"

namespace {

void readMessage(const std::uint8_t* bytes, std::size_t n) try {
  const handlebody::Message message = handlebody::Message::from_cbor(bytes, bytes + n, true, false);
  if (!message.is_discarded()) handlebody::headerFromMessage(message);
} catch (const handlebody::Message::exception&) {
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t n) {
  static const handlebody::test::ScratchFile file("slice");
  readMessage(bytes, n);
  return handlebody::test::answeredOrRefused([&] {
    const std::string& path = file.write(bytes, n);
    handlebody::readDicomLabels(path);
    handlebody::walkDicom(path);
  });
}
