#pragma once
// What is behind a path: read on a worker thread, and complete or not at all.

#include <QString>
#include <QStringList>
#include <atomic>
#include <functional>
#include <mutex>
#include <variant>
#include <vector>

#include "core/finding.h"
#include "core/io/formats/time_axis.h"
#include "core/io/formats/volume_io.h"
#include "core/io/report/session.h"
#include "ui/model/file_stamp.h"

namespace handlebody::ui {

struct OpeningRequest {
  QString path;
  VolumeSelection selection{};  //!< of a session only a series counts: it says the rest itself
  //! Where the files are that the session does not name, in the order in which it was asked for them
  //! (FileNeeded).
  QStringList files{};
};

//! A volume, and the objects of the session that named it if there was one.
struct OpenedWork {
  Volume volume;
  VolumeInfo info;
  VolumeReference reference;      //!< the hash is empty unless a session gave it
  std::vector<Session> sessions;  //!< one per object; empty: it was a volume
  double seconds = 0;             //!< that reading took
  TimeAxis times{};               //!< of a volume with several time points
  bool isAnonymous = false;       //!< the session does not say where its files are
  FileStamp stamp{};              //!< of the file that was opened, before it was read
};

//! A folder of several series of which none was chosen.
struct SeriesChoice {
  std::vector<SeriesInfo> series;
};

//! An anonymous session, one of whose files has to be chosen next.
struct FileNeeded {
  FindingKind missing;  //!< as in UnnamedFile
  QStringList taken{};  //!< of those that were given: they are the session's
  QString refused{};    //!< why the next of those given is not; empty: there was none
};

struct OpeningFailed {
  QString sentence;
  bool needsSpacing = false;  //!< it can be opened with the spacing of its slices
};

using OpeningResult = std::variant<OpenedWork, SeriesChoice, FileNeeded, OpeningFailed>;

//! To be held while a volume is read: the libraries below are not for several threads at once,
//! whichever documents these work for.
std::mutex& readingVolumes();

//! True for the ending of sessions and reports.
bool isSessionPath(const QString& path);

//! Reads a volume, a DICOM folder, or a session or report with its volume. `progress` is called with 0 … 1
//! or, while unknown, -1. Gives up between its steps when `cancelled`; the result means nothing then. Throws
//! nothing.
OpeningResult openWork(const OpeningRequest& asked, const std::function<void(double)>& progress,
                       const std::atomic<bool>& cancelled);

}  // namespace handlebody::ui
