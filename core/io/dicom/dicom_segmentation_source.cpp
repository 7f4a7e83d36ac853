// Binary DICOM Segmentations as label maps.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <fstream>

#include "core/io/dicom/dicom_geometry.h"
#include "core/io/dicom/dicom_source.h"
#include "core/io/formats/volume_source.h"

namespace handlebody {
namespace {

class SegmentationSource : public DecodedSource {
 public:
  SegmentationSource(DicomFile file, std::string path);
  void decode(int frame, void* to, const DecodingProgress& progress) override;

 protected:
  void readFrame(int frame, void* to, const ReadProgress&) override {
    decode(frame, to, [](double, const std::string&, std::uint64_t) {});
  }

 private:
  [[noreturn]] void refuse(const Finding& cause) const { refuseInput(path_, cause); }
  void checkPixels() const;
  void setOrigin();
  void setGrid();
  void setSlices(double pitch);
  template <typename T>
  bool draw(T* labels, const DecodingProgress& progress) const;

  DicomFile file_;
  std::string path_;
  std::vector<double> along_;  // of each frame along the normal, mm
  std::vector<int> slice_;     // of each frame
};

SegmentationSource::SegmentationSource(DicomFile file, std::string path)
    : file_(std::move(file)), path_(std::move(path)) {
  header_.format = "DICOM";
  checkPixels();
  setGrid();
  int segments = 0;
  for (const DicomPlace& p : file_.places) {
    if (p.segment < 1) refuse(FindingKind::segmentUnknown);
    segments = std::max(segments, p.segment);
  }
  header_.component = segments > 255 ? Component::uint16 : Component::uint8;
  header_.warnings.push_back(FindingKind::isSegmentation);
  setOrigin();
  checkHeader(header_, path_);
}

void SegmentationSource::checkPixels() const {
  if (file_.bitsAllocated != 1 || file_.samples != 1)
    refuse({FindingKind::segmentationNotBinary, {{"bits", file_.bitsAllocated}}});
  if (!file_.structure.walked || file_.structure.pixelBytes == 0) refuse(FindingKind::segmentationPacked);
  const std::uint64_t bits = file_.pixelsPerFrame() * static_cast<std::uint64_t>(file_.frames);
  if ((bits + 7) / 8 > file_.structure.pixelBytes) refuse(FindingKind::holdsLess);
}

//! What is made of it belongs to its patient and study, and refers to it as a whole: several of its frames
//! may lie in one slice.
void SegmentationSource::setOrigin() {
  header_.dicom = std::make_shared<DicomOrigin>(readDicomOrigin(file_.file));
  header_.dicom->images = {{file_.classUid, file_.instanceUid, 0}};
  header_.dicom->straight = false;
}

//! One plane for all frames, at multiples of a distance.
void SegmentationSource::setGrid() {
  const DicomPlace& first = file_.places.front();
  if (!file_.placed) refuse(FindingKind::framesUnplaced);
  const Vec3 normal = first.rowDirection->cross(*first.columnDirection).normalized();
  for (const DicomPlace& p : file_.places) {
    const bool same =
        (*p.rowDirection - *first.rowDirection).norm() <= kSameDirection &&
        (*p.columnDirection - *first.columnDirection).norm() <= kSameDirection &&
        (*p.pixelSpacing - *first.pixelSpacing).norm() <= kSamePixelSpacing * first.pixelSpacing->norm();
    const Vec3 shift = *p.position - *first.position;
    const Vec3 aside = shift - shift.dot(normal) * normal;
    if (!same || aside.norm() > kLargestShift * first.pixelSpacing->head<2>().minCoeff())
      refuse(FindingKind::framesNotBehind);
    along_.push_back(shift.dot(normal));
  }
  Grid& grid = header_.grid;
  grid.direction << *first.rowDirection, *first.columnDirection, normal;
  grid.spacing = *first.pixelSpacing;
  const auto lowest = std::min_element(along_.begin(), along_.end());
  grid.origin = *file_.places[lowest - along_.begin()].position;
  const double low = *lowest;
  for (double& a : along_) a -= low;
  std::vector<double> sorted = along_;
  std::sort(sorted.begin(), sorted.end());
  double pitch = 0;
  for (std::size_t i = 1; i < sorted.size(); ++i)
    if (const double step = sorted[i] - sorted[i - 1]; step > kSamePlace)
      pitch = pitch > 0 ? std::min(pitch, step) : step;
  // What the header states counts: the frames may leave slices out.
  if (file_.sliceDistance && *file_.sliceDistance > kSamePlace) pitch = *file_.sliceDistance;
  if (pitch <= 0) refuse(FindingKind::sliceDistanceUnknown);
  setSlices(pitch);
}

void SegmentationSource::setSlices(double pitch) {
  constexpr double kMaxSlices = 100000;
  const double highest = *std::max_element(along_.begin(), along_.end());
  if (highest / pitch > kMaxSlices) refuse(FindingKind::frameDistance);
  for (const double a : along_) {
    if (std::abs(a / pitch - std::round(a / pitch)) > 0.1) refuse(FindingKind::framesUneven);
    slice_.push_back(static_cast<int>(std::lround(a / pitch)));
  }
  Grid& grid = header_.grid;
  grid.size = {file_.columns, file_.rows, static_cast<int>(std::lround(highest / pitch)) + 1};
  // The stated distance is rounded; over all slices the positions are better.
  grid.spacing.z() = grid.size[2] > 1 ? highest / (grid.size[2] - 1) : pitch;
  const char* const kMeasures = "Pixel Measures: PixelSpacing, SpacingBetweenSlices (0028,0030; 0018,0088)";
  header_.sources = {"Rows, Columns (0028,0010; 0028,0011) and the frames",
                     {kMeasures, kMeasures, "Plane Position (0020,0032)"},
                     file_.positionSource,
                     file_.orientationSource};
}

//! False if two segments hold one voxel. A frame begins at the bit behind the last one's, the first bit of a
//! byte is its lowest.
template <typename T>
bool SegmentationSource::draw(T* labels, const DecodingProgress& progress) const {
  std::ifstream stream(file_.file, std::ios::binary);
  const std::uint64_t perFrame = file_.pixelsPerFrame();
  std::vector<unsigned char> bytes(perFrame / 8 + 2);
  bool apart = true;
  for (std::size_t f = 0; f < slice_.size(); ++f) {
    progress(static_cast<double>(f) / static_cast<double>(slice_.size()), file_.file,
             file_.structure.fileBytes);
    const std::uint64_t begin = perFrame * f, end = begin + perFrame;
    const auto count = static_cast<std::streamsize>((end + 7) / 8 - begin / 8);
    stream.seekg(static_cast<std::streamoff>(file_.structure.pixelOffset + begin / 8));
    if (!stream.read(reinterpret_cast<char*>(bytes.data()), count)) refuse(FindingKind::truncatedOrDamaged);
    T* at = labels + perFrame * static_cast<std::uint64_t>(slice_[f]);
    for (std::uint64_t bit = begin % 8, last = bit + perFrame; bit < last; ++bit, ++at) {
      if ((bytes[bit / 8] >> bit % 8 & 1) == 0) continue;
      apart = apart && *at == 0;
      *at = static_cast<T>(file_.places[f].segment);
    }
  }
  return apart;
}

void SegmentationSource::decode(int, void* to, const DecodingProgress& progress) {
  std::fill_n(static_cast<char*>(to), header_.bytesPerFrame(), char{0});
  const bool apart = header_.component == Component::uint16 ? draw(static_cast<std::uint16_t*>(to), progress)
                                                            : draw(static_cast<std::uint8_t*>(to), progress);
  if (!apart) refuse(FindingKind::segmentsOverlap);
}

}  // namespace

SourcePointer openSegmentationHere(const DicomFile& file, const std::string& path) {
  return std::make_unique<SegmentationSource>(file, path);
}

}  // namespace handlebody
