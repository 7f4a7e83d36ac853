#pragma once
// The surfaces of the objects as they stand in files and reports: certified, and polished where that is
// wanted, as the command line does it.

#include <functional>
#include <optional>

#include "core/io/report/over_time_report.h"
#include "core/io/report/polished_export.h"
#include "core/io/report/result.h"
#include "ui/model/finished_mesh.h"

namespace handlebody::ui {

//! An object whose surface is written, or that lies beside one that is.
struct WrittenObject {
  ObjectLabel label{};
  std::string nameInFiles{};  //!< the label's, if that does not name the patient where nothing is to
  std::shared_ptr<const FinishedMesh> surface{};
  WallList walls{};  //!< of its growth, the objects before it among them
  bool isWanted = true;
  bool isAsItIs = false;  //!< is not polished: a mesh that was opened as done
};

struct WrittenMesh {
  CertifiedMesh made{};
  std::optional<PolishReport> polish{};  //!< none: that was not wanted
};

//! All objects that have a surface, in their order: a polished one keeps clear of all others as they are by
//! then. Those behind the last that is wanted stay as they are. `polishing` gets the name of each before its
//! turn. Takes long: not on the GUI thread. Throws Cancelled (cancellation.h).
std::vector<WrittenMesh> writtenMeshes(const std::vector<WrittenObject>& objects, const Grid& grid,
                                       bool polishes,
                                       const std::function<void(const std::string&)>& polishing = {});

//! The guarantee of several objects in one file: throws OutputError if two that are wanted meet.
void requireApart(const std::vector<WrittenObject>& objects, const std::vector<WrittenMesh>& meshes);

//! What polishing did, as a sentence; empty: nothing was bad.
QString polishSentence(const PolishReport& report);
//! What it did, for those that are wanted and had something bad, one sentence each; empty: nothing.
QString polishTexts(const std::vector<WrittenObject>& objects, const std::vector<WrittenMesh>& meshes);
//! What label maps leave out of those that are wanted; empty: nothing, or none of the paths is one.
QString leftOutTexts(const std::vector<WrittenObject>& objects, const std::vector<WrittenMesh>& meshes,
                     const ExportContext& context, const QStringList& paths);
//! The same of the frames of a 4D label map, those of one sentence together.
QString leftOutTexts(const OverTimeReport& over, const Grid& grid, const QString& path);

}  // namespace handlebody::ui
