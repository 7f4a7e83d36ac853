#include "core/io/dicom/dicom_series.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstring>
#include <fstream>
#include <map>
#include <set>
#include <tuple>

#include "core/errors.h"
#include "core/io/dicom/dicom_pixels.h"

namespace handlebody {
namespace {

using Slices = std::vector<DicomSlice>;

//! More stacks than this are no stacks: a damaged header, or images in every direction.
constexpr std::size_t kMaxStacks = 64;
//! Three slices make two equal distances, the fewest that show a pitch.
constexpr std::size_t kShortestRun = 3;

bool sameFormat(const DicomFile& a, const DicomFile& b) {
  return a.rows == b.rows && a.columns == b.columns && isColour(a) == isColour(b) &&
         (!isColour(a) || a.bitsAllocated == b.bitsAllocated);
}

bool samePlane(const DicomPlace& a, const DicomPlace& b) {
  return (*a.rowDirection - *b.rowDirection).norm() <= kSameDirection &&
         (*a.columnDirection - *b.columnDirection).norm() <= kSameDirection &&
         (*a.pixelSpacing - *b.pixelSpacing).norm() <= kSamePixelSpacing * b.pixelSpacing->norm();
}

bool belongs(const DicomSlice& s, const Slices& stack) {
  const DicomSlice& first = stack.front();
  if (!sameFormat(*s.file, *first.file)) return false;
  const bool placed = s.file->placed, firstPlaced = first.file->placed;
  if (placed && firstPlaced) return samePlane(s.place(), first.place());
  // Frames that lie nowhere are a volume by themselves; a single image without a place is a slice of the
  // others, damaged, and they are refused with it.
  const bool severalFrames = (!placed && s.file->frames > 1) || (!firstPlaced && first.file->frames > 1);
  return severalFrames ? s.file == first.file : true;
}

//! By what no volume can have two of.
std::vector<Slices> splitByPlane(const Slices& all) {
  std::vector<Slices> stacks;
  // Placed ones first: an image without a place joins the stack that it is missing from.
  for (const bool placed : {true, false})
    for (const DicomSlice& s : all) {
      if (s.file->placed != placed) continue;
      const auto found =
          std::find_if(stacks.begin(), stacks.end(), [&](const Slices& stack) { return belongs(s, stack); });
      if (found != stacks.end())
        found->push_back(s);
      else if (stacks.size() == kMaxStacks)
        return {all};
      else
        stacks.push_back({s});
    }
  const bool any = std::any_of(stacks.begin(), stacks.end(), [](const Slices& s) { return s.size() > 1; });
  return any ? stacks : std::vector<Slices>{all};
}

auto orderMade(const DicomSlice& s) {
  return std::tuple(s.file->acquisitionNumber, s.place().stack, s.file->instanceNumber, s.frame);
}

bool liesBeside(const DicomPlace& a, const DicomPlace& b) {
  const double pixel = std::min(a.pixelSpacing->x(), a.pixelSpacing->y());
  return (*a.position - *b.position).norm() > kLargestShift * pixel;
}

//! Of one place along the normal.
bool isCopy(const DicomSlice& a, const DicomSlice& b) {
  return a.file != b.file && !liesBeside(a.place(), b.place()) && sameImage(a, b);
}

//! Slices of one plane cut where their distance changes.
class Runs {
 public:
  explicit Runs(const DicomPlace& plane)
      : normal_(plane.rowDirection->cross(*plane.columnDirection).normalized()) {}

  double along(const DicomSlice& s) const { return s.place().position->dot(normal_); }

  //! In the order given; a new run begins where `apart` says so, too. Copies are left out. Nothing if a run
  //! is too short to have a pitch.
  template <typename Apart>
  std::vector<Slices> cut(const Slices& ordered, Apart&& apart) const {
    std::vector<Slices> runs;
    double pitch = 0;
    for (const DicomSlice& s : ordered) {
      const double step = runs.empty() ? 0 : along(s) - along(runs.back().back());
      if (!runs.empty() && std::abs(step) < kSamePlace && isCopy(s, runs.back().back())) continue;
      const bool even = std::abs(step) >= kSamePlace &&
                        (runs.back().size() == 1 || std::abs(step - pitch) < tolerance(pitch));
      if (runs.empty() || !even || apart(runs.back().back(), s)) {
        if (!runs.empty() && runs.back().size() < kShortestRun) return {};
        runs.push_back({s});
        continue;
      }
      if (runs.back().size() == 1) pitch = step;
      runs.back().push_back(s);
    }
    if (runs.size() < 2 || runs.size() > kMaxStacks || runs.back().size() < kShortestRun) return {};
    return runs;
  }

  //! True if each lies behind the one before it in space, in the order of `sorted`.
  bool oneBehindTheOther(const std::vector<Slices>& sorted) const {
    for (std::size_t i = 1; i < sorted.size(); ++i)
      if (low(sorted[i]) < high(sorted[i - 1]) + kSamePlace) return false;
    return true;
  }

  //! One stack with gaps: runs of one pitch, whole pitches apart.
  bool onlyGaps(const std::vector<Slices>& sorted) const {
    const double pitch = pitchOf(sorted.front());
    for (std::size_t i = 0; i < sorted.size(); ++i) {
      if (std::abs(pitchOf(sorted[i]) - pitch) > tolerance(pitch)) return false;
      const double pitches = i == 0 ? 1 : (low(sorted[i]) - high(sorted[i - 1])) / pitch;
      if (std::abs(pitches - std::round(pitches)) > 0.1) return false;
    }
    return true;
  }

  double low(const Slices& run) const { return std::min(along(run.front()), along(run.back())); }
  double high(const Slices& run) const { return std::max(along(run.front()), along(run.back())); }

 private:
  static double tolerance(double pitch) { return std::max(0.02 * std::abs(pitch), 0.01); }
  double pitchOf(const Slices& run) const {
    return (high(run) - low(run)) / static_cast<double>(run.size() - 1);
  }
  Vec3 normal_;
};

//! A volume of evenly spaced slices, or of whole time points.
bool isEven(const Slices& slices) try {
  stackSlices(slices, "", UnevenSlices::refuse, sameImage);
  return true;
} catch (const InputError&) {
  return false;
}

struct Pitches {
  std::vector<Slices> stacks;
  bool whole = true;  // they are a volume together
};

//! Two acquisitions under one UID, or two pitches one behind the other.
Pitches splitByPitch(Slices slices) {
  if (slices.size() < 2 * kShortestRun || !slices.front().file->placed || isEven(slices)) return {};
  for (const DicomSlice& s : slices)
    if (!s.file->placed) return {};
  const Runs runs(slices.front().place());
  std::stable_sort(slices.begin(), slices.end(),
                   [](const DicomSlice& a, const DicomSlice& b) { return orderMade(a) < orderMade(b); });
  std::vector<Slices> found = runs.cut(slices, [](const DicomSlice& a, const DicomSlice& b) {
    return std::tuple(a.file->acquisitionNumber, a.place().stack) !=
           std::tuple(b.file->acquisitionNumber, b.place().stack);
  });
  const auto never = [](const DicomSlice&, const DicomSlice&) { return false; };
  if (found.empty()) found = runs.cut(slices, never);
  if (found.empty()) {
    std::stable_sort(slices.begin(), slices.end(),
                     [&](const DicomSlice& a, const DicomSlice& b) { return runs.along(a) < runs.along(b); });
    found = runs.cut(slices, never);
  }
  if (!std::all_of(found.begin(), found.end(), isEven) || found.empty()) return {};
  std::vector<Slices> sorted = found;
  std::stable_sort(sorted.begin(), sorted.end(),
                   [&](const Slices& a, const Slices& b) { return runs.low(a) < runs.low(b); });
  const bool whole = runs.oneBehindTheOther(sorted);
  if (whole && runs.onlyGaps(sorted)) return {};
  return {std::move(found), whole};
}

//! The entries of one series while they are found.
struct Entries {
  DicomScan& scan;
  const std::string& uid;
  std::vector<DicomSeries> list{};

  void add(Slices slices, bool part) {
    DicomSeries series{uid, uid, part, {}, std::move(slices), 0};
    std::set<const DicomFile*> used;
    for (const DicomSlice& s : series.slices) used.insert(s.file);
    for (DicomFile& f : scan.images)
      if (used.count(&f) > 0) series.files.push_back(&f);
    list.push_back(std::move(series));
  }
  void number() {
    if (list.size() < 2) return;
    const bool wholeFirst = list[1].part;
    for (std::size_t i = wholeFirst ? 1 : 0; i < list.size(); ++i) {
      list[i].number = static_cast<int>(wholeFirst ? i : i + 1);
      list[i].name += "#" + std::to_string(list[i].number);
    }
  }
};

std::vector<DicomSeries> stacksOf(const std::string& uid, const Slices& all, DicomScan& scan) {
  Entries entries{scan, uid};
  // The frames of a segmentation are of segments as well as of slices: it is a volume by itself.
  if (all.front().file->isSegmentation()) {
    std::map<std::string, Slices> byFile;
    for (const DicomSlice& s : all) byFile[s.file->file].push_back(s);
    for (auto& [file, slices] : byFile) entries.add(std::move(slices), false);
    entries.number();
    return std::move(entries.list);
  }
  std::vector<Slices> planes = splitByPlane(all);
  const auto first = [](const Slices& s) {
    return orderMade(*std::min_element(s.begin(), s.end(), [](const DicomSlice& a, const DicomSlice& b) {
      return orderMade(a) < orderMade(b);
    }));
  };
  std::stable_sort(planes.begin(), planes.end(),
                   [&](const Slices& a, const Slices& b) { return first(a) < first(b); });
  for (Slices& plane : planes) {
    Pitches pitches = splitByPitch(plane);
    const bool wholeToo = pitches.whole && planes.size() == 1;
    if (pitches.stacks.empty() || wholeToo) entries.add(std::move(plane), false);
    for (Slices& stack : pitches.stacks) entries.add(std::move(stack), wholeToo);
  }
  entries.number();
  return std::move(entries.list);
}

}  // namespace

bool sameImage(const DicomSlice& a, const DicomSlice& b) {
  const DicomPlace &pa = a.place(), &pb = b.place();
  if (pa.time != pb.time || pa.milliseconds != pb.milliseconds) return false;
  if (pa.slope != pb.slope || pa.intercept != pb.intercept) return false;
  const DicomStructure &sa = a.file->structure, &sb = b.file->structure;
  const std::uint64_t bytes = sa.pixelEnd - sa.pixelOffset;
  if (sa.pixelOffset == 0 || sb.pixelOffset == 0 || bytes != sb.pixelEnd - sb.pixelOffset) return false;
  std::ifstream first(a.file->file, std::ios::binary), second(b.file->file, std::ios::binary);
  first.seekg(static_cast<std::streamoff>(sa.pixelOffset));
  second.seekg(static_cast<std::streamoff>(sb.pixelOffset));
  std::vector<char> one(1 << 16), two(1 << 16);
  for (std::uint64_t done = 0; done < bytes;) {
    const auto part = static_cast<std::size_t>(std::min<std::uint64_t>(one.size(), bytes - done));
    if (!first.read(one.data(), static_cast<std::streamsize>(part)) ||
        !second.read(two.data(), static_cast<std::streamsize>(part)) ||
        std::memcmp(one.data(), two.data(), part) != 0)
      return false;
    done += part;
  }
  return true;
}

std::vector<DicomSeries> seriesOf(DicomScan& scan) {
  std::map<std::string, Slices> byUid;
  for (const DicomFile& f : scan.images)
    for (int i = 0; i < f.frames; ++i) byUid[f.seriesUid].push_back({&f, i});
  std::vector<DicomSeries> list;
  for (const auto& [uid, slices] : byUid)
    for (DicomSeries& series : stacksOf(uid, slices, scan)) list.push_back(std::move(series));
  return list;
}

}  // namespace handlebody
