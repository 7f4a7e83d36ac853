// A plain DICOM series: one file per slice. Tags through GDCM's scanner, the grid from the positions
// (dicom_geometry.h), pixels through ITK slice by slice into the one buffer.

#include <gdcmScanner.h>
#include <itkGDCMImageIO.h>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include "core/errors.h"
#include "core/io/dicom_geometry.h"
#include "core/io/dicom_structure.h"
#include "core/io/itk_source.h"

namespace handlebody {
namespace {

namespace fs = std::filesystem;

const gdcm::Tag kTransferSyntax(0x0002, 0x0010), kModality(0x0008, 0x0060), kDescription(0x0008, 0x103e),
    kSeriesUid(0x0020, 0x000e), kPosition(0x0020, 0x0032), kOrientation(0x0020, 0x0037),
    kSamples(0x0028, 0x0002), kFrames(0x0028, 0x0008), kRows(0x0028, 0x0010), kColumns(0x0028, 0x0011),
    kPixelSpacing(0x0028, 0x0030), kBitsAllocated(0x0028, 0x0100), kBitsStored(0x0028, 0x0101),
    kSign(0x0028, 0x0103), kIntercept(0x0028, 0x1052), kSlope(0x0028, 0x1053);

struct ScannedSlice : DicomSlice {
  std::string uid, description, transferSyntax;
  std::string valueTags;  //!< what the type of the decoded values depends on
  int frames = 1, samples = 1, bits = 16;
  DicomStructure structure{};
};

std::string text(const gdcm::Scanner& scanner, const std::string& file, const gdcm::Tag& tag) {
  const char* value = scanner.GetValue(file.c_str(), tag);
  if (!value) return {};
  std::string s(value);
  while (!s.empty() && (s.back() == ' ' || s.back() == '\0')) s.pop_back();
  return s.substr(std::min(s.size(), s.find_first_not_of(' ')));
}

//! The numbers of a multi-valued field, in the C locale whatever the program's is; nothing unless all n are
//! there.
std::optional<std::vector<double>> numbers(const std::string& s, std::size_t n) {
  std::vector<double> values;
  std::size_t at = 0;
  while (at <= s.size() && values.size() < n) {
    while (at < s.size() && (s[at] == ' ' || s[at] == '+')) ++at;
    double value = 0;
    const auto [end, error] = std::from_chars(s.data() + at, s.data() + s.size(), value);
    if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
    values.push_back(value);
    at = s.find('\\', static_cast<std::size_t>(end - s.data()));
    if (at == std::string::npos) break;
    ++at;
  }
  if (values.size() != n) return std::nullopt;
  return values;
}

int integer(const std::string& s, int otherwise) {
  const auto value = numbers(s, 1);
  return value && std::abs((*value)[0]) < 1e9 ? static_cast<int>((*value)[0]) : otherwise;
}

ScannedSlice scannedSlice(const gdcm::Scanner& scanner, const std::string& file) {
  const auto get = [&](const gdcm::Tag& tag) { return text(scanner, file, tag); };
  ScannedSlice s;
  s.file = file;
  s.uid = get(kSeriesUid);
  s.description = get(kModality);
  const std::string words = get(kDescription);
  if (!words.empty()) s.description += (s.description.empty() ? "" : " ") + words;
  s.transferSyntax = get(kTransferSyntax);
  s.rows = integer(get(kRows), 0);
  s.columns = integer(get(kColumns), 0);
  s.frames = integer(get(kFrames), 1);
  s.samples = integer(get(kSamples), 1);
  s.bits = integer(get(kBitsAllocated), 16);
  for (const gdcm::Tag& tag : {kBitsAllocated, kBitsStored, kSign, kIntercept, kSlope, kSamples})
    s.valueTags += get(tag) + "|";
  if (const auto p = numbers(get(kPosition), 3)) s.position = Vec3((*p)[0], (*p)[1], (*p)[2]);
  if (const auto o = numbers(get(kOrientation), 6)) {
    s.rowDirection = Vec3((*o)[0], (*o)[1], (*o)[2]);
    s.columnDirection = Vec3((*o)[3], (*o)[4], (*o)[5]);
  }
  // The field gives the distance between rows first.
  if (const auto p = numbers(get(kPixelSpacing), 2)) s.pixelSpacing = Vec3((*p)[1], (*p)[0], 0);
  return s;
}

bool hasPreamble(const fs::path& file) {
  char start[132] = {};
  std::ifstream stream(file, std::ios::binary);
  return stream.read(start, sizeof start) && std::memcmp(start + 128, "DICM", 4) == 0;
}

//! A cheap look before anything parses: the file has the preamble, or begins with a tag of group 2 or 8.
bool isCandidate(const fs::path& file) {
  unsigned char start[8] = {};
  std::ifstream stream(file, std::ios::binary);
  stream.read(reinterpret_cast<char*>(start), sizeof start);
  if (stream.gcount() < 8) return false;
  return ((start[0] == 2 || start[0] == 8) && start[1] == 0 && start[3] == 0) || hasPreamble(file);
}

std::vector<std::string> candidates(const std::string& path) {
  std::vector<std::string> files;
  if (!fs::is_directory(path)) return {path};
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(path, failed))
    if (entry.is_regular_file() && isCandidate(entry.path())) files.push_back(entry.path().string());
  if (failed) refuseInput(path, "the folder cannot be read (" + failed.message() + ")");
  std::sort(files.begin(), files.end());
  if (files.empty()) refuseInput(path, "the folder holds no DICOM images");
  return files;
}

//! Drops what only looked like DICOM; a broken DICOM file refuses the folder, it may be a slice of the
//! series.
std::map<std::string, DicomStructure> walkAll(const std::string& path, std::vector<std::string>& files) {
  std::map<std::string, DicomStructure> structures;
  for (const std::string& file : files) {
    const DicomStructure structure = walkDicom(file);
    if (structure.whole)
      structures[file] = structure;
    else if (file == path)
      refuseInput(path, "the DICOM file is truncated or damaged");
    else if (hasPreamble(file))
      refuseInput(path, "the file " + file + " is truncated or damaged");
  }
  std::erase_if(files, [&](const std::string& file) { return structures.count(file) == 0; });
  return structures;
}

struct Scan {
  std::vector<ScannedSlice> slices{};
  std::vector<ScannedSlice> others{};  //!< DICOM files without an image: reports, structures, cut off slices
};

//! A file without an image that names the series of images is one of them, cut off between two elements.
void checkOthers(const Scan& scanned, const std::string& path) {
  for (const ScannedSlice& other : scanned.others)
    for (const ScannedSlice& s : scanned.slices)
      if (!other.uid.empty() && other.uid == s.uid)
        refuseInput(path, "the file " + other.file + " is truncated (a slice without an image)");
}

Scan scan(const std::string& path) {
  const Quiet quiet;
  std::vector<std::string> files = candidates(path);
  const auto structures = walkAll(path, files);
  Scan scanned;
  withItk(path, "its DICOM header cannot be read", [&] {
    gdcm::Scanner scanner;
    for (const gdcm::Tag& tag :
         {kTransferSyntax, kModality, kDescription, kSeriesUid, kPosition, kOrientation, kSamples, kFrames,
          kRows, kColumns, kPixelSpacing, kBitsAllocated, kBitsStored, kSign, kIntercept, kSlope})
      scanner.AddTag(tag);
    scanner.Scan(files);
    for (const std::string& file : files) {
      if (!scanner.IsKey(file.c_str())) continue;
      ScannedSlice slice = scannedSlice(scanner, file);
      slice.structure = structures.at(file);
      const bool image = slice.rows > 0 && slice.columns > 0;
      (image ? scanned.slices : scanned.others).push_back(std::move(slice));
    }
  });
  if (scanned.slices.empty())
    refuseInput(path, fs::is_directory(path) ? "the folder holds no DICOM images"
                                             : "it is not a DICOM image (no rows and columns)");
  checkOthers(scanned, path);
  return scanned;
}

std::vector<SeriesInfo> listSeries(const std::vector<ScannedSlice>& slices) {
  std::map<std::string, SeriesInfo> found;
  for (const ScannedSlice& s : slices) {
    auto [entry, fresh] = found.try_emplace(s.uid, SeriesInfo{s.uid, s.description, 0});
    ++entry->second.files;
  }
  std::vector<SeriesInfo> list;
  for (auto& [uid, info] : found) list.push_back(info);
  return list;
}

void checkSlices(const std::vector<ScannedSlice>& slices, const std::string& path) {
  static const std::set<std::string> kUncompressed{"", "1.2.840.10008.1.2", "1.2.840.10008.1.2.1",
                                                   "1.2.840.10008.1.2.2"};
  for (const ScannedSlice& s : slices) {
    if (s.frames > 1)
      refuseInput(path, "this is a multi-frame DICOM file (" + std::to_string(s.frames) +
                            " frames), which is not supported yet");
    if (s.samples != 1) refuseInput(path, "colour DICOM images are not supported");
    const auto bytes = static_cast<std::uint64_t>(s.rows) * static_cast<std::uint64_t>(s.columns) *
                       static_cast<std::uint64_t>(s.samples) *
                       static_cast<std::uint64_t>(std::max(1, s.bits)) / 8;
    if (kUncompressed.count(s.transferSyntax) == 0) continue;
    checkDataSize(path, s.file, 0, bytes, false);
    if (s.structure.walked && s.structure.pixelBytes < bytes)
      refuseInput(path, "the slice " + s.file + " holds less pixels than its header says");
  }
}

class DicomSource : public VolumeSource {
 public:
  DicomSource(std::string path, const std::vector<ScannedSlice>& slices);
  void readFrame(int frame, void* to) override;

 private:
  Component typeOf(const std::string& file, itk::GDCMImageIO& io) const;
  void readSlice(const DicomSlice& slice, char* to) const;
  std::string path_;
  std::vector<DicomSlice> slices_;
};

//! float32 holds the values of up to 16 bits exactly.
Component widened(Component a, Component b) {
  if (a == b) return a;
  const auto small = [](Component c) { return bytesOf(c) <= 2 || c == Component::float32; };
  return small(a) && small(b) ? Component::float32 : Component::float64;
}

Component DicomSource::typeOf(const std::string& file, itk::GDCMImageIO& io) const {
  Component type{};
  withItk(path_, "the slice " + file + " cannot be read", [&] {
    io.SetFileName(file);
    io.ReadImageInformation();
    if (io.GetNumberOfComponents() != 1) refuseInput(path_, "colour DICOM images are not supported");
    type = itkComponent(io, path_);
  });
  return type;
}

DicomSource::DicomSource(std::string path, const std::vector<ScannedSlice>& slices)
    : path_(std::move(path)), slices_(slices.begin(), slices.end()) {
  header_.format = "DICOM";
  header_.grid = stackSlices(slices_, path_);
  const Quiet quiet;
  auto io = itk::GDCMImageIO::New();
  std::set<std::string> seen;
  for (const ScannedSlice& s : slices)
    if (seen.insert(s.valueTags).second) {
      const Component type = typeOf(s.file, *io);
      header_.component = seen.size() == 1 ? type : widened(header_.component, type);
    }
  checkHeader(header_, path_);
}

template <typename From, typename To>
void convert(const void* from, std::size_t n, void* to) {
  std::transform(static_cast<const From*>(from), static_cast<const From*>(from) + n, static_cast<To*>(to),
                 [](From v) { return static_cast<To>(v); });
}

template <typename To>
void convertTo(Component type, const void* from, std::size_t n, void* to) {
  switch (type) {
    case Component::uint8:
      return convert<std::uint8_t, To>(from, n, to);
    case Component::int8:
      return convert<std::int8_t, To>(from, n, to);
    case Component::uint16:
      return convert<std::uint16_t, To>(from, n, to);
    case Component::int16:
      return convert<std::int16_t, To>(from, n, to);
    case Component::uint32:
      return convert<std::uint32_t, To>(from, n, to);
    case Component::int32:
      return convert<std::int32_t, To>(from, n, to);
    case Component::float32:
      return convert<float, To>(from, n, to);
    case Component::float64:
      return convert<double, To>(from, n, to);
    case Component::int64:
      return convert<std::int64_t, To>(from, n, to);
    case Component::uint64:
      return convert<std::uint64_t, To>(from, n, to);
  }
}

void DicomSource::readSlice(const DicomSlice& slice, char* to) const {
  auto io = itk::GDCMImageIO::New();
  const Component type = typeOf(slice.file, *io);
  const auto columns = static_cast<std::uint64_t>(slice.columns),
             rows = static_cast<std::uint64_t>(slice.rows);
  // The scanner and the decoder must mean the same image, or the decoder would write past our slice.
  std::uint64_t pixels = 1;
  for (unsigned a = 0; a < io->GetNumberOfDimensions(); ++a) pixels *= io->GetDimensions(a);
  if (io->GetDimensions(0) != columns || io->GetDimensions(1) != rows || pixels != columns * rows)
    refuseInput(path_, "the slice " + slice.file + " has another size than its header says");
  itk::ImageIORegion region(io->GetNumberOfDimensions());
  for (unsigned a = 0; a < io->GetNumberOfDimensions(); ++a) region.SetSize(a, io->GetDimensions(a));
  io->SetIORegion(region);
  std::vector<char> own(type == header_.component ? 0 : static_cast<std::size_t>(pixels) * bytesOf(type));
  withItk(path_, "the slice " + slice.file + " is truncated or damaged",
          [&] { io->Read(own.empty() ? to : own.data()); });
  if (own.empty()) return;
  if (header_.component == Component::float32)
    convertTo<float>(type, own.data(), static_cast<std::size_t>(pixels), to);
  else
    convertTo<double>(type, own.data(), static_cast<std::size_t>(pixels), to);
}

void DicomSource::readFrame(int, void* to) {
  const Quiet quiet;
  const std::size_t bytes = static_cast<std::size_t>(header_.bytesPerFrame()) / slices_.size();
  for (std::size_t i = 0; i < slices_.size(); ++i) readSlice(slices_[i], static_cast<char*>(to) + i * bytes);
}

//! Only the header: which series there are.
class SeriesList : public VolumeSource {
 public:
  explicit SeriesList(std::vector<SeriesInfo> series) {
    header_.format = "DICOM";
    header_.series = std::move(series);
  }
  void readFrame(int, void*) override {}
};

}  // namespace

SourcePointer openDicom(const std::string& path, const VolumeSelection& selection, bool* several) {
  Scan scanned = scan(path);
  std::vector<ScannedSlice>& slices = scanned.slices;
  const std::vector<SeriesInfo> series = listSeries(slices);
  if (selection.series) {
    std::erase_if(slices, [&](const ScannedSlice& s) { return s.uid != *selection.series; });
    if (slices.empty()) throw UsageError(path + ": it holds no series " + *selection.series + ".");
  } else if (series.size() > 1) {
    *several = true;
    return std::make_unique<SeriesList>(series);
  }
  checkSlices(slices, path);
  auto source = std::make_unique<DicomSource>(path, slices);
  source->header().series = series;
  if (!scanned.others.empty())
    source->header().warnings.push_back(std::to_string(scanned.others.size()) +
                                        " DICOM files in the folder hold no image and were left out.");
  return source;
}

}  // namespace handlebody
