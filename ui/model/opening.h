#pragma once
// What is behind a path: read on a worker thread, and complete or not at all.

#include <QString>
#include <atomic>
#include <functional>
#include <mutex>
#include <variant>
#include <vector>

#include "core/io/formats/time_axis.h"
#include "core/io/formats/volume_io.h"
#include "core/io/report/session.h"

namespace handlebody::ui {

//! A volume, and the objects of the session that named it if there was one.
struct OpenedWork {
  Volume volume;
  VolumeInfo info;
  VolumeReference reference;      //!< the hash is empty unless a session gave it
  std::vector<Session> sessions;  //!< one per object; empty: it was a volume
  double seconds = 0;             //!< that reading took
  TimeAxis times{};               //!< of a volume with several time points
};

//! A folder of several series of which none was chosen.
struct SeriesChoice {
  std::vector<SeriesInfo> series;
};

struct OpeningFailed {
  QString sentence;
  bool needsSpacing = false;  //!< it can be opened with the spacing of its slices
};

using OpeningResult = std::variant<OpenedWork, SeriesChoice, OpeningFailed>;

//! To be held while a volume is read: the libraries below are not for several threads at once,
//! whichever documents these work for.
std::mutex& readingVolumes();

//! True for the ending of sessions and reports.
bool isSessionPath(const QString& path);

//! Reads a volume, a DICOM folder, or a session or report with its volume. `progress` is called with 0 … 1
//! or, while unknown, -1. Gives up between its steps when `cancelled`; the result means nothing then. Throws
//! nothing.
OpeningResult openWork(const QString& path, const VolumeSelection& selection,
                       const std::function<void(double)>& progress, const std::atomic<bool>& cancelled);

}  // namespace handlebody::ui
