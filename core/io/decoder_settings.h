#pragma once
// The process that decodes what may crash or hang, as a reader is told of it.

#include <string>

namespace handlebody {

//! The program that decodes DICOM and TIFF volumes and VTP meshes, and how long it may go without a sign of
//! life.
struct DecoderSettings {
  //! Started as `program decode-dicom`. Empty: handlebody-cli in the folder of the running program (in a
  //! build tree, ../../app or ../../../app from it).
  std::string program{};
  //! Seconds of the processor's time for one image, and for every 100 MB of its file 5 more; 8 times as many
  //! by the clock.
  double patience = 8;
};

}  // namespace handlebody
