#include "core/io/dicom/dicom_scan.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "core/io/dicom/dicom_echo.h"
#include "core/io/formats/itk_guard.h"
#include "core/io/formats/volume_source.h"
#include "core/io/lowered.h"

namespace handlebody {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kPreamble = 132;

enum class Kind { dicom, cut, foreign };

//! A cheap look before anything parses: DICOM has a preamble and "DICM", or begins with a tag of group 2
//! or 8. What is shorter than a preamble and empty, all zero or named like DICOM is a file cut off within it.
Kind kindOf(const fs::path& file) {
  char start[kPreamble] = {};
  std::ifstream stream(file, std::ios::binary);
  stream.read(start, sizeof start);
  const auto got = static_cast<std::size_t>(stream.gcount());
  if (got == kPreamble && std::memcmp(start + 128, "DICM", 4) == 0) return Kind::dicom;
  if (got >= 8 && (start[0] == 2 || start[0] == 8) && start[1] == 0 && start[3] == 0) return Kind::dicom;
  if (got >= kPreamble) return Kind::foreign;
  const std::string ending = lowered(file.extension().string());
  const bool zero =
      std::all_of(start, start + std::min<std::size_t>(got, 128), [](char c) { return c == 0; });
  return zero || ending == ".dcm" || ending == ".ima" ? Kind::cut : Kind::foreign;
}

//! The files of the folder that may be DICOM, by name.
std::vector<std::string> candidates(const std::string& path, DicomScan& scan) {
  if (!fs::is_directory(path)) return {path};
  std::vector<std::string> files;
  std::error_code failed;
  for (fs::directory_iterator entry(path, failed), end; !failed && entry != end; entry.increment(failed)) {
    std::error_code ignored;
    if (!entry->is_regular_file(ignored)) continue;
    const Kind kind = kindOf(entry->path());
    if (kind == Kind::cut) refuseInput(path, {FindingKind::partCutOff, {{"part", entry->path().string()}}});
    if (kind == Kind::dicom)
      files.push_back(entry->path().string());
    else
      scan.foreign.push_back(entry->path().filename().string());
  }
  if (failed) refuseInput(path, {FindingKind::folderUnreadableFor, {{"reason", failed.message()}}});
  std::sort(files.begin(), files.end());
  std::sort(scan.foreign.begin(), scan.foreign.end());
  return files;
}

bool hasFolders(const std::string& path) {
  std::error_code failed;
  for (fs::directory_iterator entry(path, failed), end; !failed && entry != end; entry.increment(failed)) {
    std::error_code ignored;
    if (entry->is_directory(ignored)) return true;
  }
  return false;
}

bool hasPreamble(const std::string& file) {
  char start[kPreamble] = {};
  std::ifstream stream(file, std::ios::binary);
  return stream.read(start, sizeof start) && std::memcmp(start + 128, "DICM", 4) == 0;
}

//! A file that is not whole: of a folder, it may be a slice of the series.
void addDamaged(const std::string& path, const std::string& file, const DicomStructure& structure,
                DicomScan& scan) {
  if (file == path) refuseInput(path, FindingKind::dicomDamaged);
  if (!structure.seriesUid.empty()) {
    scan.damaged.push_back(file);
    scan.damagedSeries.push_back(structure.seriesUid);
  } else if (hasPreamble(file)) {
    refuseInput(path, {FindingKind::partDamaged, {{"part", file}}});
  } else {
    scan.foreign.push_back(fs::path(file).filename().string());
  }
}

void addFile(const std::string& path, const std::string& file, const DicomStructure& structure,
             DicomScan& scan) {
  const bool isCut = !structure.whole;  // …within the pixels: what stands before them can be read
  if (isCut && structure.pixelOffset == 0) return addDamaged(path, file, structure, scan);
  std::optional<DicomFile> read;
  withItk(path, {FindingKind::partHeaderUnreadable, {{"part", file}}},
          [&] { read = readDicomFile(file, path); });
  if (!read) return addDamaged(path, file, structure, scan);
  read->structure = structure;
  if (!keepWholeVolumes(*read) && isCut) return addDamaged(path, file, structure, scan);
  if (read->isImage())
    scan.images.push_back(std::move(*read));
  else
    scan.others.push_back(std::move(*read));
}

}  // namespace

DicomScan scanDicom(const std::string& path, const DecodingProgress& progress) {
  const Quiet quiet;
  DicomScan scan;
  const std::vector<std::string> files = candidates(path, scan);
  for (std::size_t i = 0; i < files.size(); ++i) {
    std::error_code ignored;
    progress(static_cast<double>(i) / static_cast<double>(files.size()), files[i],
             fs::file_size(files[i], ignored));
    addFile(path, files[i], walkDicom(files[i]), scan);
  }
  if (!scan.images.empty()) return scan;
  if (!scan.damaged.empty()) refuseInput(path, {FindingKind::partDamaged, {{"part", scan.damaged.front()}}});
  if (!fs::is_directory(path)) refuseInput(path, FindingKind::notDicomImage);
  refuseInput(path, hasFolders(path) ? FindingKind::imagesInSubfolders : FindingKind::noDicomImages);
}

}  // namespace handlebody
