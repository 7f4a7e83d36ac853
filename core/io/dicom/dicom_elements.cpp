#include "core/io/dicom/dicom_elements.h"

#include <algorithm>

#include "core/io/trimmed.h"

namespace handlebody {
namespace {

constexpr std::uint32_t kMediaClass = 0x00020002u, kTransferSyntax = 0x00020010u;
constexpr int kDeepestSequence = 32;  // sequences within sequences; real files have a handful

//! Values are padded to even lengths, UIDs by a zero.
std::string withoutPadding(std::string_view value) {
  using namespace std::string_view_literals;
  return std::string(trimmed(value.substr(0, value.find_last_not_of(" \0"sv) + 1), " "));
}

}  // namespace

bool DicomBeginning::isLittleEndian() const {
  return syntax != "1.2.840.10008.1.2.2" && syntax != "1.2.840.10008.1.2.1.99";
}

bool DicomBeginning::isExplicit() const { return syntax != "1.2.840.10008.1.2"; }

std::uint32_t DicomElements::u16(std::uint64_t at) const {
  const auto byte = [&](std::uint64_t i) { return static_cast<unsigned char>(bytes_[i]); };
  return static_cast<std::uint32_t>(byte(at) | byte(at + 1) << 8);
}

bool DicomElements::read(std::uint64_t at, bool isExplicit, DicomElement& e) const {
  if (at + 8 > size()) return false;
  e.tag = u16(at) << 16 | u16(at + 2);
  const std::string_view vr = bytes_.substr(static_cast<std::size_t>(at + 4), 2);
  const auto letter = [](char c) { return c >= 'A' && c <= 'Z'; };
  const bool delimiter = e.tag >> 16 == 0xfffe;
  if (!isExplicit || delimiter || !letter(vr[0]) || !letter(vr[1])) {
    e = {e.tag, u32(at + 4), at + 8, false};
    return true;
  }
  static constexpr std::string_view kLong = "OB OW OF OD OL OV SQ UC UR UT UN SV UV";
  if (kLong.find(vr) == std::string_view::npos) {
    e = {e.tag, u16(at + 6), at + 8, false};
    return true;
  }
  if (at + 12 > size()) return false;
  e = {e.tag, u32(at + 8), at + 12, vr == "UN"};
  return true;
}

//! `at` moves from behind the head of an item to behind the item.
bool DicomElements::skipItem(const DicomElement& item, std::uint64_t& at, bool isExplicit, int depth) const {
  if (item.hasLength()) {
    at += item.length;
    return at <= size();
  }
  DicomElement e;
  while (read(at, isExplicit, e)) {
    if (e.tag == kItemEnd) {
      at = e.data;
      return true;
    }
    if (!skipValue(e, at, isExplicit, depth)) return false;
  }
  return false;
}

//! The same for a sequence of undefined length, or the fragments of compressed pixel data.
bool DicomElements::skipSequence(std::uint64_t& at, bool isExplicit, int depth) const {
  DicomElement e;
  while (read(at, isExplicit, e)) {
    at = e.data;
    if (e.tag == kSequenceEnd) return true;
    if (e.tag != kItem || !skipItem(e, at, isExplicit, depth)) return false;
  }
  return false;
}

bool DicomElements::skipValue(const DicomElement& e, std::uint64_t& at, bool isExplicit, int depth) const {
  at = e.data;
  if (!e.hasLength())
    return depth < kDeepestSequence && skipSequence(at, isExplicit && !e.unknown, depth + 1);
  at += e.length;
  return at <= size();
}

bool DicomElements::skip(const DicomElement& e, std::uint64_t& at, bool isExplicit) const {
  return skipValue(e, at, isExplicit, 0);
}

//! Group 2 is always explicit and little-endian.
DicomBeginning DicomElements::beginning() const {
  DicomBeginning b;
  if (size() >= kDicomPreamble + 4 && bytes_.substr(kDicomPreamble, 4) == "DICM") b.at = kDicomPreamble + 4;
  DicomElement e;
  while (read(b.at, true, e) && e.tag >> 16 == 2) {
    if (!skip(e, b.at, true)) return b;
    if (e.tag == kMediaClass) b.mediaClass = text(e);
    if (e.tag == kTransferSyntax) b.syntax = text(e);
  }
  b.whole = b.at + 8 <= size();
  return b;
}

std::string DicomElements::text(const DicomElement& e) const {
  return e.hasLength() ? withoutPadding(value(e)) : std::string();
}

std::uint16_t DicomElements::number(const DicomElement& e, std::uint32_t i) const {
  return e.hasLength() && e.length >= 2 * (i + 1) ? static_cast<std::uint16_t>(u16(e.data + 2 * i)) : 0;
}

}  // namespace handlebody
