#pragma once
// Internal: the elements of little-endian DICOM in memory, bounds checked. No library, so it may look at
// bytes that nobody has checked, in any process.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace handlebody {

inline constexpr std::size_t kDicomPreamble = 128;  //!< bytes, before "DICM"

struct DicomElement {
  std::uint32_t tag = 0;     //!< group and element
  std::uint32_t length = 0;  //!< of its value, bytes
  std::uint64_t data = 0;    //!< where that begins
  bool unknown = false;      //!< VR UN: what it holds is implicit

  static constexpr std::uint32_t kUndefined = 0xffffffffu;
  bool hasLength() const { return length != kUndefined; }
};

//! How the data set of a file begins.
struct DicomBeginning {
  std::uint64_t at = 0;
  std::string syntax{};      //!< UID of the transfer syntax; empty: not said
  std::string mediaClass{};  //!< UID of the SOP class, as what stands before the data set says it
  bool whole = false;        //!< all before it lies within the file, and something comes

  //! Neither deflated nor big-endian.
  bool isLittleEndian() const;
  bool isExplicit() const;
};

class DicomElements {
 public:
  explicit DicomElements(std::string_view bytes) : bytes_(bytes) {}

  std::uint64_t size() const { return bytes_.size(); }
  //! With or without a preamble.
  DicomBeginning beginning() const;
  //! The head of the element at `at`; its value need not lie within. False if the head does not.
  bool read(std::uint64_t at, bool isExplicit, DicomElement& element) const;
  //! Moves `at` behind the value; false if that does not lie within, or holds too many sequences within
  //! sequences.
  bool skip(const DicomElement& element, std::uint64_t& at, bool isExplicit) const;

  //! Precondition: the value has a length and lies within, as for those that forEach gives.
  std::string_view value(const DicomElement& e) const {
    return bytes_.substr(static_cast<std::size_t>(e.data), e.length);
  }
  //! Without the padding at its ends; empty for one without a length.
  std::string text(const DicomElement& element) const;
  //! The i-th unsigned number of 16 bits; 0 if there is none.
  std::uint16_t number(const DicomElement& element, std::uint32_t i = 0) const;

  //! f(element) for those between `at` and `end` whose values lie within, up to the end of an item. False if
  //! one does not.
  template <typename F>
  bool forEach(std::uint64_t at, std::uint64_t end, bool isExplicit, F&& f) const {
    DicomElement e;
    while (at < end) {
      if (!read(at, isExplicit, e)) return false;
      if (e.tag == kItemEnd) return true;
      if (!skip(e, at, isExplicit)) return false;
      f(e);
    }
    return true;
  }
  //! f(element, isExplicit) for the elements of each item of a sequence, g() behind each item.
  template <typename F, typename G>
  void forEachItem(const DicomElement& sequence, bool isExplicit, F&& f, G&& g) const {
    const bool inner = isExplicit && !sequence.unknown;
    const std::uint64_t end = sequence.hasLength() ? sequence.data + sequence.length : size();
    DicomElement item;
    for (std::uint64_t at = sequence.data; at < end && read(at, inner, item) && item.tag == kItem;) {
      at = item.data;
      if (!skipItem(item, at, inner, 0)) return;
      forEach(item.data, at, inner, [&](const DicomElement& e) { f(e, inner); });
      g();
    }
  }

 private:
  static constexpr std::uint32_t kItem = 0xfffee000u, kItemEnd = 0xfffee00du, kSequenceEnd = 0xfffee0ddu;

  std::uint32_t u16(std::uint64_t at) const;
  std::uint32_t u32(std::uint64_t at) const { return u16(at) | u16(at + 2) << 16; }
  bool skipValue(const DicomElement& e, std::uint64_t& at, bool isExplicit, int depth) const;
  bool skipSequence(std::uint64_t& at, bool isExplicit, int depth) const;
  bool skipItem(const DicomElement& item, std::uint64_t& at, bool isExplicit, int depth) const;
  std::string_view bytes_;
};

}  // namespace handlebody
