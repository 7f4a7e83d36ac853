// Compressed DICOM pixels, through GDCM. A multi-frame file is decoded frame by frame where its fragments say
// which belongs to which frame, so that memory stays that of a frame and progress is seen.

#include "core/io/dicom/dicom_codecs.h"
#include "core/io/formats/volume_source.h"

#include <gdcmImageReader.h>
#include <gdcmLookupTable.h>
#include <gdcmSequenceOfFragments.h>

#include <cstring>

namespace handlebody {
namespace {

class CompressedPixels : public DicomPixels {
 public:
  CompressedPixels(const DicomFile& file, std::string path);
  void read(int frame, StoredFrame& to) override;

 private:
  using Fragments = gdcm::SequenceOfFragments;
  [[noreturn]] void refuse() const {
    refuseInput(path_, {FindingKind::sliceNotDecoded, {{"slice", file_.file}}});
  }
  void findFrames(const Fragments& fragments);
  void findFramesByOffset(const Fragments& fragments);
  void decode(const gdcm::Image& image, std::size_t frames, std::vector<char>& to);
  gdcm::SmartPointer<gdcm::Image> imageOfFrame(int frame) const;
  void applyPalette(StoredFrame& frame) const;

  const DicomFile& file_;
  std::string path_;
  gdcm::ImageReader reader_;
  std::vector<std::size_t> firstFragment_;  // of each frame, and one more; empty if not known
  std::vector<char> all_;                   // all frames, where they can be had together only
  gdcm::PixelFormat decoded_;
  bool planar_ = false;
};

CompressedPixels::CompressedPixels(const DicomFile& file, std::string path)
    : file_(file), path_(std::move(path)) {
  reader_.SetFileName(file.file.c_str());
  if (!reader_.Read()) refuse();
  const gdcm::Image& image = reader_.GetImage();
  const unsigned int* size = image.GetDimensions();
  const unsigned frames = image.GetNumberOfDimensions() > 2 ? size[2] : 1;
  // Header and decoder must mean the same image, or the decoder would write past our memory.
  if (size[0] != static_cast<unsigned>(file.columns) || size[1] != static_cast<unsigned>(file.rows) ||
      frames != static_cast<unsigned>(file.frames))
    refuseInput(path_, {FindingKind::sliceOtherSize, {{"slice", file.file}}});
  if (const Fragments* fragments = image.GetDataElement().GetSequenceOfFragments()) findFrames(*fragments);
}

void CompressedPixels::findFrames(const Fragments& fragments) {
  const std::size_t n = fragments.GetNumberOfFragments(), frames = static_cast<std::size_t>(file_.frames);
  if (n < frames) refuseInput(path_, {FindingKind::sliceFewerFrames, {{"slice", file_.file}}});
  if (frames == 1)
    firstFragment_ = {0, n};
  else if (n == frames)
    for (std::size_t i = 0; i <= frames; ++i) firstFragment_.push_back(i);
  else
    findFramesByOffset(fragments);
}

//! The basic offset table: where, from the end of the table on, the first fragment of each frame begins.
void CompressedPixels::findFramesByOffset(const Fragments& fragments) {
  const gdcm::ByteValue* table = fragments.GetTable().GetByteValue();
  const std::size_t frames = static_cast<std::size_t>(file_.frames);
  if (!table || table->GetLength() != 4 * frames) return;
  std::vector<std::uint32_t> offsets(frames);
  std::memcpy(offsets.data(), table->GetPointer(), 4 * frames);
  std::uint64_t at = 0;
  for (std::size_t i = 0; i < fragments.GetNumberOfFragments(); ++i) {
    if (firstFragment_.size() < frames && offsets[firstFragment_.size()] == at) firstFragment_.push_back(i);
    constexpr std::uint64_t kItemHeader = 8;
    const gdcm::ByteValue* value = fragments.GetFragment(i).GetByteValue();
    at += kItemHeader + (value ? static_cast<std::uint32_t>(value->GetLength()) : 0u);
  }
  firstFragment_.push_back(fragments.GetNumberOfFragments());
  if (firstFragment_.size() != frames + 1) firstFragment_.clear();
}

gdcm::SmartPointer<gdcm::Image> CompressedPixels::imageOfFrame(int frame) const {
  const gdcm::Image& all = reader_.GetImage();
  const Fragments* fragments = all.GetDataElement().GetSequenceOfFragments();
  gdcm::SmartPointer<Fragments> own = Fragments::New();
  const auto i = static_cast<std::size_t>(frame);
  for (std::size_t k = firstFragment_[i]; k < firstFragment_[i + 1]; ++k)
    own->AddFragment(fragments->GetFragment(k));
  gdcm::DataElement data(gdcm::Tag(0x7fe0, 0x0010));
  data.SetVR(gdcm::VR::OB);
  data.SetValue(*own);
  gdcm::SmartPointer<gdcm::Image> one = new gdcm::Image;
  one->SetNumberOfDimensions(2);
  one->SetDimension(0, static_cast<unsigned>(file_.columns));
  one->SetDimension(1, static_cast<unsigned>(file_.rows));
  one->SetPhotometricInterpretation(all.GetPhotometricInterpretation());
  one->SetPixelFormat(all.GetPixelFormat());
  one->SetPlanarConfiguration(all.GetPlanarConfiguration());
  one->SetTransferSyntax(all.GetTransferSyntax());
  one->SetDataElement(data);
  return one;
}

void CompressedPixels::decode(const gdcm::Image& image, std::size_t frames, std::vector<char>& to) {
  const std::size_t bytes = static_cast<std::size_t>(file_.pixelsPerFrame()) * frames *
                            static_cast<std::size_t>(file_.samples) *
                            static_cast<std::size_t>(file_.bitsAllocated) / 8;
  if (image.GetBufferLength() != bytes) refuse();
  to.assign(bytes, 0);
  if (!image.GetBuffer(to.data())) refuse();
  decoded_ = image.GetPixelFormat();
  planar_ = image.GetPlanarConfiguration() == 1;
  // Decoding may have shown another format than the header's.
  if (decoded_.GetBitsAllocated() != file_.bitsAllocated || decoded_.GetSamplesPerPixel() != file_.samples)
    refuse();
}

void CompressedPixels::applyPalette(StoredFrame& frame) const {
  const gdcm::LookupTable& table = reader_.GetImage().GetLUT();
  std::vector<char> colours(3 * frame.bytes.size());
  if (!table.Initialized() ||
      !table.Decode(colours.data(), colours.size(), frame.bytes.data(), frame.bytes.size()))
    refuseInput(path_, {FindingKind::slicePalette, {{"slice", file_.file}}});
  frame.bytes.swap(colours);
  toLuminance(frame, false, true);
}

void CompressedPixels::read(int frame, StoredFrame& to) {
  if (!firstFragment_.empty()) {
    decode(*imageOfFrame(frame), 1, to.bytes);
  } else {
    if (all_.empty()) decode(reader_.GetImage(), static_cast<std::size_t>(file_.frames), all_);
    const std::size_t bytes = all_.size() / static_cast<std::size_t>(file_.frames);
    to.bytes.assign(all_.begin() + static_cast<std::ptrdiff_t>(bytes) * frame,
                    all_.begin() + static_cast<std::ptrdiff_t>(bytes) * (frame + 1));
  }
  to.type = storedType(file_.bitsAllocated, decoded_.GetPixelRepresentation() == 1);
  if (file_.photometric == "PALETTE COLOR") return applyPalette(to);
  const bool ybr = file_.photometric == "YBR_FULL" || file_.photometric == "YBR_FULL_422";
  if (file_.samples == 3) toLuminance(to, planar_, !ybr);
}

}  // namespace

std::unique_ptr<DicomPixels> openCompressedPixels(const DicomFile& file, const std::string& path) {
  return std::make_unique<CompressedPixels>(file, path);
}

}  // namespace handlebody
