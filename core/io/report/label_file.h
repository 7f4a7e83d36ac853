#pragma once
// Label maps label by label, whatever keeps them: one value per voxel, or segments that overlap, in layers.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/io/formats/file_labels.h"
#include "core/io/formats/volume_io.h"
#include "core/solid/mask.h"

namespace handlebody {

//! A label, and what the file says of it.
struct NamedLabel : FileLabel {
  int value = 0;
};

inline constexpr std::size_t kMaxLabels = 255;

//! Every label has one number: the value of its voxels, of a DICOM Segmentation the number of the segment. A
//! .seg.nrrd of several layers has the same values in each, so those of a further layer go on where the
//! header says that the one before ends (FileLabels).
class LabelFile {
 public:
  //! `frame`: time point of a 4D label map, zero-based; of a file in layers, which are all read, it says
  //! nothing. Throws InputError that begins with `path`, also if a voxel is no whole number, and UsageError
  //! if there is no such frame.
  explicit LabelFile(const std::string& path, const DecoderSettings& decoder = {},
                     std::optional<int> frame = {});

  //! Of the file; its warnings speak of it without naming it.
  const VolumeInfo& info() const { return info_; }
  //! What is to be told of it where it is used beside a volume; they name it.
  std::vector<Finding> warnings() const;
  //! The voxels of a label, none if it has none; without one, all that are not 0, of all layers. Throws as
  //! the constructor and, of a file in layers, as labels().
  Mask mask(std::optional<int> label);
  //! Those that have a voxel, in ascending order, at least one and kMaxLabels at most. Throws InputError.
  std::vector<NamedLabel> labels();

 private:
  const Volume& layer(int index);
  int shiftOf(int layer) const;
  void findLabels();
  std::string path_;
  DecoderSettings decoder_;
  VolumeInfo info_;
  std::vector<int> shifts_;     // of the numbers of each layer from the values; 0 beyond
  Volume read_;                 // the layer that was read last
  int readLayer_ = 0;           // -1: none
  std::map<int, int> layerOf_;  // of each label; empty until they are looked for
};

//! What a segmentation says of its labels, by its header alone; empty for any other file.
FileLabels labelsSaidBy(const std::string& path);
//! As LabelFile::labels.
std::vector<NamedLabel> labelsIn(const std::string& path);
//! What a file says of one of its labels, or of the only one that it knows, by its header alone. Nothing of a
//! mesh, of what says nothing and of what cannot be read, which is told by whoever reads the voxels.
FileLabel labelIn(const std::string& path, std::optional<int> number);
//! `label` as the file of the object's surface has it; where nothing is to name the patient without the name,
//! which anybody may have written there.
ObjectLabel asInItsFile(const std::string& path, std::optional<int> number, bool isAnonymous,
                        const ObjectLabel& label);
//! The number of a label by `text`, which is that or the name that the file has for it, by its header alone.
//! Throws InputError that names the file and what there is if it has no such name, or has it twice.
int labelCalled(const std::string& path, const std::string& text);

}  // namespace handlebody
