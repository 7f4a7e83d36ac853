#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include "app/picture/picture.h"
#include "app/picture/picture_canvas.h"
#include "core/errors.h"
#include "core/io/meshes/mesh_files.h"

namespace handlebody {
namespace {

//! Mean of the pixels that one pixel of the small picture covers. VTK's rows run up.
Colour meanColour(vtkImageData& image, int x, int y) {
  Colour sum = Colour::Zero();
  for (int dy = 0; dy < kThumbnailPart; ++dy)
    for (int dx = 0; dx < kThumbnailPart; ++dx) {
      const auto* rgb = static_cast<const unsigned char*>(
          image.GetScalarPointer(x * kThumbnailPart + dx, kPictureHeight - 1 - y * kThumbnailPart - dy, 0));
      sum += Colour(rgb[0], rgb[1], rgb[2]);
    }
  return sum / (255.0F * kThumbnailPart * kThumbnailPart);
}

}  // namespace

std::string thumbnailOf(const std::string& picture) {
  const VtkSilence silence;
  vtkNew<vtkPNGReader> reader;
  if (reader->CanReadFile(picture.c_str()) == 0) throw InputError(picture + ": it is not a PNG.");
  reader->SetFileName(picture.c_str());
  reader->Update();
  vtkImageData& image = *reader->GetOutput();
  const int* size = image.GetDimensions();
  if (size[0] != kPictureWidth || size[1] != kPictureHeight || image.GetScalarType() != VTK_UNSIGNED_CHAR ||
      image.GetNumberOfScalarComponents() != 3)
    throw InputError(picture + ": it is not a picture of a result.");
  Canvas canvas(kPictureWidth / kThumbnailPart, kPictureHeight / kThumbnailPart, Colour::Zero());
  for (int y = 0; y < canvas.height(); ++y)
    for (int x = 0; x < canvas.width(); ++x) canvas.at(x, y) = meanColour(image, x, y);
  return pngBytes(canvas);
}

}  // namespace handlebody
