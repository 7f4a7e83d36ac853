// DICOM Segmentations, through DCMTK's dcmseg.

#include "core/io/dicom/dicom_dataset.h"

#include <dcmtk/dcmfg/fgderimg.h>
#include <dcmtk/dcmfg/fgfracon.h>
#include <dcmtk/dcmfg/fgpixmsr.h>
#include <dcmtk/dcmfg/fgplanor.h>
#include <dcmtk/dcmfg/fgplanpo.h>
#include <dcmtk/dcmfg/fgseg.h>
#include <dcmtk/dcmseg/segdoc.h>
#include <dcmtk/dcmseg/segment.h>

#include <algorithm>
#include <array>
#include <memory>

#include "core/io/atomic_file.h"
#include "core/io/dicom/cie_lab.h"
#include "core/version.h"

namespace handlebody {

namespace {

using dicom::decimal;
using dicom::require;

using Objects = std::vector<const ExportedObject*>;  // in the order of the segments

constexpr const char* kRefused = "the segmentation cannot be made";

CodeSequenceMacro codeOf(const Code& code) { return {code.value.c_str(), kSnomed, code.meaning.c_str()}; }

//! First and last slice that hold `value`; last below first if none does.
template <typename T>
std::array<int, 2> slicesOf(const T* labels, const Grid& grid, int value) {
  std::array<int, 2> range{0, -1};
  const std::size_t perSlice = grid.voxelCount() / static_cast<std::size_t>(grid.size[2]);
  for (int k = 0; k < grid.size[2]; ++k, labels += perSlice) {
    if (std::find(labels, labels + perSlice, static_cast<T>(value)) == labels + perSlice) continue;
    if (range[1] < 0) range[0] = k;
    range[1] = k;
  }
  return range;
}

//! The document while it is made.
class Maker {
 public:
  Maker(const Volume& labels, const DicomOrigin& origin, const DicomContent& content, const std::string& path)
      : labels_(labels), grid_(labels.grid), origin_(origin), content_(content), path_(path) {
    const IODGeneralEquipmentModule::EquipmentInfo maker(dicom::kMaker, dicom::kMaker, "0",
                                                         HANDLEBODY_VERSION);
    ContentIdentificationMacro* identification = nullptr;
    check(ContentIdentificationMacro::create("1", "SEGMENTATION", "", "", identification));
    const std::unique_ptr<ContentIdentificationMacro> owned(identification);
    DcmSegmentation* made = nullptr;
    check(DcmSegmentation::createBinarySegmentation(made, static_cast<Uint16>(grid_.size[1]),
                                                    static_cast<Uint16>(grid_.size[0]), maker,
                                                    *identification));
    document_.reset(made);
  }

  void describe();
  void add(const ExportedObject& object);
  void write(DcmDataset& data);

 private:
  void check(const OFCondition& condition) const { require(condition, path_, kRefused); }
  void addDimensions();
  template <typename T>
  void addFrames(const T* labels, const ExportedObject& object, Uint16 segment);
  void addFrame(int slice, std::vector<Uint8>& pixels, Uint16 segment);
  std::unique_ptr<FGDerivationImage> sourceOf(int slice) const;
  void pack(const std::vector<Uint8>& pixels);

  const Volume& labels_;
  const Grid& grid_;
  const DicomOrigin& origin_;
  const DicomContent& content_;
  const std::string& path_;
  std::unique_ptr<DcmSegmentation> document_;
  std::vector<Uint8> bits_;  // of all frames: the first pixel of a byte is its lowest bit
  std::size_t pixels_ = 0;   // in them
};

//! Frames follow one another bit by bit; DCMTK 3.6.7 damages those that do not fill whole bytes.
void Maker::pack(const std::vector<Uint8>& pixels) {
  bits_.resize((pixels_ + pixels.size() + 7) / 8, 0);
  for (std::size_t i = 0; i < pixels.size(); ++i, ++pixels_)
    if (pixels[i] != 0) bits_[pixels_ / 8] = static_cast<Uint8>(bits_[pixels_ / 8] | 1u << pixels_ % 8);
}

void Maker::write(DcmDataset& data) {
  check(document_->writeDataset(data));
  constexpr std::size_t kLongestElement = 0xfffffffe;  // of a DICOM element
  if (bits_.size() > kLongestElement) refuseOutput(path_, FindingKind::dicomTooLarge);
  if (bits_.size() % 2) bits_.push_back(0);
  check(data.putAndInsertUint8Array(DCM_PixelData, bits_.data(), static_cast<unsigned long>(bits_.size())));
}

void Maker::addDimensions() {
  IODMultiframeDimensionModule& dimensions = document_->getDimensions();
  const std::string uid = dicom::newUid();
  check(dimensions.addDimensionIndex(DCM_ReferencedSegmentNumber, uid.c_str(),
                                     DCM_SegmentIdentificationSequence, "Segment"));
  check(dimensions.addDimensionIndex(DCM_ImagePositionPatient, uid.c_str(), DCM_PlanePositionSequence,
                                     "Position"));
}

//! What is the same for all frames, and the series.
void Maker::describe() {
  FGPixelMeasures measures;
  check(measures.setPixelSpacing((decimal(grid_.spacing.y()) + "\\" + decimal(grid_.spacing.x())).c_str()));
  check(measures.setSliceThickness(decimal(grid_.spacing.z()).c_str()));
  check(measures.setSpacingBetweenSlices(decimal(grid_.spacing.z()).c_str()));
  check(document_->addForAllFrames(measures));
  std::array<std::string, 6> o;
  for (int i = 0; i < 6; ++i) o[i] = decimal(grid_.direction(i % 3, i / 3));
  FGPlaneOrientationPatient orientation;
  check(orientation.setImageOrientationPatient(o[0].c_str(), o[1].c_str(), o[2].c_str(), o[3].c_str(),
                                               o[4].c_str(), o[5].c_str()));
  check(document_->addForAllFrames(orientation));
  addDimensions();
  check(document_->getSeries().setSeriesInstanceUID(dicom::newUid().c_str()));
  check(document_->getSeries().setSeriesNumber(dicom::kSeriesNumber));
  check(document_->getSeries().setSeriesDescription("Segmentation"));
  check(document_->getSOPCommon().setSOPInstanceUID(dicom::newUid().c_str()));
  check(document_->getStudy().setStudyInstanceUID(dicom::newUid().c_str()));  // replaced later
  const std::string frame =
      content_.anonymous || origin_.frameOfReference.empty() ? dicom::newUid() : origin_.frameOfReference;
  check(document_->getFrameOfReference().setFrameOfReferenceUID(frame.c_str()));
}

std::unique_ptr<FGDerivationImage> Maker::sourceOf(int slice) const {
  if (content_.anonymous || !origin_.straight || !namesImages(origin_)) return nullptr;
  const DicomImage& image = origin_.images[slice];
  ImageSOPInstanceReferenceMacro reference;
  check(reference.setReferencedSOPClassUID(image.sopClass.c_str()));
  check(reference.setReferencedSOPInstanceUID(image.instance.c_str()));
  if (image.frame > 0) check(reference.addReferencedFrameNumber(static_cast<Uint16>(image.frame)));
  OFVector<ImageSOPInstanceReferenceMacro> references;
  references.push_back(reference);
  return std::unique_ptr<FGDerivationImage>(DcmSegmentation::createDerivationImageFG(references, ""));
}

void Maker::addFrame(int slice, std::vector<Uint8>& pixels, Uint16 segment) {
  const Vec3 at = grid_.toWorld(Vec3(0, 0, slice));
  FGPlanePosPatient position;
  check(position.setImagePositionPatient(decimal(at.x()).c_str(), decimal(at.y()).c_str(),
                                         decimal(at.z()).c_str()));
  FGFrameContent place;
  check(place.setDimensionIndexValues(segment, 0));
  check(place.setDimensionIndexValues(static_cast<Uint32>(slice + 1), 1));
  OFVector<FGBase*> groups;
  groups.push_back(&place);
  groups.push_back(&position);
  const std::unique_ptr<FGDerivationImage> source = sourceOf(slice);
  if (source) groups.push_back(source.get());
  check(document_->addFrame(pixels.data(), segment, groups));
  pack(pixels);
}

template <typename T>
void Maker::addFrames(const T* labels, const ExportedObject& object, Uint16 segment) {
  const int value = object.label.value;
  const auto [first, last] = slicesOf(labels, grid_, value);
  if (last < first) refuseOutput(path_, {FindingKind::objectWithoutVoxel, {{"object", object.label.name}}});
  const std::size_t perSlice = grid_.voxelCount() / static_cast<std::size_t>(grid_.size[2]);
  std::vector<Uint8> pixels(perSlice);
  for (int k = first; k <= last; ++k) {
    const T* slice = labels + perSlice * static_cast<std::size_t>(k);
    std::transform(slice, slice + perSlice, pixels.begin(),
                   [value](T label) { return static_cast<Uint8>(label == static_cast<T>(value)); });
    addFrame(k, pixels, segment);
  }
}

void Maker::add(const ExportedObject& object) {
  const Term* named = termFromName(object.label.term);
  const Term& term = named ? *named : plainTerm();
  DcmSegment* made = nullptr;
  check(DcmSegment::create(made, "Segment", codeOf(term.category), codeOf(term.type),
                           DcmSegTypes::SAT_SEMIAUTOMATIC, dicom::kMaker));
  std::unique_ptr<DcmSegment> segment(made);
  const dicom::CieLab lab = dicom::cieLab(object.label.colour);
  check(segment->setRecommendedDisplayCIELabValue(lab[0], lab[1], lab[2]));
  Uint16 number = 0;
  check(document_->addSegment(segment.get(), number));
  static_cast<void>(segment.release());  // the document has it
  if (labels_.type == VoxelType::uint16)
    addFrames(labels_.data<std::uint16_t>(), object, number);
  else
    addFrames(labels_.data<std::uint8_t>(), object, number);
}

void putCode(DcmItem& item, const CodedTerm& code) {
  item.putAndInsertString(DCM_CodeValue, code.value.c_str());
  item.putAndInsertString(DCM_CodingSchemeDesignator, code.scheme.c_str());
  item.putAndInsertString(DCM_CodeMeaning, code.meaning.c_str());
}

void putTerm(DcmItem& segment, const DcmTagKey& tag, const ModifiedTerm& said, const DcmTagKey& modifiers) {
  DcmItem *item = nullptr, *modifier = nullptr;
  segment.findAndDeleteElement(tag);
  segment.findOrCreateSequenceItem(tag, item, 0);
  putCode(*item, said.term);
  for (const CodedTerm& code : said.modifiers) {
    item->findOrCreateSequenceItem(modifiers, modifier, -2);  // a new one at the end
    putCode(*modifier, code);
  }
}

void putTerminology(DcmItem& segment, const Terminology& said) {
  putTerm(segment, DCM_SegmentedPropertyCategoryCodeSequence, {said.category, {}}, {});
  putTerm(segment, DCM_SegmentedPropertyTypeCodeSequence, said.type,
          DCM_SegmentedPropertyTypeModifierCodeSequence);
  if (!said.region.term.value.empty())
    putTerm(segment, DCM_AnatomicRegionSequence, said.region, DCM_AnatomicRegionModifierSequence);
}

//! A name is required of all but what is manual, and may not stand there (PS3.3 C.8.20.4).
void putAlgorithm(DcmItem& segment, const SegmentAlgorithm& how) {
  segment.putAndInsertString(DCM_SegmentAlgorithmType, algorithmTypeName(how.type));
  if (how.type == AlgorithmType::manual)
    segment.findAndDeleteElement(DCM_SegmentAlgorithmName);
  else
    segment.putAndInsertString(DCM_SegmentAlgorithmName, how.name.c_str());
}

//! What is said of the object by its file. The name of its algorithm may be that of a site, its type is not.
SegmentSource sourceOf(const ExportedObject& object, const DicomContent& content) {
  return content.anonymous ? withoutSite(object.label.source) : object.label.source;
}

void addTexts(const SegmentSource& source, dicom::Texts& texts) {
  if (source.algorithm) texts.push_back(source.algorithm->name);
  if (!source.terminology) return;
  const auto add = [&](const CodedTerm& code) {
    texts.insert(texts.end(), {code.value, code.scheme, code.meaning});
  };
  add(source.terminology->category);
  for (const ModifiedTerm& said : {source.terminology->type, source.terminology->region}) {
    add(said.term);
    std::for_each(said.modifiers.begin(), said.modifiers.end(), add);
  }
}

//! What the library writes otherwise, or checks more strictly than real series are made.
void complete(DcmDataset& data, const Objects& objects, const DicomOrigin& origin,
              const DicomContent& content, const std::string& path) {
  dicom::Texts texts{content.creator, content.description};
  for (const ExportedObject* object : objects) {
    texts.push_back(object->label.name);
    addTexts(sourceOf(*object, content), texts);
  }
  dicom::addPatientAndStudy(data, origin, content, texts, path);
  dicom::addReferencedSeries(data, origin, content);
  dicom::addContentDate(data, content);
  data.putAndInsertString(DCM_ContentCreatorName, content.creator.c_str());
  data.putAndInsertString(DCM_ContentDescription, content.description.c_str());
  data.putAndInsertUint16(DCM_HighBit, 0);  // DCMTK up to 3.7.0 writes 1
  for (std::size_t i = 0; i < objects.size(); ++i) {
    DcmItem* segment = nullptr;
    require(data.findAndGetSequenceItem(DCM_SegmentSequence, segment, static_cast<long>(i)), path, kRefused);
    segment->putAndInsertString(DCM_SegmentLabel, objects[i]->label.name.c_str());
    const SegmentSource source = sourceOf(*objects[i], content);
    if (source.terminology) putTerminology(*segment, *source.terminology);
    putAlgorithm(*segment, writtenAlgorithm(source.algorithm));
  }
}

//! In the order of their values: segments are numbered from 1 without gaps (PS3.3 C.8.20.4.1), whatever the
//! values are.
Objects byValue(const std::vector<ExportedObject>& objects) {
  Objects sorted;
  for (const ExportedObject& object : objects) sorted.push_back(&object);
  std::stable_sort(sorted.begin(), sorted.end(), [](const ExportedObject* a, const ExportedObject* b) {
    return a->label.value < b->label.value;
  });
  return sorted;
}

}  // namespace

void writeDicomSegmentation(const Volume& labels, const std::vector<ExportedObject>& given,
                            const DicomOrigin& origin, const DicomContent& content, const std::string& path) {
  const Objects objects = byValue(given);
  dicom::checkExport(origin, content, path);
  if (origin.straight && origin.images.size() < static_cast<std::size_t>(labels.grid.size[2]))
    refuseDicom(path, FindingKind::labelsNotOnGrid);
  Maker maker(labels, origin, content, path);
  maker.describe();
  for (const ExportedObject* object : objects) maker.add(*object);
  DcmDataset data;
  maker.write(data);
  complete(data, objects, origin, content, path);
  dicom::save(data, DCM_PixelData, path);
}

}  // namespace handlebody
