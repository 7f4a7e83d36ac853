#pragma once
// From a grown mesh to files: what the command line and the window share, so that both write the same.

#include <string>
#include <vector>

#include "core/io/dicom/dicom_writer.h"
#include "core/io/report/report.h"
#include "core/io/tetrahedra/tetrahedra.h"

namespace handlebody {

//! A mesh as it is written, with its certificate.
struct CertifiedMesh {
  TriangleSoup mesh;  //!< mm LPS, rounded to single precision
  Certificate certificate;
};

//! STL and most readers hold single precision. The mesh that is certified, counted and written is therefore
//! the rounded one (see roundedToSingle): the same coordinates in every file, and the report's numbers are
//! theirs. Throws std::runtime_error if it fails its certificate: it must not be written then.
CertifiedMesh certifiedForExport(const TriangleSoup& mesh);

//! What a user should look at before trusting the result, besides what the image says against it
//! (ActiveContour::warnings). Uses the session's resolved seeds, the candidates
//! and why the growth stopped.
std::vector<Finding> resultWarnings(const RunReport& report, const TriangleSoup& mesh);

//! What the objects are written with.
struct ExportContext {
  Grid grid;                                     //!< of label maps
  CoordinateSpace space = CoordinateSpace::lps;  //!< of meshes
  std::shared_ptr<const DicomOrigin> dicom{};    //!< of the volume; what DICOM files are made for
  DicomContent content{};                        //!< of DICOM files
  double mesherSeconds = kMesherSeconds;         //!< for a program that makes tetrahedra
};

//! True for every ending that writeResults knows.
bool isResultPath(const std::string& path);
//! The endings that writeResults knows, as the end of a sentence.
const char* resultEndings();

//! All of these have coordinates of their format's own, whatever ExportContext::space, or none: glTF (metres,
//! y up), DICOM (LPS), label maps and their descriptions. False of none.
bool areSpacesFixed(const std::vector<std::string>& paths);

//! Throws UsageError that begins with the path if a file of that ending cannot be made in this context; to be
//! asked before the work.
void checkResult(const std::string& path, const ExportContext& context);

//! What voxels leave out of an object; nothing where none of the paths is a label map.
std::vector<Finding> labelMapWarnings(const TriangleSoup& mesh, const Grid& grid,
                                      const std::vector<std::string>& paths);

//! Writes the objects to each path by its ending: their meshes as one, or their label map. Throws
//! OutputError; UsageError for an unknown ending; Cancelled (cancellation.h) while another program works.
void writeResults(const std::vector<ExportedObject>& objects, const ExportContext& context,
                  const std::vector<std::string>& paths);
//! Writes objects[i] alone to paths[i]; else the same. Cancelled before the first file, or not at all.
//! Precondition: as many paths as objects.
void writeEachResult(const std::vector<ExportedObject>& objects, const ExportContext& context,
                     const std::vector<std::string>& paths);

}  // namespace handlebody
