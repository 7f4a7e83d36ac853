#include "core/io/dicom/dicom_header.h"

#include <gdcmReader.h>

#include <Eigen/Geometry>

#include <algorithm>

#include "core/io/dicom/dicom_echo.h"
#include "core/io/dicom/dicom_values.h"
#include "core/io/formats/volume_source.h"

namespace handlebody {

namespace dicom {

std::vector<double> numbers(const std::string& s) {
  std::vector<double> values;
  for (std::size_t at = 0; at < s.size();) {
    while (at < s.size() && (s[at] == ' ' || s[at] == '+')) ++at;
    double value = 0;
    const auto [end, error] = std::from_chars(s.data() + at, s.data() + s.size(), value);
    if (error != std::errc() || !std::isfinite(value)) return {};
    values.push_back(value);
    at = s.find('\\', static_cast<std::size_t>(end - s.data()));
    if (at == std::string::npos) break;
    ++at;
  }
  return values;
}

}  // namespace dicom

namespace {

using gdcm::DataSet;
using gdcm::Tag;

const Tag kPixelData(0x7fe0, 0x0010);
//! More frames than any scanner makes; a header that says more is damaged.
constexpr double kMaxFrames = 100000;

int whole(const DataSet& data, const Tag& tag, int otherwise) {
  const auto value = dicom::number(data, tag);
  return value && std::abs(*value) < 1e9 ? static_cast<int>(*value) : otherwise;
}

int shortOf(const DataSet& data, const Tag& tag, int otherwise) {
  return dicom::binary<std::uint16_t>(data, tag).value_or(static_cast<std::uint16_t>(otherwise));
}

void readPixelFormat(const DataSet& data, DicomFile& f) {
  f.rows = shortOf(data, {0x0028, 0x0010}, 0);
  f.columns = shortOf(data, {0x0028, 0x0011}, 0);
  f.samples = shortOf(data, {0x0028, 0x0002}, 1);
  f.bitsAllocated = shortOf(data, {0x0028, 0x0100}, 16);
  f.bitsStored = shortOf(data, {0x0028, 0x0101}, f.bitsAllocated);
  f.highBit = shortOf(data, {0x0028, 0x0102}, f.bitsStored - 1);
  f.isSigned = shortOf(data, {0x0028, 0x0103}, 0) == 1;
  f.planar = shortOf(data, {0x0028, 0x0006}, 0) == 1;
  f.photometric = dicom::text(data, {0x0028, 0x0004});
}

//! Row and column directions; the field gives six numbers.
void setOrientation(const std::vector<double>& o, DicomPlace& place) {
  if (o.size() != 6) return;
  place.rowDirection = Vec3(o[0], o[1], o[2]);
  place.columnDirection = Vec3(o[3], o[4], o[5]);
}

//! The field gives the distance between rows first.
void setPixelSpacing(const std::vector<double>& p, DicomPlace& place) {
  if (p.size() == 2) place.pixelSpacing = Vec3(p[1], p[0], 0);
}

std::vector<double> doubles(const DataSet& data, const Tag& tag, std::size_t n) {
  std::vector<double> values;
  for (std::size_t i = 0; i < n; ++i)
    if (const auto v = dicom::binary<double>(data, tag, i); v && std::isfinite(*v)) values.push_back(*v);
  return values;
}

//! When an image was taken: after the R wave, else by its number among even time points.
void readTime(const DataSet& data, DicomPlace& place, DicomFile& f) {
  if (const auto trigger = dicom::number(data, {0x0018, 0x1060}); trigger && std::isfinite(*trigger)) {
    place.milliseconds = *trigger;
    f.timeSource = "TriggerTime (0018,1060)";
    return;
  }
  const auto step = dicom::number(data, {0x0020, 0x0110});
  if (!step || !(*step > 0) || !(place.time > 0)) return;
  place.milliseconds = *step * (place.time - 1);
  f.timeSource = "TemporalResolution, TemporalPositionIdentifier (0020,0110; 0020,0100)";
}

//! The place that a file with one position for all states, in its own data set.
DicomPlace plainPlace(const DataSet& data, DicomFile& f) {
  DicomPlace place;
  place.position = dicom::vector(data, {0x0020, 0x0032});
  setOrientation(dicom::numbers(dicom::text(data, {0x0020, 0x0037})), place);
  setPixelSpacing(dicom::numbers(dicom::text(data, {0x0028, 0x0030})), place);
  place.intercept = dicom::number(data, {0x0028, 0x1052}).value_or(0);
  place.slope = dicom::number(data, {0x0028, 0x1053}).value_or(1);
  place.time = whole(data, {0x0020, 0x0100}, 0);
  readTime(data, place, f);
  if (place.position) f.positionSource = "ImagePositionPatient (0020,0032)";
  if (place.rowDirection) f.orientationSource = "ImageOrientationPatient (0020,0037)";
  if (place.pixelSpacing) f.spacingSource = "PixelSpacing (0028,0030)";
  return place;
}

//! The functional groups of one frame: a macro stands in the frame's own item or in the shared one.
class Groups {
 public:
  Groups(const DataSet* frame, const DataSet* shared) : frame_(frame), shared_(shared) {}
  template <typename F>
  void visit(const Tag& macro, F&& f) const {
    for (const DataSet* group : {frame_, shared_}) {
      if (!group) continue;
      const auto held = dicom::sequence(*group, macro);
      if (const DataSet* data = dicom::item(held.GetPointer(), 0)) return f(*data);
    }
  }

 private:
  const DataSet *frame_, *shared_;
};

void readMeasures(const Groups& groups, DicomPlace& place, DicomFile& f) {
  groups.visit({0x0028, 0x9110}, [&](const DataSet& data) {
    setPixelSpacing(dicom::numbers(dicom::text(data, {0x0028, 0x0030})), place);
    if (place.pixelSpacing) f.spacingSource = "Pixel Measures: PixelSpacing (0028,0030)";
    f.sliceDistance = dicom::number(data, {0x0018, 0x0088});
    f.sliceThickness = dicom::number(data, {0x0018, 0x0050});
    f.distanceSource = "Pixel Measures: SpacingBetweenSlices (0018,0088)";
  });
  groups.visit({0x0028, 0x9145}, [&](const DataSet& data) {
    place.intercept = dicom::number(data, {0x0028, 0x1052}).value_or(0);
    place.slope = dicom::number(data, {0x0028, 0x1053}).value_or(1);
  });
}

void readPlane(const Groups& groups, DicomPlace& place, DicomFile& f) {
  groups.visit({0x0020, 0x9113}, [&](const DataSet& data) {
    place.position = dicom::vector(data, {0x0020, 0x0032});
    if (place.position) f.positionSource = "Plane Position: ImagePositionPatient (0020,0032)";
  });
  groups.visit({0x0020, 0x9116}, [&](const DataSet& data) {
    setOrientation(dicom::numbers(dicom::text(data, {0x0020, 0x0037})), place);
    if (place.rowDirection) f.orientationSource = "Plane Orientation: ImageOrientationPatient (0020,0037)";
  });
  groups.visit({0x0020, 0x930e}, [&](const DataSet& data) {
    const std::vector<double> p = doubles(data, {0x0020, 0x9301}, 3);
    if (p.size() != 3) return;
    place.position = Vec3(p[0], p[1], p[2]);
    f.ownFrameOfReference = true;
    f.positionSource = "Plane Position (Volume): ImagePositionVolume (0020,9301)";
  });
  groups.visit({0x0020, 0x930f}, [&](const DataSet& data) {
    setOrientation(doubles(data, {0x0020, 0x9302}, 6), place);
    if (place.rowDirection)
      f.orientationSource = "Plane Orientation (Volume): ImageOrientationVolume (0020,9302)";
  });
  groups.visit({0x0020, 0x9111}, [&](const DataSet& data) {
    place.time = dicom::binary<std::uint32_t>(data, {0x0020, 0x9128}).value_or(0);
    place.stack = dicom::text(data, {0x0020, 0x9056});
  });
  groups.visit({0x0018, 0x9118}, [&](const DataSet& data) {
    const auto delay = dicom::binary<double>(data, {0x0020, 0x9153});
    if (!delay || !std::isfinite(*delay)) return;
    place.milliseconds = *delay;
    f.timeSource = "Cardiac Synchronization: NominalCardiacTriggerDelayTime (0020,9153)";
  });
  groups.visit({0x0020, 0x9310}, [&](const DataSet& data) {
    const auto offset = dicom::binary<double>(data, {0x0020, 0x930d});
    if (!offset || !std::isfinite(*offset)) return;
    place.milliseconds = 1000 * *offset;
    f.timeSource = "Temporal Position: TemporalPositionTimeOffset (0020,930D)";
  });
  groups.visit({0x0062, 0x000a}, [&](const DataSet& data) {
    place.segment = dicom::binary<std::uint16_t>(data, {0x0062, 0x000b}).value_or(0);
  });
}

void readFunctionalGroups(const DataSet& data, const DicomPlace& plain, DicomFile& f) {
  const auto shared = dicom::sequence(data, {0x5200, 0x9229});
  const auto frames = dicom::sequence(data, {0x5200, 0x9230});
  for (int i = 0; i < f.frames; ++i) {
    const Groups groups(dicom::item(frames.GetPointer(), static_cast<std::size_t>(i)),
                        dicom::item(shared.GetPointer(), 0));
    DicomPlace place = plain;
    if (f.frames > 1) place.position.reset();  // one position for all frames is none for each
    readMeasures(groups, place, f);
    readPlane(groups, place, f);
    f.places.push_back(place);
  }
}

//! Radiotherapy doses: one position, and the offset of every frame along the normal.
void readDoseOffsets(const DataSet& data, const DicomPlace& plain, DicomFile& f) {
  const std::vector<double> offsets = dicom::numbers(dicom::text(data, {0x3004, 0x000c}));
  if (offsets.size() != f.places.size() || !plain.position || !plain.rowDirection) return;
  const Vec3 normal = plain.rowDirection->cross(*plain.columnDirection);
  const double scale = dicom::number(data, {0x3004, 0x000e}).value_or(1);
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    f.places[i].position = *plain.position + (offsets[i] - offsets[0]) * normal;
    f.places[i].slope = scale;
  }
  f.positionSource = "ImagePositionPatient (0020,0032) and GridFrameOffsetVector (3004,000C)";
}

//! Every value would become the intercept; other programs take 1, too.
void replaceZeroSlopes(DicomFile& f) {
  for (DicomPlace& place : f.places) {
    if (place.slope != 0) continue;
    place.slope = 1;
    f.slopeWasZero = true;
  }
}

//! The largest region of an ultrasound image that is measured in centimetres gives the pixel spacing.
void readUltrasoundRegions(const DataSet& data, DicomFile& f) {
  constexpr int kCentimetres = 3;
  const auto regions = dicom::sequence(data, {0x0018, 0x6011});
  double largest = 0;
  Vec3 spacing = Vec3::Zero();
  for (std::size_t i = 0; const DataSet* region = dicom::item(regions.GetPointer(), i); ++i) {
    const auto corner = [&](std::uint16_t e) {
      return static_cast<double>(dicom::binary<std::uint32_t>(*region, {0x0018, e}).value_or(0));
    };
    const double area = (corner(0x601c) - corner(0x6018)) * (corner(0x601e) - corner(0x601a));
    const double dx = dicom::binary<double>(*region, {0x0018, 0x602c}).value_or(0);
    const double dy = dicom::binary<double>(*region, {0x0018, 0x602e}).value_or(0);
    const bool measured = shortOf(*region, {0x0018, 0x6024}, 0) == kCentimetres &&
                          shortOf(*region, {0x0018, 0x6026}, 0) == kCentimetres && dx != 0 && dy != 0;
    if (!measured || area <= largest || !std::isfinite(dx) || !std::isfinite(dy)) continue;
    largest = area;
    spacing = Vec3(10 * std::abs(dx), 10 * std::abs(dy), 0);
  }
  if (largest == 0) return;
  for (DicomPlace& place : f.places) place.pixelSpacing = spacing;
  f.spacingSource = "ultrasound region: PhysicalDeltaX, PhysicalDeltaY (0018,602C; 0018,602E)";
}

//! Frames that lie nowhere and follow one another in time.
bool isCine(const DataSet& data, const DicomFile& f) {
  if (f.frames < 2 || f.places.front().position) return false;
  static const std::vector<std::string> kCineClasses{
      "1.2.840.10008.5.1.4.1.1.3.1", "1.2.840.10008.5.1.4.1.1.3", "1.2.840.10008.5.1.4.1.1.12.1",
      "1.2.840.10008.5.1.4.1.1.12.2"};  // ultrasound multi-frame, X-ray angiography, fluoroscopy
  const std::string kind = dicom::text(data, {0x0008, 0x0016});
  if (std::find(kCineClasses.begin(), kCineClasses.end(), kind) != kCineClasses.end()) return true;
  for (const Tag& tag : {Tag(0x0018, 0x1063), Tag(0x0018, 0x1065), Tag(0x0018, 0x0040)})
    if (!dicom::text(data, tag).empty()) return true;  // FrameTime, FrameTimeVector, CineRate
  return false;
}

DicomFile fileOf(const gdcm::File& read, const std::string& file) {
  const DataSet& data = read.GetDataSet();
  DicomFile f;
  f.file = file;
  f.seriesUid = dicom::text(data, {0x0020, 0x000e});
  f.instanceUid = dicom::text(data, {0x0008, 0x0018});
  f.classUid = dicom::text(data, {0x0008, 0x0016});
  f.modality = dicom::text(data, {0x0008, 0x0060});
  f.description = dicom::text(data, {0x0008, 0x103e});
  f.transferSyntax = dicom::text(read.GetHeader(), {0x0002, 0x0010});
  f.instanceNumber = whole(data, {0x0020, 0x0013}, 0);
  f.acquisitionNumber = whole(data, {0x0020, 0x0012}, 0);
  readPixelFormat(data, f);
  const double frames = dicom::number(data, {0x0028, 0x0008}).value_or(1);
  f.frames = frames >= 1 && frames <= kMaxFrames ? static_cast<int>(frames) : frames > 1 ? -1 : 1;
  if (!f.isImage() || f.frames < 1) return f;
  const DicomPlace plain = plainPlace(data, f);
  f.sliceDistance = dicom::number(data, {0x0018, 0x0088});
  f.distanceSource = "SpacingBetweenSlices (0018,0088)";
  readFunctionalGroups(data, plain, f);
  readDoseOffsets(data, plain, f);
  replaceZeroSlopes(f);
  if (!f.places.front().pixelSpacing) readUltrasoundRegions(data, f);
  readCartesianEcho(data, f);
  f.cine = isCine(data, f);
  f.placed = std::all_of(f.places.begin(), f.places.end(), [](const DicomPlace& p) { return p.complete(); });
  return f;
}

}  // namespace

std::optional<DicomFile> readDicomFile(const std::string& file, const std::string& path) {
  gdcm::Reader reader;
  reader.SetFileName(file.c_str());
  if (!reader.ReadUpToTag(kPixelData)) return std::nullopt;
  DicomFile f = fileOf(reader.GetFile(), file);
  if (f.frames < 0 || f.frames > kMaxFrames)
    refuseInput(path, {FindingKind::framesImplausible, {{"slice", file}}});
  return f;
}

}  // namespace handlebody
