// DICOM as a volume, decoded in this process.

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/errors.h"
#include "core/io/dicom/dicom_echo.h"
#include "core/io/dicom/dicom_geometry.h"
#include "core/io/dicom/dicom_pixels.h"
#include "core/io/dicom/dicom_resample.h"
#include "core/io/dicom/dicom_series.h"
#include "core/io/dicom/dicom_source.h"
#include "core/io/formats/itk_guard.h"
#include "core/told_error.h"

namespace handlebody {
namespace {

//! What was assumed because the files do not say it.
struct Assumed {
  bool places = false, pixels = false, distance = false;
};

//! Gives slices without a position places one behind the other, in the order of their numbers.
Assumed assumeGeometry(DicomSeries& series, const VolumeSelection& selection, const std::string& path) {
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
  if (cine && !selection.spacing) refuseInput(path, {FindingKind::cine, {{"frames", series.slices.size()}}});
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

class StackSource : public DecodedSource {
 public:
  StackSource(std::string path, DicomSeries series, std::shared_ptr<const DicomScan> scan,
              const VolumeSelection& selection);
  void decode(int frame, void* to, const DecodingProgress& progress) override;

 protected:
  void readFrame(int frame, void* to, const ReadProgress&) override {
    decode(frame, to, [](double, const std::string&, std::uint64_t) {});
  }

 private:
  void describe(const Assumed& assumed);
  void describeTimes();
  void describeOrigin(const Assumed& assumed);
  void readSlice(const DicomSlice& slice, char* to);
  std::string path_;
  std::shared_ptr<const DicomScan> scan_;  // holds the files of the series
  DicomSeries series_;
  DicomStack stack_;
  const DicomFile* open_ = nullptr;  // whose pixels these are
  std::unique_ptr<DicomPixels> pixels_;
};

StackSource::StackSource(std::string path, DicomSeries series, std::shared_ptr<const DicomScan> scan,
                         const VolumeSelection& selection)
    : path_(std::move(path)), scan_(std::move(scan)), series_(std::move(series)) {
  for (const DicomFile* f : series_.files) checkDicomPixels(*f, path_);
  const bool mixed = std::any_of(series_.files.begin(), series_.files.end(), [&](const DicomFile* f) {
    return isColour(*f) != isColour(*series_.files.front()) ||
           (isColour(*f) && f->bitsAllocated != series_.files.front()->bitsAllocated);
  });
  if (mixed) refuseInput(path_, FindingKind::slicesPartlyColour);
  const Assumed assumed = assumeGeometry(series_, selection, path_);
  stack_ = stackSlices(series_.slices, path_, selection.uneven, sameImage);
  header_.format = "DICOM";
  header_.grid = stack_.grid;
  header_.frames = stack_.frames;
  header_.component = dicomValueType({series_.files.begin(), series_.files.end()});
  header_.warnings = stack_.warnings;
  describe(assumed);
  describeTimes();
  checkHeader(header_, path_);
  withItk(path_, {FindingKind::headerUnreadable, {{"format", std::string("DICOM")}}},
          [&] { describeOrigin(assumed); });
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
  const auto warn = [&](bool when, const Finding& warning) {
    if (when) header_.warnings.push_back(warning);
  };
  warn(assumed.places, FindingKind::placesAssumed);
  const Finding missing = missingVolumes(f);
  warn(missing.any(), missing);
  warn(f.echo.slices > 0, FindingKind::patientPlaceAssumed);
  warn(f.ownFrameOfReference && f.echo.slices == 0, FindingKind::placeInUltrasound);
  warn(isColour(f), FindingKind::colourAsLuminance);
  warn(!isColour(f) && std::any_of(series_.files.begin(), series_.files.end(),
                                   [](const DicomFile* file) { return file->slopeWasZero; }),
       FindingKind::slopeIsZero);
  warn(f.photometric == "MONOCHROME1", FindingKind::lowIsBright);
}

//! True if the slices of every time point were taken within half a step between time points.
bool areTimesOfAll(const DicomStack& stack, const std::vector<double>& times) {
  double step = std::numeric_limits<double>::infinity();
  for (std::size_t t = 1; t < times.size(); ++t) step = std::min(step, times[t] - times[t - 1]);
  for (std::size_t i = 0; i < stack.slices.size(); ++i) {
    const auto ms = stack.slices[i].place().milliseconds;
    if (ms && std::abs(*ms - times[i / stack.slicesPerFrame()]) > 0.5 * step) return false;
  }
  return true;
}

//! Of the first slice of each time point, unless the others were taken at times of other ones: hearts do not
//! beat alike while slice after slice is taken.
void StackSource::describeTimes() {
  std::vector<double> times;
  for (std::size_t i = 0; i < stack_.slices.size(); i += stack_.slicesPerFrame())
    if (const auto ms = stack_.slices[i].place().milliseconds) times.push_back(*ms);
  TimeAxis axis = checkedTimes(header_.frames, std::move(times), stack_.slices.front().file->timeSource);
  if (!axis.milliseconds.empty() && areTimesOfAll(stack_, axis.milliseconds)) header_.times = std::move(axis);
}

void StackSource::describeOrigin(const Assumed& assumed) {
  const DicomFile& f = *stack_.slices.front().file;
  auto origin = std::make_shared<DicomOrigin>(readDicomOrigin(f.file));
  for (const DicomSlice& slice : stack_.slices)
    origin->images.push_back(
        {slice.file->classUid, slice.file->instanceUid, slice.file->frames > 1 ? slice.frame + 1 : 0});
  origin->straight = stack_.straight;
  if (assumed.places || assumed.pixels || assumed.distance)
    origin->displaced = FindingKind::seriesUnplaced;
  else if (f.ownFrameOfReference)
    origin->displaced = FindingKind::positionsOfUltrasound;
  header_.dicom = std::move(origin);
}

void StackSource::readSlice(const DicomSlice& slice, char* to) {
  if (open_ != slice.file) {
    pixels_ = openDicomPixels(*slice.file, path_);
    open_ = slice.file;
  }
  StoredFrame stored;
  withItk(path_, {FindingKind::sliceDamaged, {{"slice", slice.file->file}}},
          [&] { pixels_->read(slice.frame, stored); });
  const bool colour = isColour(*slice.file);
  const double slope = colour ? 1 : slice.place().slope, intercept = colour ? 0 : slice.place().intercept;
  if (!scaleDicomFrame(stored, slope, intercept, header_.component, to))
    refuseInput(path_, {FindingKind::sliceValueTooLarge, {{"slice", slice.file->file}}});
}

void StackSource::decode(int frame, void* to, const DecodingProgress& progress) {
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
class SeriesList : public DecodedSource {
 public:
  explicit SeriesList(std::vector<SeriesInfo> series) {
    header_.format = "DICOM";
    header_.series = std::move(series);
    header_.isChoice = true;
  }
  void decode(int, void*, const DecodingProgress&) override {}

 protected:
  void readFrame(int, void*, const ReadProgress&) override {}
};

void refuseDamaged(const DicomScan& scan, const std::string& uid, const std::string& path) {
  for (std::size_t i = 0; i < scan.damaged.size(); ++i)
    if (scan.damagedSeries[i] == uid)
      refuseInput(path, {FindingKind::partDamaged, {{"part", scan.damaged[i]}}});
  // A file without an image that names the series of images is one of them, cut off between two elements.
  for (const DicomFile& other : scan.others)
    if (!other.seriesUid.empty() && other.seriesUid == uid)
      refuseInput(path, {FindingKind::partWithoutImage, {{"part", other.file}}});
}

//! "a, b, c and 4 more"
Finding foreignFiles(const std::vector<std::string>& names) {
  constexpr std::size_t kShown = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(kShown, names.size()); ++i) text += (i ? ", " : "") + names[i];
  if (names.size() > kShown)
    return {FindingKind::filesNotDicomAndMore,
            {{"files", names.size()}, {"names", text}, {"more", names.size() - kShown}}};
  return {names.size() == 1 ? FindingKind::fileNotDicom : FindingKind::filesNotDicom,
          {{"files", names.size()}, {"names", text}}};
}

void addLeftOut(const DicomScan& scan, VolumeHeader& header) {
  const auto add = [&](std::size_t files, FindingKind one, FindingKind several) {
    if (files > 0) header.warnings.push_back({files == 1 ? one : several, {{"files", files}}});
  };
  add(scan.others.size(), FindingKind::fileWithoutImage, FindingKind::filesWithoutImage);
  add(scan.damaged.size(), FindingKind::otherFileDamaged, FindingKind::otherFilesDamaged);
  if (!scan.foreign.empty()) header.warnings.push_back(foreignFiles(scan.foreign));
}

//! The series that the folder was looked through for, and what opens them.
class Chooser {
 public:
  Chooser(const OpenRequest& request, const DecodingProgress& progress)
      : request_(request),
        scan_(std::make_shared<DicomScan>(scanDicom(request.path, progress))),
        series_(seriesOf(*scan_)) {}

  SourcePointer open() const;

 private:
  using Choices = std::vector<const DicomSeries*>;
  Choices choices() const;
  SourcePointer openOne(const DicomSeries& series) const;
  SourcePointer list(const Choices& among) const;
  SeriesInfo measured(const DicomSeries& series) const;
  void addStacks(const DicomSeries& chosen, VolumeHeader& header) const;

  const OpenRequest& request_;
  std::shared_ptr<DicomScan> scan_;
  std::vector<DicomSeries> series_;
};

// The modality before the description, unless that begins with it ("CT Thorax").
std::string described(const DicomFile& f) {
  if (f.description.empty()) return f.modality;
  const bool said = f.modality.empty() || (f.description + ' ').starts_with(f.modality + ' ');
  return said ? f.description : f.modality + ' ' + f.description;
}

SeriesInfo infoOf(const DicomSeries& series) {
  const DicomFile& f = *series.files.front();
  SeriesInfo info;
  info.uid = series.name;
  info.modality = f.modality;
  info.description = described(f);
  info.files = static_cast<int>(series.files.size());
  info.slices = static_cast<int>(series.slices.size());
  return info;
}

void addGeometry(const VolumeHeader& h, SeriesInfo& info) {
  info.size = h.grid.size;
  info.spacing = h.grid.spacing;
  info.frames = h.hasLayers ? 1 : h.frames;
}

SourcePointer Chooser::openOne(const DicomSeries& series) const {
  refuseDamaged(*scan_, series.uid, request_.path);
  if (series.files.front()->isSegmentation())
    return openSegmentationHere(*series.files.front(), request_.path);
  return std::make_unique<StackSource>(request_.path, series, scan_, request_.selection);
}

//! With its size and spacing, or why it has none.
SeriesInfo Chooser::measured(const DicomSeries& series) const {
  SeriesInfo info = infoOf(series);
  try {
    addGeometry(openOne(series)->header(), info);
  } catch (const InputError& error) {
    const Finding told = findingOf(error);
    info.note = told.kind == FindingKind::fileRefused
                    ? Finding(FindingKind::noVolume, {}, told.causes)
                    : Finding(FindingKind::other, {{"text", std::string(error.what())}});
  }
  return info;
}

//! Those that the request leaves open: one, or several to choose from. A UID whose stacks are no one volume
//! stands for all of them.
Chooser::Choices Chooser::choices() const {
  const auto& wanted = request_.selection.series;
  Choices byName, byUid;
  for (const DicomSeries& s : series_) {
    if (wanted && s.name == *wanted) byName.push_back(&s);
    if (!wanted || s.uid == *wanted) byUid.push_back(&s);
  }
  if (!byName.empty()) return {byName.front()};
  if (byUid.empty())
    throw Told<UsageError>(
        Finding(FindingKind::noSuchSeries, {{"file", request_.path}, {"series", *wanted}}));
  Choices whole = byUid;
  std::erase_if(whole, [](const DicomSeries* s) { return s->part; });
  return whole.size() == 1 ? whole : byUid;
}

SourcePointer Chooser::list(const Choices& among) const {
  std::vector<SeriesInfo> infos;
  for (const DicomSeries* s : among) infos.push_back(measured(*s));
  return std::make_unique<SeriesList>(std::move(infos));
}

//! Says which even stacks a resampled series is made of.
void Chooser::addStacks(const DicomSeries& chosen, VolumeHeader& header) const {
  std::vector<Finding> stacks;
  if (!chosen.part)
    for (const DicomSeries& s : series_)
      if (s.part && s.uid == chosen.uid)
        stacks.push_back(
            {FindingKind::stackOf, {{"series", s.uid}, {"stack", s.number}, {"slices", s.slices.size()}}});
  if (!stacks.empty()) header.warnings.push_back({FindingKind::stacksAlone, {}, std::move(stacks)});
}

SourcePointer Chooser::open() const {
  const Choices open = choices();
  if (open.size() > 1) return list(open);
  const DicomSeries& chosen = *open.front();
  SourcePointer source = openOne(chosen);
  VolumeHeader& header = source->header();
  for (const DicomSeries& s : series_) {
    const bool isChosen = &s == &chosen;  // opening gives its slices places that its header does not
    header.series.push_back(isChosen ? infoOf(s) : measured(s));
    if (isChosen) addGeometry(header, header.series.back());
  }
  addStacks(chosen, header);
  addLeftOut(*scan_, header);
  return source;
}

}  // namespace

SourcePointer openDicomHere(const OpenRequest& request, const DecodingProgress& progress) {
  return Chooser(request, progress).open();
}

}  // namespace handlebody
