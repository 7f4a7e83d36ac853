#pragma once
// Internal: NRRD headers. The format: https://teem.sourceforge.net/nrrd/format.html

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/formats/volume_source.h"

namespace handlebody {

//! A field's name as it is known by: in lower case, without blanks. Teem writes "space origin" and reads
//! "spaceorigin", too.
std::string nrrdName(std::string_view name);

//! The fields of the header as text, and where the data are.
struct NrrdFields {
  std::map<std::string, std::string> fields{};  //!< by nrrdName
  std::vector<std::string> dataFiles{};         //!< paths; empty if the data follow the header
  std::map<std::string, std::string> keys{};    //!< of the lines "key:=value", as they are
  std::uint64_t end = 0;                        //!< first byte after the header
  bool sequence = false;                        //!< tracked 2D frames

  bool has(std::string_view name) const { return fields.count(nrrdName(name)) > 0; }
  std::string value(std::string_view name) const {
    const auto found = fields.find(nrrdName(name));
    return found == fields.end() ? std::string() : found->second;
  }
};

//! How the values of one volume lie in the stream of all.
struct NrrdLayout {
  std::uint64_t inner = 1;  //!< values that follow one another before the next time point's
  std::uint64_t outer = 1;  //!< how often that repeats
  bool swapped = false;     //!< bytes stand in the other order
  bool compressed = false, text = false;
  long long byteSkip = 0, lineSkip = 0;
};

//! Throws InputError that begins with `path`.
NrrdFields readNrrdFields(const std::string& path);
//! Fills the header but for checkHeader's checks; throws InputError.
NrrdLayout interpretNrrd(const NrrdFields& fields, const std::string& path, VolumeHeader& header);

}  // namespace handlebody
