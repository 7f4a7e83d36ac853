#include "core/io/dicom_source.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>

#include "core/errors.h"
#include "core/io/dicom_geometry.h"
#include "core/io/dicom_pixels.h"
#include "core/io/dicom_resample.h"
#include "core/io/itk_guard.h"

namespace handlebody {
namespace {

namespace fs = std::filesystem;

//! The images of one series.
struct Series {
  std::string uid;
  std::vector<DicomFile*> files;

  int images() const {
    int n = 0;
    for (const DicomFile* f : files) n += f->frames;
    return n;
  }
};

std::vector<Series> seriesOf(DicomScan& scan) {
  std::map<std::string, Series> found;
  for (DicomFile& f : scan.images) {
    Series& series = found[f.seriesUid];
    series.uid = f.seriesUid;
    series.files.push_back(&f);
  }
  std::vector<Series> list;
  for (auto& [uid, series] : found) list.push_back(std::move(series));
  return list;
}

bool samePixels(const DicomSlice& a, const DicomSlice& b) {
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

//! What was assumed because the files do not say it.
struct Assumed {
  bool places = false, pixels = false, distance = false;
};

//! Gives slices without a position places one behind the other, in the order of their numbers.
Assumed assumeGeometry(Series& series, const VolumeSelection& selection, const std::string& path) {
  Assumed assumed;
  std::vector<DicomFile*>& files = series.files;
  const auto any = [&](auto&& missing) {
    return std::any_of(files.begin(), files.end(), [&](const DicomFile* f) {
      return std::any_of(f->places.begin(), f->places.end(), missing);
    });
  };
  const auto all = [&](auto&& missing) { return !any([&](const DicomPlace& p) { return !missing(p); }); };
  const auto noPosition = [](const DicomPlace& p) { return !p.position || !p.rowDirection; };
  const auto noSpacing = [](const DicomPlace& p) { return !p.pixelSpacing; };
  if (!any(noPosition) && !any(noSpacing)) return assumed;
  const bool cine = std::any_of(files.begin(), files.end(), [](const DicomFile* f) { return f->cine; });
  if (cine && !selection.spacing)
    refuseInput(path, "this is a cine (2D images over time: " + std::to_string(series.images()) +
                          " frames), not a volume; if its frames are slices in space, give --spacing X,Y,Z");
  assumed.pixels = all(noSpacing);
  assumed.places = all(noPosition);
  if ((any(noSpacing) && !assumed.pixels) || (any(noPosition) && !assumed.places))
    return {};  // refused as a stack
  if (assumed.pixels)
    for (DicomFile* f : files)
      for (DicomPlace& p : f->places) p.pixelSpacing = Vec3(1, 1, 0);
  if (!assumed.places) return assumed;
  std::stable_sort(files.begin(), files.end(), [](const DicomFile* a, const DicomFile* b) {
    return a->instanceNumber < b->instanceNumber;
  });
  const std::optional<double> stated = files.front()->sliceDistance;
  assumed.distance = !stated || *stated <= 0;
  const double distance = assumed.distance ? 1 : *stated;
  int k = 0;
  for (DicomFile* f : files)
    for (DicomPlace& p : f->places) {
      p.position = Vec3(0, 0, distance * k++);
      p.rowDirection = Vec3(1, 0, 0);
      p.columnDirection = Vec3(0, 1, 0);
    }
  return assumed;
}

class StackSource : public DicomSource {
 public:
  StackSource(std::string path, Series series, std::shared_ptr<const DicomScan> scan,
              const VolumeSelection& selection);
  void decode(int frame, void* to, const DicomProgress& progress) override;

 protected:
  void readFrame(int frame, void* to, const ReadControl&) override {
    decode(frame, to, [](double, const std::string&, std::uint64_t) {});
  }

 private:
  void describe(const Assumed& assumed);
  void readSlice(const DicomSlice& slice, char* to);
  std::string path_;
  std::shared_ptr<const DicomScan> scan_;  // holds the files of the series
  Series series_;
  DicomStack stack_;
  const DicomFile* open_ = nullptr;  // whose pixels these are
  std::unique_ptr<DicomPixels> pixels_;
};

StackSource::StackSource(std::string path, Series series, std::shared_ptr<const DicomScan> scan,
                         const VolumeSelection& selection)
    : path_(std::move(path)), scan_(std::move(scan)), series_(std::move(series)) {
  for (const DicomFile* f : series_.files) checkDicomPixels(*f, path_);
  const bool mixed = std::any_of(series_.files.begin(), series_.files.end(), [&](const DicomFile* f) {
    return isColour(*f) != isColour(*series_.files.front()) ||
           (isColour(*f) && f->bitsAllocated != series_.files.front()->bitsAllocated);
  });
  if (mixed) refuseInput(path_, "its slices are partly in colour");
  const Assumed assumed = assumeGeometry(series_, selection, path_);
  std::vector<DicomSlice> slices;
  for (const DicomFile* f : series_.files)
    for (int i = 0; i < f->frames; ++i) slices.push_back({f, i});
  stack_ = stackSlices(std::move(slices), path_, selection.uneven, samePixels);
  header_.format = "DICOM";
  header_.grid = stack_.grid;
  header_.frames = stack_.frames;
  header_.component = dicomValueType({series_.files.begin(), series_.files.end()});
  header_.warnings = stack_.warnings;
  describe(assumed);
  checkHeader(header_, path_);
}

void StackSource::describe(const Assumed& assumed) {
  const DicomFile& f = *stack_.slices.front().file;
  GeometrySources& s = header_.sources;
  s.size = "Rows, Columns (0028,0010; 0028,0011) and the number of slices";
  s.spacing[0] = s.spacing[1] = assumed.pixels ? "assumed" : f.spacingSource;
  s.spacing[2] = assumed.distance ? "assumed" : assumed.places ? f.distanceSource : stack_.distanceSource;
  s.origin = assumed.places ? "assumed" : f.positionSource;
  s.direction = assumed.places ? "assumed" : f.orientationSource;
  header_.calibrated = !assumed.pixels && !assumed.distance;
  const auto warn = [&](bool when, const char* text) {
    if (when) header_.warnings.push_back(text);
  };
  warn(assumed.places,
       "The header does not say where the slices lie; they are taken one behind the other, with LPS axes.");
  warn(f.ownFrameOfReference,
       "Positions are in the frame of the ultrasound volume, not of the patient: its axes are taken as LPS.");
  warn(isColour(f), "Colour was turned into luminance (0.2125 R + 0.7154 G + 0.0721 B).");
  warn(f.photometric == "MONOCHROME1", "MONOCHROME1: low values are bright on a display.");
}

void StackSource::readSlice(const DicomSlice& slice, char* to) {
  if (open_ != slice.file) {
    pixels_ = openDicomPixels(*slice.file, path_);
    open_ = slice.file;
  }
  StoredFrame stored;
  withItk(path_, "the slice " + slice.file->file + " is truncated or damaged",
          [&] { pixels_->read(slice.frame, stored); });
  const bool colour = isColour(*slice.file);
  const double slope = colour ? 1 : slice.place().slope, intercept = colour ? 0 : slice.place().intercept;
  if (!scaleDicomFrame(stored, slope, intercept, header_.component, to))
    refuseInput(path_,
                "the slice " + slice.file->file + " is damaged: a value is larger than its header allows");
}

void StackSource::decode(int frame, void* to, const DicomProgress& progress) {
  const Quiet quiet;
  const std::size_t count = stack_.slicesPerFrame();
  const std::uint64_t bytes = stack_.slices.front().file->pixelsPerFrame() * bytesOf(header_.component);
  std::shared_ptr<void> own;  // the slices as they are, where they are to be resampled
  if (!stack_.straight) own = allocate(bytes * count, path_);
  char* slices = static_cast<char*>(own ? own.get() : to);
  for (std::size_t i = 0; i < count; ++i) {
    const DicomSlice& slice = stack_.slices[count * static_cast<std::size_t>(frame) + i];
    progress(static_cast<double>(i) / static_cast<double>(count), slice.file->file,
             slice.file->structure.fileBytes);
    readSlice(slice, slices + bytes * i);
  }
  pixels_.reset();
  open_ = nullptr;
  if (own) resampleStack(stack_, header_.component, own.get(), to, progress);
}

//! Only the header: which series there are.
class SeriesList : public DicomSource {
 public:
  explicit SeriesList(std::vector<SeriesInfo> series) {
    header_.format = "DICOM";
    header_.series = std::move(series);
  }
  void decode(int, void*, const DicomProgress&) override {}

 protected:
  void readFrame(int, void*, const ReadControl&) override {}
};

void refuseDamaged(const DicomScan& scan, const std::string& uid, const std::string& path) {
  for (std::size_t i = 0; i < scan.damaged.size(); ++i)
    if (scan.damagedSeries[i] == uid)
      refuseInput(path, "the file " + scan.damaged[i] + " is truncated or damaged");
  // A file without an image that names the series of images is one of them, cut off between two elements.
  for (const DicomFile& other : scan.others)
    if (!other.seriesUid.empty() && other.seriesUid == uid)
      refuseInput(path, "the file " + other.file + " is truncated (a slice without an image)");
}

//! "a, b, c and 4 more"
std::string someOf(const std::vector<std::string>& names) {
  constexpr std::size_t kShown = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(kShown, names.size()); ++i) text += (i ? ", " : "") + names[i];
  return names.size() > kShown ? text + " and " + std::to_string(names.size() - kShown) + " more" : text;
}

void addLeftOut(const DicomScan& scan, VolumeHeader& header) {
  const auto files = [](std::size_t n) { return std::to_string(n) + (n == 1 ? " file" : " files"); };
  if (!scan.others.empty())
    header.warnings.push_back(files(scan.others.size()) +
                              " of DICOM in the folder hold no image and were left out.");
  if (!scan.damaged.empty())
    header.warnings.push_back(files(scan.damaged.size()) + " of other series are truncated or damaged.");
  if (!scan.foreign.empty())
    header.warnings.push_back(files(scan.foreign.size()) +
                              " in the folder that are not DICOM were left out: " + someOf(scan.foreign) +
                              ".");
}

SourcePointer openSeries(const Series& series, std::shared_ptr<const DicomScan> scan,
                         const OpenRequest& request) {
  refuseDamaged(*scan, series.uid, request.path);
  return std::make_unique<StackSource>(request.path, series, std::move(scan), request.selection);
}

SeriesInfo infoOf(const Series& series) {
  const DicomFile& f = *series.files.front();
  SeriesInfo info;
  info.uid = series.uid;
  info.modality = f.modality;
  info.description = f.modality + (f.modality.empty() || f.description.empty() ? "" : " ") + f.description;
  info.files = static_cast<int>(series.files.size());
  info.slices = series.images();
  return info;
}

void addGeometry(const VolumeHeader& h, SeriesInfo& info) {
  info.size = h.grid.size;
  info.spacing = h.grid.spacing;
  info.frames = h.frames;
}

//! With its size and spacing, or why it has none.
SeriesInfo measuredInfo(const Series& series, std::shared_ptr<const DicomScan> scan,
                        const OpenRequest& request) {
  SeriesInfo info = infoOf(series);
  try {
    addGeometry(openSeries(series, std::move(scan), request)->header(), info);
  } catch (const InputError& error) {
    info.note = std::string(error.what()).substr(request.path.size() + 2);
  }
  return info;
}

}  // namespace

SourcePointer openDicomHere(const OpenRequest& request, const DicomProgress& progress, bool* several) {
  const auto scan = std::make_shared<DicomScan>(scanDicom(request.path, progress));
  const std::vector<Series> series = seriesOf(*scan);
  const auto& wanted = request.selection.series;
  if (request.listOnly || (!wanted && series.size() > 1)) {
    std::vector<SeriesInfo> list;
    for (const Series& s : series) list.push_back(measuredInfo(s, scan, request));
    *several = true;
    return std::make_unique<SeriesList>(std::move(list));
  }
  const auto chosen = std::find_if(series.begin(), series.end(),
                                   [&](const Series& s) { return !wanted || s.uid == *wanted; });
  if (chosen == series.end()) throw UsageError(request.path + ": it holds no series " + *wanted + ".");
  SourcePointer source = openSeries(*chosen, scan, request);
  for (const Series& s : series) source->header().series.push_back(infoOf(s));
  addGeometry(source->header(), source->header().series[static_cast<std::size_t>(chosen - series.begin())]);
  addLeftOut(*scan, source->header());
  return source;
}

}  // namespace handlebody
