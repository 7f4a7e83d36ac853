#include "core/io/formats/volume_files.h"

#include <algorithm>
#include <exception>
#include <filesystem>

#include "core/io/formats/meta_text.h"
#include "core/io/formats/nrrd_header.h"
#include "core/io/lowered.h"

namespace handlebody {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> dataFilesOf(const std::string& path) {
  const std::string lower = lowered(path);
  if (lower.ends_with(".nhdr") || lower.ends_with(".nrrd")) return readNrrdFields(path).dataFiles;
  if (lower.ends_with(".mhd") || lower.ends_with(".mha"))
    if (const std::string data = metaDataFile(path); !data.empty()) return {data};
  for (const std::string ending : {".hdr", ".img", ".img.gz", ".hdr.gz"}) {
    if (!lower.ends_with(ending)) continue;
    const std::string stem = path.substr(0, path.size() - ending.size());
    return {stem + ".hdr", stem + ".hdr.gz", stem + ".img", stem + ".img.gz"};
  }
  return {};
}

fs::path identity(const std::string& path) {
  std::error_code failed;
  const fs::path whole = fs::weakly_canonical(fs::absolute(path, failed), failed);
  return failed ? fs::path(path) : whole;
}

}  // namespace

std::vector<std::string> filesOfVolume(const std::string& path) {
  std::vector<std::string> files{path};
  try {
    for (const std::string& file : dataFilesOf(path))
      if (identity(file) != identity(path)) files.push_back(file);
  } catch (const std::exception&) {  // opening it will say why
  }
  return files;
}

bool belongsToVolume(const std::string& file, const std::string& path) {
  const fs::path written = identity(file);
  std::error_code failed;
  if (fs::is_directory(path, failed)) return written.parent_path() == identity(path);
  const std::vector<std::string> files = filesOfVolume(path);
  return std::any_of(files.begin(), files.end(),
                     [&](const std::string& f) { return identity(f) == written; });
}

}  // namespace handlebody
