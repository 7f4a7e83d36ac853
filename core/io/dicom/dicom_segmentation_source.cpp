// Binary DICOM Segmentations as label maps, in layers where segments overlap.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <set>

#include "core/io/dicom/dicom_geometry.h"
#include "core/io/dicom/dicom_source.h"
#include "core/io/formats/volume_source.h"

namespace handlebody {
namespace {

using Bits = std::vector<unsigned char>;

constexpr double kOtherThickness = 0.1;  // part of it: more than headers round

//! Voxels of some segments, slice by slice.
class Layer {
 public:
  void add(int slice, const Bits& bits) {
    Bits& here = slices_[slice];
    here.resize(bits.size());
    for (std::size_t i = 0; i < bits.size(); ++i) here[i] |= bits[i];
  }
  void add(const Layer& other) {
    for (const auto& [slice, bits] : other.slices_) add(slice, bits);
  }
  bool meets(const Layer& other) const {
    return std::any_of(other.slices_.begin(), other.slices_.end(), [this](const auto& one) {
      const auto at = slices_.find(one.first);
      if (at == slices_.end()) return false;
      for (std::size_t i = 0; i < one.second.size(); ++i)
        if ((at->second[i] & one.second[i]) != 0) return true;
      return false;
    });
  }

 private:
  std::map<int, Bits> slices_;
};

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
  double pitchOf(double leastStep);
  void setSlices(double pitch);
  Bits bitsOf(std::size_t frame);
  void setLayers();
  template <typename T>
  void draw(int layer, T* labels, const DecodingProgress& progress);

  DicomFile file_;
  std::string path_;
  std::ifstream stream_;
  std::vector<double> along_;     // of each frame along the normal, mm
  std::vector<int> slice_;        // of each frame
  std::map<int, int> layerOf_{};  // of each segment; 0 for what is not in it
};

SegmentationSource::SegmentationSource(DicomFile file, std::string path)
    : file_(std::move(file)), path_(std::move(path)), stream_(file_.file, std::ios::binary) {
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
  setLayers();
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
  double least = 0;
  for (std::size_t i = 1; i < sorted.size(); ++i)
    if (const double step = sorted[i] - sorted[i - 1]; step > kSamePlace)
      least = least > 0 ? std::min(least, step) : step;
  setSlices(pitchOf(least));
}

//! What the header states counts: the frames may leave slices out. Where it states nothing they may have done
//! so, if slices are not as thick as frames are apart.
double SegmentationSource::pitchOf(double leastStep) {
  if (file_.sliceDistance && *file_.sliceDistance > kSamePlace) return *file_.sliceDistance;
  const double thickness = file_.sliceThickness.value_or(0);
  if (leastStep <= 0 && thickness > kSamePlace) return thickness;  // all frames lie in one slice
  if (leastStep <= 0) refuse(FindingKind::sliceDistanceUnknown);
  if (thickness > kSamePlace && std::abs(leastStep - thickness) > kOtherThickness * thickness)
    header_.warnings.push_back(
        {FindingKind::sliceDistanceGuessed, {{"spacing_mm", leastStep}, {"thickness_mm", thickness}}});
  return leastStep;
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
  const int slices = static_cast<int>(std::lround(highest / pitch)) + 1;
  // Empty slices need not be written: one alone has an empty one behind it, which makes it a volume.
  grid.size = {file_.columns, file_.rows, std::max(2, slices)};
  // The stated distance is rounded; over all slices the positions are better.
  grid.spacing.z() = slices > 1 ? highest / (slices - 1) : pitch;
  const char* const kMeasures = "Pixel Measures: PixelSpacing, SpacingBetweenSlices (0028,0030; 0018,0088)";
  header_.sources = {"Rows, Columns (0028,0010; 0028,0011) and the frames",
                     {kMeasures, kMeasures, "Plane Position (0020,0032)"},
                     file_.positionSource,
                     file_.orientationSource};
}

//! The pixels of a frame, the first one in the lowest bit. A frame begins at the bit behind the last one's,
//! the first bit of a byte is its lowest.
Bits SegmentationSource::bitsOf(std::size_t frame) {
  const std::uint64_t perFrame = file_.pixelsPerFrame(), begin = perFrame * frame, shift = begin % 8;
  Bits bytes((begin + perFrame + 7) / 8 - begin / 8);
  stream_.seekg(static_cast<std::streamoff>(file_.structure.pixelOffset + begin / 8));
  if (!stream_.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size())))
    refuse(FindingKind::truncatedOrDamaged);
  if (shift > 0)
    for (std::size_t i = 0; i < bytes.size(); ++i)
      bytes[i] = static_cast<unsigned char>(bytes[i] >> shift |
                                            (i + 1 < bytes.size() ? bytes[i + 1] << (8 - shift) : 0));
  bytes.resize((perFrame + 7) / 8);
  if (perFrame % 8 > 0) bytes.back() &= static_cast<unsigned char>((1 << perFrame % 8) - 1);
  return bytes;
}

//! Segments that hold the same voxel lie in different layers: each in the first that has room for it.
void SegmentationSource::setLayers() {
  std::map<int, std::vector<std::size_t>> frames;  // of each segment
  for (std::size_t f = 0; f < slice_.size(); ++f) frames[file_.places[f].segment].push_back(f);
  std::set<int> slices(slice_.begin(), slice_.end());
  if (slices.size() == slice_.size()) return;
  std::vector<Layer> layers;
  for (const auto& [segment, those] : frames) {
    Layer own;
    for (const std::size_t f : those) own.add(slice_[f], bitsOf(f));
    auto layer = std::find_if(layers.begin(), layers.end(), [&own](const Layer& l) { return !l.meets(own); });
    if (layer == layers.end()) layer = layers.insert(layer, Layer());
    layerOf_[segment] = static_cast<int>(layer - layers.begin());
    layer->add(own);
  }
  header_.frames = static_cast<int>(layers.size());
  header_.hasLayers = header_.frames > 1;
}

template <typename T>
void SegmentationSource::draw(int layer, T* labels, const DecodingProgress& progress) {
  const std::uint64_t perFrame = file_.pixelsPerFrame();
  for (std::size_t f = 0; f < slice_.size(); ++f) {
    const int segment = file_.places[f].segment;
    if (const auto at = layerOf_.find(segment); (at == layerOf_.end() ? 0 : at->second) != layer) continue;
    progress(static_cast<double>(f) / static_cast<double>(slice_.size()), file_.file,
             file_.structure.fileBytes);
    const Bits bits = bitsOf(f);
    T* const to = labels + perFrame * static_cast<std::uint64_t>(slice_[f]);
    for (std::uint64_t p = 0; p < perFrame; ++p)
      if ((bits[p / 8] >> p % 8 & 1) != 0) to[p] = static_cast<T>(segment);
  }
}

void SegmentationSource::decode(int frame, void* to, const DecodingProgress& progress) {
  std::fill_n(static_cast<char*>(to), header_.bytesPerFrame(), char{0});
  if (header_.component == Component::uint16)
    draw(frame, static_cast<std::uint16_t*>(to), progress);
  else
    draw(frame, static_cast<std::uint8_t*>(to), progress);
}

}  // namespace

SourcePointer openSegmentationHere(const DicomFile& file, const std::string& path) {
  return std::make_unique<SegmentationSource>(file, path);
}

}  // namespace handlebody
