#pragma once
// Internal: headers and voxels through an itk::ImageIOBase. Only the sources that use ITK include this.

#include <itkImageIOBase.h>

#include <functional>

#include "core/io/formats/itk_guard.h"
#include "core/io/formats/volume_source.h"

namespace handlebody {

//! Reads the header of `path` through `io`. Throws InputError for fewer dimensions than `least` (2: a slice
//! is a volume of one), more than four, vectors and unknown voxel types.
VolumeHeader readItkHeader(itk::ImageIOBase& io, const std::string& path, const std::string& format,
                           unsigned least = 3);

//! Component type of the IO's image. Throws InputError for one we do not know.
Component itkComponent(const itk::ImageIOBase& io, const std::string& path);

}  // namespace handlebody
