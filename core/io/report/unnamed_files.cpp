#include "core/io/report/unnamed_files.h"

#include "core/io/report/session_files.h"
#include "core/told_error.h"

namespace handlebody {

namespace {

using K = FindingKind;

K refusalOf(K missing) {
  if (missing == K::sessionWithoutVolume) return K::volumeChanged;
  return missing == K::sessionWithoutWalls ? K::wallsChanged : K::startChanged;
}

}  // namespace

std::optional<UnnamedFile> unnamedFile(const std::vector<Session>& sessions) {
  std::optional<UnnamedFile> first;
  const auto look = [&](K missing, const auto& file) {
    if (!first && file.path.empty()) first = {missing, file.sha256};
  };
  for (const Session& s : sessions) look(K::sessionWithoutVolume, s.volume);
  for (const Session& s : sessions)
    forEachWallMap(s, [&](const WallMap& map) { look(K::sessionWithoutWalls, map); });
  for (const Session& s : sessions)
    forEachStart(s, [&](const StartSurface& start) { look(K::sessionWithoutStart, start); });
  return first;
}

void nameFile(std::vector<Session>& sessions, const UnnamedFile& file, const std::string& path) {
  // Read even where any file is taken: one that cannot be is told now.
  if (const std::string hash = sha256OfPath(path); !file.sha256.empty() && hash != file.sha256)
    throw Told<InputError>(Finding(refusalOf(file.missing), {{"file", path}}));
  const auto name = [&](K missing, auto& unnamed) {
    if (missing == file.missing && unnamed.path.empty() && unnamed.sha256 == file.sha256) unnamed.path = path;
  };
  for (Session& s : sessions) {
    name(K::sessionWithoutVolume, s.volume);
    forEachWallMap(s, [&](WallMap& map) { name(K::sessionWithoutWalls, map); });
    forEachStart(s, [&](StartSurface& start) { name(K::sessionWithoutStart, start); });
  }
}

}  // namespace handlebody
