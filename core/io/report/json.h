#pragma once
// How the project's types stand in JSON: shared by reports, sessions and the command line's --json. Only
// sources include this header; public headers stay free of the JSON library.
//
// Numbers are written with the fewest digits that read back to the same double, whatever the locale. JSON has
// no infinity: infinite ends of a range are the strings "inf" and "-inf". A value that was left to the image
// is null.

#include <nlohmann/json.hpp>

#include "core/evolution/step_report.h"
#include "core/io/report/session.h"
#include "core/mesh/validity.h"
#include "core/volume/volume.h"

namespace handlebody {

//! Keeps the keys in the order in which they were added.
using Json = nlohmann::ordered_json;
class JsonField;  // json_field.h

//! The line that every report carries.
inline constexpr const char* kNotice = "For research use only; not a medical device.";

//! A number, or "inf" / "-inf".
Json numberToJson(double value);
//! [x, y, z]
Json vectorToJson(const Vec3& v);
//! [low, high]
Json rangeToJson(const IntensityRange& range);
//! {"centre": [x, y, z] in mm LPS, "radius": mm or null}, with "background": true for one of that side.
Json seedToJson(const Seed& seed);
Json seedsToJson(const std::vector<Seed>& seeds);
//! Adds size, spacing, origin and direction (its three rows) to an object.
void addGrid(Json& object, const Grid& grid);
//! The certificate: "mesh" of a report and the answer of `check`. "cavities" and "misplaced_components" are
//! -1 where they have no meaning: of a mesh that is not closed, manifold and oriented.
Json certificateToJson(const Certificate& certificate);
//! {"path", "sha256"} and, where they were chosen, "series", "frame", "given_spacing" and "uneven";
//! without a path "voxels_sha256", where it is known.
Json referenceToJson(const VolumeReference& volume);
//! The inverse for what was chosen. Throws as readRequest.
void readSelection(const JsonField& json, VolumeSelection& selection);
//! Adds "calibrated" and "sources" (of size, spacing, origin, direction).
void addSources(Json& object, const VolumeInfo& info);
//! "requested": every parameter as asked for, the seeds and the space of the mesh files; where there are any,
//! the constraints (constraints_json.h), the changes on the way, with the seeds and constraints where those
//! change, and the iteration to stop at. The candidate
//! stands there if it is not the first.
Json requestToJson(const Session& session);
//! Every parameter as used; seeds apart. The candidate stands there if it is not the first.
Json resolvedToJson(const ResolvedParameters& parameters);
//! Its kind, its numbers, its cause and the English sentence.
Json findingToJson(const Finding& finding);
Json findingsToJson(const std::vector<Finding>& findings);
//! An event without its trace.
Json eventToJson(const Event& event);
//! A leak, without what was done at it: "iteration", "location", widths, "disc" and "option", which closes
//! it.
Json leakToJson(const Leak& leak);
//! The stages of an event: lists of triangles (three points each) and of polygons, mm.
Json traceToJson(const EventTrace& trace);
//! As text: two spaces of indentation, flat lists of numbers on one line each, a newline at the end. Bytes
//! that are not UTF-8 (a path may have them) are replaced.
std::string jsonText(const Json& json);

//! The inverse of requestToJson: parameters, seeds, constraints, space, changes and last iteration of
//! `session`. Absent keys keep their defaults, null is "automatic". Throws UsageError, which names the field.
void readRequest(const JsonField& json, Session& session);

}  // namespace handlebody
