#include "core/io/dicom/dicom_geometry.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>
#include <tuple>

namespace handlebody {
namespace {

void checkEachSlice(const std::vector<DicomSlice>& slices, const std::string& path) {
  const DicomPlace& first = slices.front().place();
  for (const DicomSlice& s : slices) {
    const DicomPlace& p = s.place();
    if (!p.position || !p.rowDirection || !p.columnDirection || !p.pixelSpacing)
      refuseInput(path, {FindingKind::sliceUnplaced, {{"slice", s.file->file}}});
    if (p.pixelSpacing->x() <= 0 || p.pixelSpacing->y() <= 0)
      refuseInput(path, {FindingKind::slicePixelSpacing, {{"slice", s.file->file}}});
    if (s.file->columns != slices.front().file->columns || s.file->rows != slices.front().file->rows)
      refuseInput(path, FindingKind::slicesOtherSize);
    if (p.rowDirection->cross(*p.columnDirection).norm() < 0.5)
      refuseInput(path, {FindingKind::sliceDirections, {{"slice", s.file->file}}});
    if ((*p.rowDirection - *first.rowDirection).norm() > kSameDirection ||
        (*p.columnDirection - *first.columnDirection).norm() > kSameDirection)
      refuseInput(path, FindingKind::slicesOtherOrientation);
    if ((*p.pixelSpacing - *first.pixelSpacing).norm() > kSamePixelSpacing * first.pixelSpacing->norm())
      refuseInput(path, FindingKind::slicesOtherSpacing);
  }
}

//! The stack while it is built.
class Stacking {
 public:
  Stacking(std::vector<DicomSlice> slices, std::string path, const SamePixels& same);
  DicomStack build(UnevenSlices uneven);

 private:
  double along(const DicomSlice& s) const { return s.place().position->dot(normal_); }
  void groupByPlace();
  void checkPlaces() const;
  bool areEquallyMany() const;
  template <typename IsCopy>
  int leaveOut(const IsCopy& isCopy);
  void leaveOutCopies();
  void separateTimes();
  void findPlaces();
  void straighten();
  void makeEven(UnevenSlices uneven);

  std::vector<DicomSlice> slices_;
  std::string path_;
  const SamePixels& same_;
  Vec3 row_, column_, normal_;
  std::vector<std::vector<DicomSlice>> groups_;  // by place
  DicomStack stack_;
};

Stacking::Stacking(std::vector<DicomSlice> slices, std::string path, const SamePixels& same)
    : slices_(std::move(slices)), path_(std::move(path)), same_(same) {
  const DicomPlace& first = slices_.front().place();
  row_ = first.rowDirection->normalized();
  column_ = first.columnDirection->normalized();
  normal_ = row_.cross(column_).normalized();
}

void Stacking::groupByPlace() {
  // Numbers of instances need not run as time does, nor alike in every place.
  const bool areTimed = std::all_of(slices_.begin(), slices_.end(),
                                    [](const DicomSlice& s) { return s.place().milliseconds.has_value(); });
  const auto order = [&](const DicomSlice& s) {
    return std::tuple(s.place().time, s.file->acquisitionNumber, areTimed ? *s.place().milliseconds : 0,
                      s.file->instanceNumber, s.frame);
  };
  std::stable_sort(slices_.begin(), slices_.end(),
                   [&](const DicomSlice& a, const DicomSlice& b) { return along(a) < along(b); });
  double last = 0;
  for (const DicomSlice& s : slices_) {
    if (groups_.empty() || along(s) - last > kSamePlace) groups_.emplace_back();
    last = along(s);
    groups_.back().push_back(s);
  }
  for (auto& group : groups_)
    std::stable_sort(group.begin(), group.end(),
                     [&](const DicomSlice& a, const DicomSlice& b) { return order(a) < order(b); });
}

//! What lies in one place along the normal lies there across it, too: stations of a whole body do not, and
//! are no time points of one volume.
void Stacking::checkPlaces() const {
  const Vec3& pixel = *slices_.front().place().pixelSpacing;
  double shift = 0;
  for (const auto& group : groups_)
    for (const DicomSlice& s : group) {
      const Vec3 d = *s.place().position - *group.front().place().position;
      shift = std::max(shift, std::hypot(d.dot(row_), d.dot(column_)));
    }
  if (shift > kLargestShift * std::min(pixel.x(), pixel.y()))
    refuseInput(path_, {FindingKind::slicesShifted, {{"shift_mm", shift}}});
}

bool Stacking::areEquallyMany() const {
  return std::all_of(groups_.begin(), groups_.end(),
                     [&](const auto& group) { return group.size() == groups_.front().size(); });
}

//! Returns how many slices were left out since they are a copy of the one before them.
template <typename IsCopy>
int Stacking::leaveOut(const IsCopy& isCopy) {
  int copies = 0;
  for (auto& group : groups_) {
    std::vector<DicomSlice> kept;
    for (const DicomSlice& s : group)
      if (!kept.empty() && s.file != kept.back().file && isCopy(kept.back(), s))
        ++copies;
      else
        kept.push_back(s);
    group = std::move(kept);
  }
  return copies;
}

void Stacking::leaveOutCopies() {
  int copies = leaveOut([](const DicomSlice& a, const DicomSlice& b) {
    return !b.file->instanceUid.empty() && b.file->instanceUid == a.file->instanceUid;
  });
  // Pixels may be alike at all times, as in slices beside the body: these are no copies if others are then
  // missing in their place.
  const auto before = groups_;
  const int alike = leaveOut(same_);
  if (areEquallyMany())
    copies += alike;
  else
    groups_ = before;
  if (copies == 1) stack_.warnings.push_back(FindingKind::sliceIsCopy);
  if (copies > 1) stack_.warnings.push_back({FindingKind::slicesAreCopies, {{"copies", copies}}});
}

void Stacking::separateTimes() {
  const std::size_t times = groups_.front().size();
  if (!areEquallyMany()) refuseInput(path_, FindingKind::slicesIncomplete);
  if (groups_.size() < 2)
    refuseInput(path_, times > 1 ? FindingKind::slicesInOnePlace : FindingKind::singleSlice);
  stack_.frames = static_cast<int>(times);
  for (std::size_t t = 0; t < times; ++t)
    for (const auto& group : groups_) stack_.slices.push_back(group[t]);
}

void Stacking::findPlaces() {
  const Vec3 origin = *stack_.slices.front().place().position;
  const Vec3& pixel = *stack_.slices.front().place().pixelSpacing;
  for (std::size_t i = 0; i < groups_.size(); ++i) {
    const Vec3 d = *stack_.slices[i].place().position - origin;
    stack_.places.push_back({d.dot(normal_), d.dot(row_) / pixel.x(), d.dot(column_) / pixel.y()});
  }
  Grid& grid = stack_.grid;
  const DicomFile& file = *stack_.slices.front().file;
  grid.size = {file.columns, file.rows, static_cast<int>(groups_.size())};
  grid.spacing = Vec3(pixel.x(), pixel.y(), stack_.places.back().along / (grid.size[2] - 1));
  grid.origin = origin;
  grid.direction.col(0) = row_;
  grid.direction.col(1) = column_;
  grid.direction.col(2) = normal_;
}

//! A stack whose slices are shifted within their planes gets a grid that holds all of them.
void Stacking::straighten() {
  double low[2] = {0, 0}, high[2] = {0, 0}, shift = 0;
  const Vec3& pixel = stack_.grid.spacing;
  for (const SlicePlace& p : stack_.places) {
    shift = std::max(shift, std::hypot(p.x * pixel.x(), p.y * pixel.y()));
    low[0] = std::min(low[0], std::floor(p.x)), high[0] = std::max(high[0], std::ceil(p.x));
    low[1] = std::min(low[1], std::floor(p.y)), high[1] = std::max(high[1], std::ceil(p.y));
  }
  if (shift <= kLargestShift * std::min(pixel.x(), pixel.y())) {
    for (SlicePlace& p : stack_.places) p.x = p.y = 0;
    return;
  }
  const double tilt = std::atan2(shift, stack_.places.back().along) * 180 / std::numbers::pi;
  if (tilt > 60) refuseInput(path_, {FindingKind::slicesShifted, {{"shift_mm", shift}}});
  for (SlicePlace& p : stack_.places) p.x -= low[0], p.y -= low[1];
  stack_.grid.origin += row_ * (low[0] * pixel.x()) + column_ * (low[1] * pixel.y());
  for (std::size_t a = 0; a < 2; ++a) stack_.grid.size[a] += static_cast<int>(high[a] - low[a]);
  stack_.straight = false;
  stack_.warnings.push_back({FindingKind::slicesTilted, {{"degrees", tilt}}});
}

//! "13 gaps of 4 mm, 1 of 1.08 mm, 13 of 7 mm"
std::vector<Finding> runsOf(const std::vector<double>& gaps) {
  constexpr std::size_t kMaxRuns = 5;
  std::vector<Finding> runs;
  for (std::size_t i = 0; i < gaps.size();) {
    std::size_t end = i + 1;
    while (end < gaps.size() && std::abs(gaps[end] - gaps[i]) < std::max(0.02 * gaps[i], 0.01)) ++end;
    if (runs.size() == kMaxRuns) {
      runs.back().kind = FindingKind::nextGapsOfMore;
      break;
    }
    const FindingKind kind = i > 0      ? FindingKind::nextGapsOf
                             : end == 1 ? FindingKind::gapOf
                                        : FindingKind::gapsOf;
    runs.push_back({kind, {{"gaps", end - i}, {"gap_mm", gaps[i]}}});
    i = end;
  }
  return runs;
}

//! Which of the three: for none, one or several missing slices.
FindingKind byMissing(int missing, FindingKind none, FindingKind one, FindingKind several) {
  if (missing == 0) return none;
  return missing == 1 ? one : several;
}

int missingSlices(const std::vector<double>& gaps, double regular) {
  int missing = 0;
  for (double gap : gaps) {
    const double times = gap / regular;
    const bool same = std::abs(times - std::round(times)) < 0.1;
    if (!same || times > 1000) return 0;  // another pitch, not a gap
    missing += static_cast<int>(std::round(times)) - 1;
  }
  return missing;
}

void Stacking::makeEven(UnevenSlices uneven) {
  std::vector<SlicePlace>& places = stack_.places;
  double& spacing = stack_.grid.spacing.z();
  double offset = 0;
  std::vector<double> gaps;
  for (std::size_t i = 0; i < places.size(); ++i) {
    offset = std::max(offset, std::abs(places[i].along - spacing * static_cast<double>(i)));
    if (i > 0) gaps.push_back(places[i].along - places[i - 1].along);
  }
  if (offset <= std::min(0.1 * spacing, kLargestSliceOffset)) {
    for (std::size_t i = 0; i < places.size(); ++i) places[i].along = spacing * static_cast<double>(i);
    return;
  }
  std::vector<double> sorted = gaps;
  std::sort(sorted.begin(), sorted.end());
  const double median = sorted[(sorted.size() - 1) / 2];
  const int missing = missingSlices(gaps, median);
  const Finding what(
      byMissing(missing, FindingKind::slicesUneven, FindingKind::sliceMissing, FindingKind::slicesMissing),
      {{"missing", missing}}, runsOf(gaps));
  if (uneven == UnevenSlices::refuse) refuseInput(path_, what);
  spacing = *std::find_if(sorted.begin(), sorted.end(), [&](double gap) { return gap >= 0.5 * median; });
  const double count = std::floor(places.back().along / spacing + 1e-6) + 1;
  if (count > 20.0 * static_cast<double>(places.size()))
    refuseInput(path_, {FindingKind::tooUneven, {}, what});
  stack_.grid.size[2] = static_cast<int>(count);
  stack_.straight = false;
  stack_.warnings.push_back(
      {byMissing(missing, FindingKind::slicesResampled, FindingKind::sliceMissingResampled,
                 FindingKind::slicesMissingResampled),
       {{"missing", missing}, {"spacing_mm", spacing}},
       what.causes});
}

DicomStack Stacking::build(UnevenSlices uneven) {
  groupByPlace();
  checkPlaces();
  leaveOutCopies();
  separateTimes();
  findPlaces();
  straighten();
  makeEven(uneven);
  stack_.distanceSource = "distance between positions, " + stack_.slices.front().file->positionSource;
  return std::move(stack_);
}

}  // namespace

DicomStack stackSlices(std::vector<DicomSlice> slices, const std::string& path, UnevenSlices uneven,
                       const SamePixels& same) {
  if (slices.size() < 2) refuseInput(path, FindingKind::singleSlice);
  if (slices.front().file->columns < 2 || slices.front().file->rows < 2)
    refuseInput(path, FindingKind::slicesNarrow);
  checkEachSlice(slices, path);
  return Stacking(std::move(slices), path, same).build(uneven);
}

}  // namespace handlebody
