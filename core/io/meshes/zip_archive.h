#pragma once
// Internal: ZIP archives through libzip, which does not show here.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/finding_kind.h"

struct zip;  // of libzip

namespace handlebody {

//! An archive that is read. What its entries declare is held to what the file can hold, so that no small file
//! unpacks to terabytes.
class ZipReader {
 public:
  //! `format`: what the file should be, for sentences. Throws InputError if it is no archive.
  ZipReader(const std::string& path, std::string format);

  //! The entry of that name; one whose name is the same but for upper and lower case, if there is no other.
  std::optional<std::uint64_t> find(const std::string& name) const;

  //! Hands on what is unpacked, piece by piece. Throws InputError if the entry is encrypted, packed otherwise
  //! than by deflate, damaged (its checksum differs), or declares what cannot be; all entries that were read
  //! count together.
  void read(std::uint64_t entry, const std::function<void(std::string_view)>& take);

 private:
  //! The size that the entry declares.
  std::uint64_t checkedSize(std::uint64_t entry);
  std::string nameOf(std::uint64_t entry) const;
  [[noreturn]] void refuse(FindingKind kind, std::uint64_t entry) const;

  std::string path_, format_;
  std::unique_ptr<::zip, void (*)(::zip*)> archive_;
  std::uint64_t fileSize_ = 0, declared_ = 0;
};

//! An archive of these entries (name, content), deflated, all of them of 1 January 1980: the same entries
//! give the same bytes. Throws std::bad_alloc.
std::string zipped(const std::vector<std::pair<std::string, std::string>>& entries);

}  // namespace handlebody
