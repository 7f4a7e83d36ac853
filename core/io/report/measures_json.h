#pragma once
// Measures in JSON. Only sources include this header, as json.h.

#include "core/io/report/json.h"
#include "core/measure/measurement.h"
#include "core/measure/object_measures.h"
#include "core/measure/surface_gap.h"
#include "core/mesh/quality.h"

namespace handlebody {

//! "measures" of a report: "volume_mm3", "area_mm2", "centroid" (mm LPS), "largest_diameter_mm",
//! "largest_diameter_ends", "principal_extents_mm", "principal_axes" (a unit vector each), "box_mm" and
//! "intensity" (null without a volume or voxel): "voxels", "mean", "standard_deviation", "minimum",
//! "maximum".
Json measuresToJson(const ObjectMeasures& measures);

//! One of "distances": "from" and "to" (names), "distance_mm", "contact" ("apart", "meet" or "inside"), and
//! "places" on both (mm LPS).
Json gapToJson(const std::string& from, const std::string& to, const SurfaceGap& gap);

//! "quality" of `check`: "angles_degrees", "radius_ratio", "edges_mm", "dihedral_angles_degrees", each with
//! "least", "percent_5", "median", "largest"; "faces_without_area".
Json qualityToJson(const MeshQuality& quality);

//! "measurements" of a session and a report: "kind" ("ruler" or "angle"), "points" (mm LPS) and the value,
//! "length_mm" or "angle_degrees".
Json measurementsToJson(const std::vector<Measurement>& measurements);
//! The inverse; the value is worked out anew. Throws UsageError.
std::vector<Measurement> measurementsFromJson(const JsonField& json);

}  // namespace handlebody
