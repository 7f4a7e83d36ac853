#pragma once
// Sessions: what is needed to make the same mesh again. A JSON file whose keys are a subset of the report's,
// so that a report can be read as a session.

#include <string>
#include <vector>

#include "core/evolution/parameters.h"
#include "core/io/formats/volume_io.h"
#include "core/io/meshes/exported_object.h"
#include "core/io/meshes/mesh_io.h"
#include "core/io/report/over_time_request.h"
#include "core/measure/measurement.h"

namespace handlebody {

//! Where the voxels came from, and how to know them again.
struct VolumeReference {
  std::string path;    //!< file or folder
  std::string sha256;  //!< as sha256OfPath
  VolumeSelection selection{};
  //! sha256OfVoxels where an anonymous session is to know its series again (voxel_fingerprint.h); empty: not
  //! known.
  std::string voxels{};
};

struct Session {
  std::string version;        //!< of the program that wrote it
  VolumeReference volume;     //!< in memory, the path is as the caller would open it
  std::vector<Seed> seeds;    //!< as asked for at the beginning, mm LPS
  Parameters requested;       //!< the same
  Constraints constraints{};  //!< the same; readSession reads no files (loadWalls, loadStarts)
  std::optional<ResolvedParameters> resolved{};  //!< as used, for the record; not read back
  CoordinateSpace space = CoordinateSpace::lps;  //!< of the mesh files
  ObjectLabel label{};                           //!< of the object, where it is written
  //! Bad triangles are bettered before it is written (core/polish); sessions of before there was that say no.
  bool polish = false;
  //! Other parameters, and other clicks, from some iteration on, in ascending order.
  std::vector<ParameterChange> changes{};
  //! The iteration whose mesh is meant; none: the one at which the growth ends by itself.
  std::optional<int> stopAt{};
  //! The other frames of a 4D volume that the surface is carried through; none: it stays in its own.
  std::optional<OverTimeRequest> overTime{};
  std::string view{};  //!< JSON text that a window keeps here for itself; empty: none
  //! Rulers and angles, of all objects together: those of the first one count.
  std::vector<Measurement> measurements{};
};

//! Writes the session, whole or not at all. The volume's path is stored relative to the session file when one
//! leads to the other, so that a folder with both can be moved. A hash that is not known (empty) is written
//! as null, and such a session is read back without one. Throws OutputError.
void writeSession(const Session& session, const std::string& path);

//! The same for several objects of one volume, in the order in which they are grown (a single one is written
//! as such): "objects" holds what of a session belongs to one; what a window keeps is the first one's. One
//! without a seed inside is not grown yet. Precondition: there is one at least; all have the first one's
//! volume and space.
void writeSessions(const std::vector<Session>& objects, const std::string& path);

//! True if one of its clicks is inside of the object, or it begins with a surface: else there is nothing to
//! grow from.
bool isSeeded(const Session& session);

//! The files that a session reads (volume, label maps of walls, surfaces to begin with): no output may be one
//! of them, or belong to one (belongsToVolume).
std::vector<std::string> inputsOf(const Session& session);

//! Without what may name the patient: the paths of the volume, of the label map of walls and of the surface
//! to begin with, the series, what a window keeps, and what may name a site (withoutSite). Such a session
//! says null for the paths, and keeps the voxels where a series was chosen.
Session anonymous(Session session);

//! Where the files that a session names are now; empty: where it says.
struct InputPaths {
  std::string volume{};
  //! The label maps of its walls, and the meshes or label maps that it begins with. Each is known by its
  //! SHA-256; where the session keeps none, it is the only one that nothing else is.
  std::vector<std::string> walls{}, starts{};
  //! What neither these nor the session say stays empty, to be asked for (unnamed_files.h), and is no error.
  bool mayBeUnnamed = false;
};

//! Reads a session or a report. A relative path is looked for beside the file first, then from the current
//! folder. Throws InputError that names the file, also for one that names no volume, or not one of the other
//! files, or one that holds several objects; and for a file of `inputs` that the session does not mean.
Session readSession(const std::string& path, const InputPaths& inputs = {});
//! The same, with all objects of a session or report that holds several: one of them is seeded at least.
std::vector<Session> readSessions(const std::string& path, const InputPaths& inputs = {});

}  // namespace handlebody
