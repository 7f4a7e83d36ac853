#pragma once
// Internal: the bytes of a file from an offset on, inflated where they are compressed.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "core/io/formats/volume_source.h"

namespace handlebody {

//! Sequential reader. Compressed data (gzip, also of several members, or zlib) are checked with their own
//! checksum.
class ByteStream {
 public:
  enum class Coding { raw, deflate };
  //! Throws InputError if the file cannot be opened.
  ByteStream(const std::string& path, std::uint64_t offset, Coding coding);
  ~ByteStream();
  ByteStream(const ByteStream&) = delete;
  ByteStream& operator=(const ByteStream&) = delete;

  //! Reads up to n bytes; fewer at the end of the data or where they are damaged.
  std::size_t read(void* to, std::size_t n);
  //! Throws InputError unless n bytes could be read. Says how far it is, and may be cancelled.
  void readAll(void* to, std::size_t n, const ReadProgress& progress = {});
  //! Passes over n bytes; throws InputError if there are not so many.
  void skip(std::uint64_t n, const ReadProgress& progress = {});
  //! Throws InputError if what is left breaks off or has a wrong checksum. Further data is fine, and read to
  //! its end: damaged data are often longer than they should be. `moreIsWanted`: it is looked at when it is
  //! read; here only whether the stream ends at this place, wrongly. Throws Cancelled.
  void checkEnd(bool moreIsWanted = false);

 private:
  struct State;
  std::size_t inflateSome(void* to, std::size_t n);
  std::unique_ptr<State> state_;
};

//! True if the file begins like a gzip file.
bool isGzip(const std::string& path);

}  // namespace handlebody
