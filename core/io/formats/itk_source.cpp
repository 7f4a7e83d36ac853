#include "core/io/formats/itk_source.h"

#include <gdcmTrace.h>
#include <itkObject.h>

#include <algorithm>
#include <iostream>
#include <limits>
#include <sstream>

#include "core/errors.h"

namespace handlebody {
namespace {

//! ITK's description without the name of its class and its line breaks: one sentence, one line.
std::string oneLine(const std::string& description) {
  std::istringstream lines(description);
  std::string line, result;
  while (std::getline(lines, line)) {
    const auto colon = line.find("): ");
    if (line.rfind("ITK ERROR: ", 0) == 0 && colon != std::string::npos) line = line.substr(colon + 3);
    while (!line.empty() && (std::isspace(static_cast<unsigned char>(line.back())) || line.back() == '.'))
      line.pop_back();
    if (line.empty()) continue;
    result += (result.empty() ? "" : "; ") + line;
    if (result.size() > 200) break;
  }
  return result.substr(0, 240);
}

int sizeOf(const itk::ImageIOBase& io, unsigned axis, const std::string& path) {
  const auto n = io.GetDimensions(axis);
  if (n > static_cast<std::uint64_t>(std::numeric_limits<int>::max()))
    refuseInput(path, {FindingKind::implausibleSize, {{"size", std::to_string(n)}}});
  return static_cast<int>(n);
}

void readComponents(const itk::ImageIOBase& io, const std::string& path, VolumeHeader& header) {
  header.component = itkComponent(io, path);
  header.components = static_cast<int>(io.GetNumberOfComponents());
  if (header.components == 1) return;
  const auto pixel = io.GetPixelType();
  const bool named = pixel == itk::IOPixelEnum::RGB || pixel == itk::IOPixelEnum::RGBA;
  // MetaImage has no word for colour: three or four bytes per voxel are colour by convention.
  const bool conventional = header.format == "MetaImage" && header.component == Component::uint8 &&
                            (header.components == 3 || header.components == 4);
  const bool integers = header.component == Component::uint8 || header.component == Component::uint16;
  if (!(named || conventional) || !integers)
    refuseInput(path, {FindingKind::vectorVoxels, {{"components", std::to_string(header.components)}}});
  header.warnings.push_back(FindingKind::colourAsLuminance);
}

}  // namespace

struct Quiet::Saved {
  std::streambuf* err = std::cerr.rdbuf();
  std::streambuf* out = std::cout.rdbuf();
  std::ostringstream sink;
  bool itkWarnings = itk::Object::GetGlobalWarningDisplay();
};

Quiet::Quiet() : saved_(std::make_unique<Saved>()) {
  std::cerr.rdbuf(saved_->sink.rdbuf());
  std::cout.rdbuf(saved_->sink.rdbuf());
  itk::Object::GlobalWarningDisplayOff();
  gdcm::Trace::DebugOff();
  gdcm::Trace::WarningOff();
  gdcm::Trace::ErrorOff();
}

Quiet::~Quiet() {
  std::cerr.rdbuf(saved_->err);
  std::cout.rdbuf(saved_->out);
  itk::Object::SetGlobalWarningDisplay(saved_->itkWarnings);
}

void withItk(const std::string& path, const Finding& what, const std::function<void()>& f) {
  const auto refuse = [&](const char* description) {
    Finding told = what;
    told.values.emplace_back("reason", oneLine(description));
    refuseInput(path, told);
  };
  try {
    f();
  } catch (const InputError&) {
    throw;
  } catch (const itk::ExceptionObject& e) {
    refuse(e.GetDescription());
  } catch (const std::bad_alloc&) {
    refuseInput(path, FindingKind::notEnoughMemory);
  } catch (const std::exception& e) {
    refuse(e.what());
  }
}

Component itkComponent(const itk::ImageIOBase& io, const std::string& path) {
  using E = itk::IOComponentEnum;
  switch (io.GetComponentType()) {
    case E::UCHAR:
      return Component::uint8;
    case E::CHAR:
      return Component::int8;
    case E::USHORT:
      return Component::uint16;
    case E::SHORT:
      return Component::int16;
    case E::UINT:
      return Component::uint32;
    case E::INT:
      return Component::int32;
    case E::ULONG:
    case E::ULONGLONG:
      return Component::uint64;
    case E::LONG:
    case E::LONGLONG:
      return Component::int64;
    case E::FLOAT:
      return Component::float32;
    case E::DOUBLE:
      return Component::float64;
    default:
      refuseInput(path, FindingKind::voxelTypeUnknown);
  }
}

VolumeHeader readItkHeader(itk::ImageIOBase& io, const std::string& path, const std::string& format,
                           unsigned least) {
  const Quiet quiet;
  VolumeHeader header;
  header.format = format;
  withItk(path, {FindingKind::headerUnreadable, {{"format", format}}}, [&] {
    io.SetFileName(path);
    io.ReadImageInformation();
  });
  const unsigned dimensions = io.GetNumberOfDimensions();
  if (dimensions < least) refuseInput(path, FindingKind::flatImage);
  for (unsigned a = 4; a < dimensions; ++a)
    if (io.GetDimensions(a) > 1)
      refuseInput(path, {FindingKind::tooManyDimensions, {{"dimensions", dimensions}}});
  itk::ImageIORegion region(dimensions);
  for (unsigned a = 0; a < dimensions; ++a) region.SetSize(a, io.GetDimensions(a));
  io.SetIORegion(region);
  header.grid.size = {1, 1, 1};
  for (unsigned a = 0; a < std::min(3U, dimensions); ++a) {
    header.grid.size[a] = sizeOf(io, a, path);
    header.grid.spacing[a] = io.GetSpacing(a);
    header.grid.origin[a] = io.GetOrigin(a);
    const std::vector<double> axis = io.GetDirection(a);
    for (unsigned r = 0; r < std::min(3U, dimensions); ++r) header.grid.direction(r, a) = axis[r];
  }
  if (dimensions > 3) header.frames = sizeOf(io, 3, path);
  readComponents(io, path, header);
  return header;
}

}  // namespace handlebody
