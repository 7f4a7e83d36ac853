#include "core/io/dicom/dicom_pixels.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <set>
#include <type_traits>

#include "core/io/dicom/dicom_codecs.h"
#include "core/io/formats/volume_source.h"

namespace handlebody {
namespace {

const char* const kImplicit = "1.2.840.10008.1.2";
const char* const kExplicit = "1.2.840.10008.1.2.1";
const char* const kDeflated = "1.2.840.10008.1.2.1.99";
const char* const kBigEndian = "1.2.840.10008.1.2.2";
const char* const kRle = "1.2.840.10008.1.2.5";

std::uint64_t declaredBits(const DicomFile& f) {
  return f.pixelsPerFrame() * static_cast<std::uint64_t>(f.frames) * static_cast<std::uint64_t>(f.samples) *
         static_cast<std::uint64_t>(f.bitsAllocated);
}

void checkFormat(const DicomFile& f, const std::string& path) {
  static const std::set<int> kBits{1, 8, 16, 32};
  if (kBits.count(f.bitsAllocated) == 0 || f.bitsStored < 1 || f.bitsStored > f.bitsAllocated ||
      f.highBit < f.bitsStored - 1 || f.highBit >= f.bitsAllocated)
    refuseInput(path, {FindingKind::pixelBits,
                       {{"stored", f.bitsStored}, {"allocated", f.bitsAllocated}, {"slice", f.file}}});
  if (f.samples != 1 && f.samples != 3)
    refuseInput(path, {FindingKind::pixelSamples, {{"samples", f.samples}, {"slice", f.file}}});
  if (isColour(f) && f.bitsAllocated != 8 && f.bitsAllocated != 16)
    refuseInput(path, {FindingKind::colourBits, {{"bits", f.bitsAllocated}, {"slice", f.file}}});
  if (f.bitsAllocated == 1 && !(hasPlainPixels(f) && f.structure.walked))
    refuseInput(path, {FindingKind::packedBit, {{"slice", f.file}}});
  static const std::set<std::string> kColours{"RGB", "YBR_FULL", "YBR_FULL_422", "YBR_RCT", "YBR_ICT"};
  if (f.samples == 3 && kColours.count(f.photometric) == 0)
    refuseInput(path, {FindingKind::colourSpace, {{"space", f.photometric}, {"slice", f.file}}});
}

//! The range of a frame's values after rescaling; false if they are no whole numbers.
bool wholeRange(const DicomFile& f, const DicomPlace& place, double& low, double& high) {
  const bool whole = std::floor(place.slope) == place.slope && std::floor(place.intercept) == place.intercept;
  if (!whole) return false;
  const double span = std::ldexp(1.0, f.bitsStored);
  const double least = f.isSigned ? -span / 2 : 0, most = least + span - 1;
  const double a = place.slope * least + place.intercept, b = place.slope * most + place.intercept;
  low = std::min({low, a, b});
  high = std::max({high, a, b});
  return true;
}

Component wholeType(double low, double high, bool isSigned) {
  const auto holds = [&](double least, double most) { return low >= least && high <= most; };
  if (!isSigned && holds(0, 255)) return Component::uint8;
  if (holds(-128, 127)) return Component::int8;
  if (!isSigned && holds(0, 65535)) return Component::uint16;
  if (holds(-32768, 32767)) return Component::int16;
  if (holds(0, 4294967295.0)) return Component::uint32;
  if (holds(-2147483648.0, 2147483647.0)) return Component::int32;
  return Component::float64;
}

template <typename From, typename To>
bool scaleWhole(const From* in, std::size_t n, std::int64_t slope, std::int64_t intercept, To* out) {
  if (std::is_same_v<From, To> && slope == 1 && intercept == 0) {
    std::memcpy(out, in, n * sizeof(To));
    return true;
  }
  bool fits = true;
  for (std::size_t i = 0; i < n; ++i) {
    const std::int64_t value = slope * static_cast<std::int64_t>(in[i]) + intercept;
    out[i] = static_cast<To>(value);
    fits &= static_cast<std::int64_t>(out[i]) == value;
  }
  return fits;
}

//! Slopes and intercepts of more than 32 bits are no whole numbers that any scanner writes.
bool isSmallWhole(double x) { return std::floor(x) == x && std::abs(x) < 2147483648.0; }

template <typename From, typename To>
bool scaleInto(const From* in, std::size_t n, double slope, double intercept, To* out) {
  if constexpr (std::is_integral_v<To> && std::is_integral_v<From>) {
    if (!isSmallWhole(slope) || !isSmallWhole(intercept)) return false;
    return scaleWhole(in, n, static_cast<std::int64_t>(slope), static_cast<std::int64_t>(intercept), out);
  } else {
    for (std::size_t i = 0; i < n; ++i)
      out[i] = static_cast<To>(slope * static_cast<double>(in[i]) + intercept);
    return true;
  }
}

template <typename From>
bool scaleFrom(const From* in, std::size_t n, double slope, double intercept, Component type, void* to) {
  bool fits = false;
  visitComponents(type, to, [&](auto* out) {
    using To = std::remove_const_t<std::remove_pointer_t<decltype(out)>>;
    fits = scaleInto(in, n, slope, intercept, const_cast<To*>(out));
  });
  return fits;
}

}  // namespace

bool isColour(const DicomFile& file) { return file.samples > 1 || file.photometric == "PALETTE COLOR"; }

bool hasPlainPixels(const DicomFile& f) {
  static const std::set<std::string> kPlain{"", kImplicit, kExplicit, kBigEndian};
  return kPlain.count(f.transferSyntax) > 0;
}

void checkDicomPixels(const DicomFile& f, const std::string& path) {
  checkFormat(f, path);
  if (f.structure.walked && f.structure.pixelOffset == 0)
    refuseInput(path, {FindingKind::sliceWithoutPixels, {{"slice", f.file}}});
  // The chroma of YBR_FULL_422 is stored once for two pixels.
  const std::uint64_t bits =
      declaredBits(f) / (f.photometric == "YBR_FULL_422" ? 3 : 1) * (f.photometric == "YBR_FULL_422" ? 2 : 1);
  if (hasPlainPixels(f)) {
    if (bits / 8 > f.structure.fileBytes || (f.structure.walked && bits / 8 > f.structure.pixelBytes))
      refuseInput(path, {FindingKind::sliceHoldsLess, {{"slice", f.file}}});
    return;
  }
  // Runs of RLE and blocks of deflate have a largest ratio; the others have none, but no real image comes
  // near this.
  constexpr std::uint64_t kRleRatio = 64, kDeflateRatio = 1032, kAnyRatio = 10000;
  const std::uint64_t ratio = f.transferSyntax == kRle        ? kRleRatio
                              : f.transferSyntax == kDeflated ? kDeflateRatio
                                                              : kAnyRatio;
  const std::uint64_t held =
      f.structure.pixelOffset > 0 ? f.structure.pixelEnd - f.structure.pixelOffset : f.structure.fileBytes;
  if (bits / 8 / ratio > held)
    refuseInput(path,
                {FindingKind::slicePackedLess, {{"slice", f.file}, {"declared", bits / 8}, {"held", held}}});
}

std::unique_ptr<DicomPixels> openDicomPixels(const DicomFile& file, const std::string& path) {
  const bool ours = hasPlainPixels(file) && file.structure.walked && file.structure.pixelBytes > 0 &&
                    file.transferSyntax != kBigEndian && file.photometric != "YBR_FULL_422" &&
                    file.photometric != "PALETTE COLOR";
  return ours ? openPlainPixels(file, path) : openCompressedPixels(file, path);
}

Component dicomValueType(const std::vector<const DicomFile*>& files) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  bool whole = true, isSigned = false;
  int bits = 0;
  for (const DicomFile* f : files) {
    bits = std::max(bits, f->bitsStored);
    isSigned |= f->isSigned;
    for (const DicomPlace& place : f->places) {
      if (isColour(*f)) continue;  // luminance of the stored values, never rescaled
      whole &= wholeRange(*f, place, low, high);
    }
  }
  if (isColour(*files.front()))
    return files.front()->bitsAllocated == 8 ? Component::uint8 : Component::uint16;
  if (whole && low < 0) isSigned = true;
  if (whole) return wholeType(low, high, isSigned);
  return bits <= 16 ? Component::float32 : Component::float64;
}

bool scaleDicomFrame(const StoredFrame& stored, double slope, double intercept, Component type, void* to) {
  const std::size_t n = stored.bytes.size() / bytesOf(stored.type);
  bool fits = false;
  visitComponents(stored.type, stored.bytes.data(),
                  [&](const auto* in) { fits = scaleFrom(in, n, slope, intercept, type, to); });
  return fits;
}

}  // namespace handlebody
