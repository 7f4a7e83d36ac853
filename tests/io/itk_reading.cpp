// The peer of reading_bench: ITK alone. In a file of its own, for its Eigen.

#include <itkGDCMImageIOFactory.h>
#include <itkGDCMSeriesFileNames.h>
#include <itkImageFileReader.h>
#include <itkImageSeriesReader.h>
#include <itkMetaImageIOFactory.h>
#include <itkNiftiImageIOFactory.h>
#include <itkNrrdImageIOFactory.h>

#include <filesystem>

using Image = itk::Image<std::int16_t, 3>;

void registerItkFormats() {
  itk::NiftiImageIOFactory::RegisterOneFactory();
  itk::NrrdImageIOFactory::RegisterOneFactory();
  itk::MetaImageIOFactory::RegisterOneFactory();
  itk::GDCMImageIOFactory::RegisterOneFactory();
}

long readWithItk(const std::string& path) {
  Image::Pointer image;
  if (std::filesystem::is_directory(path)) {
    const auto names = itk::GDCMSeriesFileNames::New();
    names->SetDirectory(path);
    const auto reader = itk::ImageSeriesReader<Image>::New();
    reader->SetFileNames(names->GetInputFileNames());
    reader->Update();
    image = reader->GetOutput();
  } else {
    const auto reader = itk::ImageFileReader<Image>::New();
    reader->SetFileName(path);
    reader->Update();
    image = reader->GetOutput();
  }
  return image->GetBufferPointer()[1000];
}
