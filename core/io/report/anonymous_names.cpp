#include "core/io/report/anonymous_names.h"

#include <cctype>
#include <filesystem>
#include <set>

namespace handlebody {

namespace {

//! Without ".nii.gz" and its like.
std::string baseName(const std::string& path) {
  const std::string name = std::filesystem::path(path).filename().string();
  return name.substr(0, name.find('.', 1));
}

//! A word that only begins alike ("Liver", of a file L.stl) is somebody's own.
bool isNamedAfterFile(const NamedObject& object) {
  const std::string base = baseName(object.file);
  if (base.empty() || object.name.rfind(base, 0) != 0) return false;
  return object.name.size() == base.size() ||
         std::isalnum(static_cast<unsigned char>(object.name[base.size()])) == 0;
}

}  // namespace

std::vector<std::string> anonymousNames(const std::vector<NamedObject>& objects) {
  std::set<std::string> taken;
  for (const NamedObject& object : objects)
    if (!isNamedAfterFile(object)) taken.insert(object.name);
  std::vector<std::string> names;
  for (const NamedObject& object : objects) {
    names.push_back(object.name);
    if (!isNamedAfterFile(object)) continue;
    std::size_t number = names.size();
    do names.back() = "Object " + std::to_string(number++);
    while (!taken.insert(names.back()).second);
  }
  return names;
}

void hideFileNames(std::vector<Session>& objects) {
  std::vector<NamedObject> named;
  for (const Session& object : objects) {
    const auto& start = object.constraints.start;
    named.push_back({object.label.name, start ? start->path : std::string()});
  }
  const std::vector<std::string> names = anonymousNames(named);
  for (std::size_t i = 0; i < names.size(); ++i) objects[i].label.name = names[i];
}

Finding unnamed(Finding warning) {
  switch (warning.kind) {
    case FindingKind::fileNotDicom:
      return FindingKind::fileNotDicomUnnamed;
    case FindingKind::filesNotDicom:
    case FindingKind::filesNotDicomAndMore:
      warning.kind = FindingKind::filesNotDicomUnnamed;
      std::erase_if(warning.values, [](const auto& value) { return value.first == "names"; });
      return warning;
    case FindingKind::stacksAlone:
      return FindingKind::stacksAloneUnnamed;
    default:
      return warning;
  }
}

}  // namespace handlebody
