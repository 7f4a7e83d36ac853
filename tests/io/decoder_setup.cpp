// These tests are no neighbours of handlebody-cli, which decodes DICOM for them.

#include "core/io/formats/volume_io.h"

namespace {

const bool kDecoderIsSet = [] {
  handlebody::setDicomDecoder({HANDLEBODY_CLI});
  return true;
}();

}  // namespace
