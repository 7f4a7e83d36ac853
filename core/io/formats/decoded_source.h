#pragma once
// Internal: volumes that libraries decode which cannot be trusted with any file or do not stop when asked to
// (GDCM, libtiff), decoded in this process. Only the child process that decodes opens them so.

#include <functional>
#include <string>

#include "core/io/formats/volume_source.h"

namespace handlebody {

//! Called before each piece of work: the part done (0 … 1), the file that comes next, and its bytes.
using DecodingProgress = std::function<void(double part, const std::string& file, std::uint64_t bytes)>;

//! Fills memory of the caller, and says what it does file by file.
class DecodedSource : public VolumeSource {
 public:
  virtual void decode(int frame, void* to, const DecodingProgress& progress) = 0;
};

//! As openTiff, here.
SourcePointer openTiffHere(const OpenRequest& request, const DecodingProgress& progress);

}  // namespace handlebody
