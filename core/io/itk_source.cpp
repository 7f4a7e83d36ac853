#include "core/io/itk_source.h"

#include <gdcmTrace.h>
#include <itkNrrdImageIO.h>
#include <itkObject.h>
#include <itkTIFFImageIO.h>

#include <cstring>
#include <filesystem>
#include <fstream>
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
    refuseInput(path, "a size in its header is implausible (" + std::to_string(n) + ")");
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
    refuseInput(path, "its voxels have " + std::to_string(header.components) +
                          " components (vectors); only scalar and colour volumes are supported");
  header.warnings.push_back("Colour was turned into luminance (0.2125 R + 0.7154 G + 0.0721 B).");
}

//! NRRD and TIFF: ITK reads them straight into our buffer.
class ItkSource : public VolumeSource {
 public:
  ItkSource(itk::ImageIOBase::Pointer io, std::string path, const std::string& format)
      : io_(std::move(io)), path_(std::move(path)) {
    header_ = readItkHeader(*io_, path_, format);
  }
  void readFrame(int frame, void* to, const ReadControl& control) override {
    report(control, 0);
    const Quiet quiet;
    const std::size_t bytes = static_cast<std::size_t>(header_.bytesPerFrame());
    std::unique_ptr<char[]> all;
    if (header_.frames > 1) all.reset(new char[bytes * static_cast<std::size_t>(header_.frames)]);
    withItk(path_, "it is truncated or damaged", [&] { io_->Read(all ? all.get() : to); });
    if (all) std::memcpy(to, all.get() + bytes * static_cast<std::size_t>(frame), bytes);
  }

 private:
  itk::ImageIOBase::Pointer io_;
  std::string path_;
};

struct NrrdText {
  std::string encoding, space, units;
  bool directions = false, detached = false, sequence = false;
  std::uint64_t dataOffset = 0;
};

NrrdText readNrrdText(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  NrrdText text;
  std::string line;
  while (std::getline(file, line)) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.empty()) break;
    text.sequence |= isLaterFrame(line);
    const auto colon = line.find(": ");
    if (colon == std::string::npos) continue;
    const std::string key = line.substr(0, colon), value = line.substr(colon + 2);
    if (key == "encoding") text.encoding = value;
    if (key == "space") text.space = value;
    if (key == "space units") text.units = value;
    text.directions |= key == "space directions";
    text.detached |= key == "data file" || key == "datafile";
  }
  if (file) text.dataOffset = static_cast<std::uint64_t>(file.tellg());
  return text;
}

bool onlyMillimetres(const std::string& units) {
  std::istringstream words(units);
  std::string word;
  while (words >> word)
    if (word != "\"mm\"" && word != "\"\"" && word != "???") return false;
  return true;
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

void withItk(const std::string& path, const std::string& what, const std::function<void()>& f) {
  try {
    f();
  } catch (const InputError&) {
    throw;
  } catch (const itk::ExceptionObject& e) {
    refuseInput(path, what + " (" + oneLine(e.GetDescription()) + ")");
  } catch (const std::bad_alloc&) {
    refuseInput(path, "there is not enough memory to read it");
  } catch (const std::exception& e) {
    refuseInput(path, what + " (" + oneLine(e.what()) + ")");
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
      refuseInput(path, "its voxel type is not supported");
  }
}

VolumeHeader readItkHeader(itk::ImageIOBase& io, const std::string& path, const std::string& format) {
  const Quiet quiet;
  VolumeHeader header;
  header.format = format;
  withItk(path, "its " + format + " header cannot be read", [&] {
    io.SetFileName(path);
    io.ReadImageInformation();
  });
  const unsigned dimensions = io.GetNumberOfDimensions();
  if (dimensions < 3) refuseInput(path, "this is a 2D image, a volume is needed");
  for (unsigned a = 4; a < dimensions; ++a)
    if (io.GetDimensions(a) > 1)
      refuseInput(path, "it has " + std::to_string(dimensions) + " dimensions; at most four are supported");
  itk::ImageIORegion region(dimensions);
  for (unsigned a = 0; a < dimensions; ++a) region.SetSize(a, io.GetDimensions(a));
  io.SetIORegion(region);
  for (unsigned a = 0; a < 3; ++a) {
    header.grid.size[a] = sizeOf(io, a, path);
    header.grid.spacing[a] = io.GetSpacing(a);
    header.grid.origin[a] = io.GetOrigin(a);
    const std::vector<double> axis = io.GetDirection(a);
    for (unsigned r = 0; r < 3; ++r) header.grid.direction(r, a) = axis[r];
  }
  if (dimensions > 3) header.frames = sizeOf(io, 3, path);
  readComponents(io, path, header);
  return header;
}

SourcePointer openNrrd(const std::string& path) {
  const NrrdText text = readNrrdText(path);
  if (text.sequence)
    refuseInput(path,
                "this is a sequence of tracked 2D frames, not a volume; reconstruct a volume from it first");
  auto source = std::make_unique<ItkSource>(itk::NrrdImageIO::New().GetPointer(), path, "NRRD");
  VolumeHeader& header = source->header();
  checkHeader(header, path);
  const std::uint64_t bytes = header.bytesPerFrame() * static_cast<std::uint64_t>(header.frames);
  const bool compressed = text.encoding == "gzip" || text.encoding == "gz";
  if (!text.detached && (text.encoding == "raw" || compressed))
    checkDataSize(path, path, text.dataOffset, bytes, compressed);
  if (text.space.empty() || !text.directions)
    header.warnings.push_back(
        "The header does not say how the volume lies in space; its axes are taken as LPS.");
  if (!onlyMillimetres(text.units))
    header.warnings.push_back("The space units " + text.units + " are taken as millimetres.");
  return source;
}

SourcePointer openTiff(const std::string& path) {
  auto source = std::make_unique<ItkSource>(itk::TIFFImageIO::New().GetPointer(), path, "TIFF");
  checkHeader(source->header(), path);
  source->header().warnings.push_back(
      "TIFF does not say how far apart the slices are nor how they lie; 1 mm and LPS axes are assumed.");
  return source;
}

}  // namespace handlebody
