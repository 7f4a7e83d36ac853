// Our own walk over the elements, which checks every bound, so that no process of its own is needed for it.

#include "core/io/dicom/dicom_segments.h"

#include <filesystem>
#include <utility>

#include "core/io/dicom/cie_lab.h"
#include "core/io/dicom/dicom_class.h"
#include "core/io/dicom/dicom_elements.h"

namespace handlebody {

namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t kCharacterSet = 0x00080005u, kCodeValue = 0x00080100u, kCodeScheme = 0x00080102u,
                        kCodeMeaning = 0x00080104u, kRegion = 0x00082218u, kRegionModifier = 0x00082220u,
                        kSegments = 0x00620002u, kCategory = 0x00620003u, kNumber = 0x00620004u,
                        kLabel = 0x00620005u, kAlgorithmType = 0x00620008u, kAlgorithmName = 0x00620009u,
                        kColour = 0x0062000du, kType = 0x0062000fu, kTypeModifier = 0x00620011u;

//! Where the segments lie at the latest: behind the references to images, of which 100,000 take some 15 MB.
constexpr std::size_t kMaxBytes = std::size_t{32} << 20;

std::string utf8OfLatin1(const std::string& text) {
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x80) out += static_cast<char>(0xc0 | byte >> 6);
    out += byte < 0x80 ? c : static_cast<char>(0x80 | (byte & 0x3f));
  }
  return out;
}

class Reader {
 public:
  explicit Reader(const std::string& bytes) : file_(bytes) {}
  FileLabels read();

 private:
  struct Segment {
    int number = 0;
    std::string algorithmType{}, algorithmName{};
    Terminology terminology{};
    FileLabel label{};
  };
  std::string text(const DicomElement& e) const {
    return characters_ == "ISO_IR 100" ? utf8OfLatin1(file_.text(e)) : file_.text(e);
  }
  void takeSegments(const DicomElement& sequence, bool isExplicit);
  void take(const DicomElement& e, bool isExplicit, Segment& segment) const;
  void take(const DicomElement& e, CodedTerm& term) const;
  std::vector<CodedTerm> codesIn(const DicomElement& sequence, bool isExplicit) const;
  ModifiedTerm termIn(const DicomElement& sequence, bool isExplicit, std::uint32_t modifiers) const;
  DicomElements file_;
  std::string characters_;
  FileLabels labels_;
};

void Reader::take(const DicomElement& e, bool isExplicit, Segment& segment) const {
  if (e.tag == kNumber) segment.number = file_.number(e);
  if (e.tag == kLabel) segment.label.name = text(e);
  if (e.tag == kAlgorithmType) segment.algorithmType = text(e);
  if (e.tag == kAlgorithmName) segment.algorithmName = text(e);
  if (e.tag == kColour && e.hasLength() && e.length >= sizeof(dicom::CieLab))
    segment.label.colour = dicom::colourOf({file_.number(e, 0), file_.number(e, 1), file_.number(e, 2)});
  Terminology& said = segment.terminology;
  if (e.tag == kCategory) said.category = termIn(e, isExplicit, 0).term;
  if (e.tag == kType) said.type = termIn(e, isExplicit, kTypeModifier);
  if (e.tag == kRegion) said.region = termIn(e, isExplicit, kRegionModifier);
}

void Reader::take(const DicomElement& e, CodedTerm& term) const {
  if (e.tag == kCodeValue) term.value = text(e);
  if (e.tag == kCodeScheme) term.scheme = text(e);
  if (e.tag == kCodeMeaning) term.meaning = text(e);
}

std::vector<CodedTerm> Reader::codesIn(const DicomElement& sequence, bool isExplicit) const {
  std::vector<CodedTerm> codes;
  CodedTerm code;
  const auto end = [&] {
    if (codes.size() < kMaxModifiers) codes.push_back(std::exchange(code, {}));
  };
  file_.forEachItem(
      sequence, isExplicit, [&](const DicomElement& e, bool) { take(e, code); }, end);
  return codes;
}

//! The first item: there may be no other.
ModifiedTerm Reader::termIn(const DicomElement& sequence, bool isExplicit, std::uint32_t modifiers) const {
  ModifiedTerm first;
  bool isFirst = true;
  const auto takeElement = [&](const DicomElement& e, bool inner) {
    if (!isFirst) return;
    take(e, first.term);
    if (e.tag == modifiers) first.modifiers = codesIn(e, inner);
  };
  file_.forEachItem(sequence, isExplicit, takeElement, [&] { isFirst = false; });
  return first;
}

void Reader::takeSegments(const DicomElement& sequence, bool isExplicit) {
  Segment segment;
  const auto takeElement = [&](const DicomElement& e, bool inner) { take(e, inner, segment); };
  const auto end = [&] {
    segment.label.take(std::move(segment.terminology));
    segment.label.source.algorithm = algorithmSaid(segment.algorithmType, segment.algorithmName);
    if (segment.number > 0) labels_[segment.number] = segment.label;
    segment = {};
  };
  file_.forEachItem(sequence, isExplicit, takeElement, end);
}

FileLabels Reader::read() {
  const DicomBeginning beginning = file_.beginning();
  if (!beginning.whole || !beginning.isLittleEndian()) return {};
  const bool isExplicit = beginning.isExplicit();
  file_.forEach(beginning.at, file_.size(), isExplicit, [&](const DicomElement& e) {
    if (e.tag == kCharacterSet) characters_ = file_.text(e);
    if (e.tag == kSegments) takeSegments(e, isExplicit);
  });
  return labels_;
}

//! By its class first, before more of it is read: a folder may hold many large files.
FileLabels labelsOfFile(const std::string& file) {
  if (!isDicomSegmentationFile(file)) return {};
  const std::string bytes = firstBytes(file, kMaxBytes);
  return Reader(bytes).read();
}

}  // namespace

FileLabels readDicomLabels(const std::string& path) {
  std::error_code failed;
  if (!fs::is_directory(path, failed)) return labelsOfFile(path);
  FileLabels found;
  for (fs::directory_iterator entry(path, failed), end; !failed && entry != end; entry.increment(failed)) {
    FileLabels labels = labelsOfFile(entry->path().string());
    if (!labels.empty() && !found.empty()) return {};
    if (!labels.empty()) found = std::move(labels);
  }
  return found;
}

}  // namespace handlebody
