#include "ui/model/opening.h"

#include <QCoreApplication>
#include <chrono>
#include <filesystem>
#include <utility>

#include "core/cancellation.h"
#include "core/errors.h"
#include "core/io/report/start_surface.h"
#include "core/io/report/unnamed_files.h"
#include "core/io/report/voxel_fingerprint.h"
#include "core/io/report/wall_map.h"
#include "core/told_error.h"
#include "ui/model/error_sentence.h"
#include "ui/model/file_name.h"

namespace handlebody::ui {

namespace {

//! As it is to be kept from now on.
void verifyHash(VolumeReference& reference) {
  if (reference.sha256.empty()) return;
  const PathHash hash = hashOfPath(reference.path);
  if (hash.is(reference.sha256)) {
    reference.sha256 = hash.whole;
    return;
  }
  throw Told<InputError>(Finding(FindingKind::volumeChanged, {{"file", reference.path}}));
}

//! When its time points were taken, if it has several; it need not say so.
TimeAxis timesOf(const OpenedWork& work) {
  if (work.info.frames < 2) return {};
  const auto& over = work.sessions.empty() ? std::nullopt : work.sessions.front().overTime;
  if (over && over->frameTime) return evenTimes(work.info.frames, *over->frameTime, "given by the user");
  try {
    return readTimeAxis(work.reference.path, work.reference.selection);
  } catch (const InputError&) {
    return {};
  }
}

//! Names what the sessions do not, as far as `files` go. Returns what is to be asked for next.
std::optional<FileNeeded> nameFiles(std::vector<Session>& sessions, const QStringList& files) {
  QStringList taken;
  while (const auto unnamed = unnamedFile(sessions)) {
    giveUpIfCancelled();
    if (taken.size() == files.size()) return FileNeeded{unnamed->missing, taken};
    try {
      nameFile(sessions, *unnamed, fileName(files[taken.size()]));
    } catch (const InputError&) {
      return FileNeeded{unnamed->missing, taken, errorSentence()};
    }
    taken << files[taken.size()];
  }
  return std::nullopt;
}

//! Returns which file is to be asked for first; none: all are there, and the volume is the session's.
std::optional<FileNeeded> takeSession(const OpeningRequest& asked, OpenedWork& work) {
  InputPaths inputs;
  inputs.mayBeUnnamed = true;
  work.sessions = readSessions(fileName(asked.path), inputs);
  work.isAnonymous = unnamedFile(work.sessions).has_value();
  const bool saysVolume = !work.sessions.front().volume.path.empty();
  if (auto needed = nameFiles(work.sessions, asked.files)) return needed;
  work.reference = work.sessions.front().volume;
  // Relative to the session's folder it may be full of "..", which nobody wants to read.
  work.reference.path = std::filesystem::weakly_canonical(work.reference.path).string();
  if (asked.selection.series) work.reference.selection.series = asked.selection.series;
  if (saysVolume) verifyHash(work.reference);  // the others were looked at when they were named
  return std::nullopt;
}

// The voxels come last: everything that can be wrong cheaply is found before them.
OpeningResult read(const OpeningRequest& asked, const std::function<void(double)>& progress) {
  const auto start = std::chrono::steady_clock::now();
  OpenedWork work;
  work.reference = {fileName(asked.path), {}, asked.selection};
  work.stamp = stampOf(asked.path);
  progress(-1);
  if (isSessionPath(asked.path))
    if (auto needed = takeSession(asked, work)) return *needed;
  giveUpIfCancelled();
  const std::lock_guard lock(readingVolumes());
  findSeries(work.reference);
  LoadedVolume loaded = loadVolume(work.reference.path, work.reference.selection, progress);
  verifyVoxels(work.reference, loaded.volume);
  work.volume = std::move(loaded.volume);
  for (Session& session : work.sessions) loadWalls(session, work.volume.grid);
  std::vector<Session*> all;
  for (Session& session : work.sessions) all.push_back(&session);
  loadStarts(all);
  work.info = std::move(loaded.info);
  work.times = timesOf(work);
  work.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return work;
}

}  // namespace

std::mutex& readingVolumes() {
  static std::mutex mutex;
  return mutex;
}

bool isSessionPath(const QString& path) { return path.endsWith(QLatin1String(".json"), Qt::CaseInsensitive); }

OpeningResult openWork(const OpeningRequest& asked, const std::function<void(double)>& progress,
                       const std::atomic<bool>& cancelled) try {
  const CancelScope scope(cancelled);
  return read(asked, progress);
} catch (const Cancelled&) {
  return OpeningFailed{};
} catch (const SeriesChoiceNeeded& choice) {
  return SeriesChoice{choice.series};
} catch (const InputError& error) {
  const Finding finding = findingOf(error);
  const bool isCine = !finding.causes.empty() && finding.causes.front().kind == FindingKind::cine;
  return OpeningFailed{errorSentence(), isCine};
} catch (...) {
  return OpeningFailed{errorSentence()};
}

}  // namespace handlebody::ui
