#pragma once
// A mesh as Python has it: it never changes.

#include <memory>
#include <optional>
#include <string>

#include "core/io/report/result.h"

namespace handlebody::python {

class PythonMesh {
 public:
  explicit PythonMesh(TriangleSoup mesh);
  //! One that has its certificate already.
  explicit PythonMesh(CertifiedMesh mesh);

  const std::shared_ptr<const TriangleSoup>& soup() const { return soup_; }
  //! Worked out once. Not for several threads at once, as all that follows.
  const Certificate& certificate() const;
  //! Throws InputError: the mesh has no inside to measure or fill.
  void requireBody(const std::string& what) const;
  //! uint8, 1 inside. Throws InputError.
  Volume labelMap(const Grid& grid) const;

 private:
  std::shared_ptr<const TriangleSoup> soup_;
  mutable std::optional<Certificate> certificate_;
};

//! What a mesh is written with, besides its path.
struct SaveSettings {
  std::string space = "LPS";
  std::string name{};    //!< of the object; empty: that of `object`
  int label = 1;         //!< of its voxels
  ObjectLabel object{};  //!< what else is written of it
};

//! Throws UsageError if writing `path` would change `input` (belongsToVolume); that may be empty.
void requireOther(const std::string& path, const std::string& input);

//! Writes the mesh by the ending of each path, rounded to single precision and certified as the command line
//! does. `volume` gives the grid of label maps and what DICOM files are made for; null: neither is written.
//! No path may belong to one of `inputs`. Returns what label maps leave out. Throws UsageError, OutputError,
//! InputError; nothing is written if it fails its certificate.
std::vector<Finding> save(const TriangleSoup& mesh, const VolumeInfo* volume,
                          const std::vector<std::string>& paths, const SaveSettings& settings,
                          const std::vector<std::string>& inputs);

}  // namespace handlebody::python
