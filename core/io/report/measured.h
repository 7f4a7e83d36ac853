#pragma once
// What is measured of objects, as text, JSON and CSV: what `measure` and the window show and write.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/measure/centre_line.h"
#include "core/measure/measurement.h"
#include "core/measure/object_measures.h"
#include "core/measure/surface_gap.h"
#include "core/measure/wall_thickness.h"
#include "core/mesh/validity.h"

namespace handlebody {

struct MeasuredObject {
  std::string name;  //!< of the object in a session, else the mesh's path
  TriangleSoup mesh;
  Certificate certificate;
  ObjectMeasures measures;
};

struct MeasuredGap {
  std::string from, to;  //!< names
  SurfaceGap gap;
};

struct MeasuredWall {
  std::string first, second;  //!< what the surfaces are called
  WallThickness wall;
};

struct MeasuredLine {
  std::string object;
  CentreLine line;
};

struct Measured {
  std::string path;    //!< of the mesh or session; empty: not told
  std::string volume;  //!< whose intensities; empty: none
  std::vector<MeasuredObject> objects;
  std::vector<MeasuredGap> gaps;
  std::optional<MeasuredWall> wall;
  std::optional<MeasuredLine> line;
  std::vector<Measurement> placed;  //!< rulers and angles of the session
  std::vector<Finding> warnings;    //!< sentences; those of an object behind its name if there are several
};

//! Without what may name the patient: paths, and the names of objects that `names` has others for.
Measured anonymous(Measured measured, const std::map<std::string, std::string>& names);

//! A table for the eye, with units.
std::string measuredText(const Measured& m);
std::string measuredJson(const Measured& m);
//! A line of names, which end in the unit, one per object, and then one per ruler or angle. "kind" tells them
//! apart, with the columns of measurementsCsv(); without rulers and angles the table has none of these.
std::string measuredCsv(const Measured& m);
//! The same with another character between the columns, and lines that end in LF.
std::string measuredColumns(const Measured& m, char separator);
//! The same of the points of a centre line.
std::string sectionsCsv(const CentreLine& line);
//! The same of rulers and angles: "kind", "length_mm" or "angle_degrees", and the points.
std::string measurementsCsv(const std::vector<Measurement>& placed);
std::string measurementsJson(const std::vector<Measurement>& placed);
//! What measuredJson() says of the centre line.
std::string centreLineJson(const MeasuredLine& m);

}  // namespace handlebody
