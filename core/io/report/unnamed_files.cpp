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

//! f(file) of the files of a kind, wherever in the sessions they stand.
template <typename F>
void forEachFile(std::vector<Session>& sessions, K missing, F&& f) {
  for (Session& s : sessions) {
    if (missing == K::sessionWithoutVolume) f(s.volume);
    if (missing == K::sessionWithoutWalls) forEachWallMap(s, f);
    if (missing == K::sessionWithoutStart) forEachStart(s, f);
  }
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
  const PathHash hash = hashOfPath(path);
  if (!file.sha256.empty() && !hash.is(file.sha256))
    throw Told<InputError>(Finding(refusalOf(file.missing), {{"file", path}}));
  forEachFile(sessions, file.missing, [&](auto& unnamed) {
    if (unnamed.path.empty() && unnamed.sha256 == file.sha256) {
      unnamed.path = path;
      if (!file.sha256.empty()) unnamed.sha256 = hash.whole;
    }
  });
}

void placeFiles(std::vector<Session>& sessions, FindingKind missing, const std::vector<std::string>& paths) {
  if (paths.empty()) return;
  bool anyFile = false;
  forEachFile(sessions, missing, [&](const auto&) { anyFile = true; });
  if (!anyFile)
    throw Told<InputError>(Finding(missing == K::sessionWithoutWalls ? K::wallsNotNeeded : K::startNotNeeded,
                                   {{"file", paths.front()}}));
  std::vector<std::string> left;
  for (const std::string& path : paths) {
    const PathHash hash = hashOfPath(path);
    bool isMeant = false;
    forEachFile(sessions, missing, [&](auto& file) {
      if (!hash.is(file.sha256)) return;
      file.path = path;
      file.sha256 = hash.whole;
      isMeant = true;
    });
    if (!isMeant) left.push_back(path);
  }
  if (left.empty()) return;
  bool anyUnknown = false;
  forEachFile(sessions, missing, [&](auto& file) {
    if (!file.sha256.empty()) return;
    file.path = left.front();
    anyUnknown = true;
  });
  if (!anyUnknown) throw Told<InputError>(Finding(refusalOf(missing), {{"file", left.front()}}));
  if (left.size() > 1)
    throw Told<InputError>(Finding(K::onlyOneFile, {{"file", left[1]}, {"other", left[0]}}));
}

}  // namespace handlebody
