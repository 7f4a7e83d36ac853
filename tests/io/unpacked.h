#pragma once
// What is packed in a file, for a search through all of it.

#include <zlib.h>

#include <string>
#include <vector>

namespace handlebody::test {

//! The deflated data that begin at `at`; `bits` as zlib's windowBits. Nothing if they are none.
inline std::string inflated(const std::string& bytes, std::size_t at, int bits) {
  z_stream stream{};
  if (inflateInit2(&stream, bits) != Z_OK) return {};
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data() + at));
  stream.avail_in = static_cast<uInt>(bytes.size() - at);
  std::string all;
  std::vector<char> part(1 << 16);
  int state = Z_OK;
  while (state == Z_OK) {
    stream.next_out = reinterpret_cast<Bytef*>(part.data());
    stream.avail_out = static_cast<uInt>(part.size());
    state = inflate(&stream, Z_NO_FLUSH);
    all.append(part.data(), part.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  return all;
}

//! The base64 digits that begin at `at`.
inline std::string decoded(const std::string& text, std::size_t at) {
  static const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string all;
  unsigned bits = 0;
  int count = 0;
  for (; at < text.size(); ++at) {
    const std::size_t digit = digits.find(text[at]);
    if (digit == std::string::npos) break;
    bits = bits << 6 | static_cast<unsigned>(digit);
    if ((count += 6) < 8) continue;
    count -= 8;
    all += static_cast<char>(bits >> count & 255);
  }
  return all;
}

//! The file, and what is packed in it (gzip, the entries of a zip archive, data in a page or a scene).
inline std::string unpacked(const std::string& bytes) {
  std::string all = bytes;
  for (auto at = bytes.find("PK\3\4"); at != std::string::npos; at = bytes.find("PK\3\4", at + 4)) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[at + i]); };
    if (at + 30 < bytes.size())
      all += inflated(bytes, at + 30 + (byte(26) | byte(27) << 8) + (byte(28) | byte(29) << 8), -15);
  }
  for (auto at = bytes.find("\x1f\x8b\x08"); at != std::string::npos; at = bytes.find("\x1f\x8b\x08", at + 3))
    all += inflated(bytes, at, 31);
  for (auto at = bytes.find("base64,"); at != std::string::npos; at = bytes.find("base64,", at + 7))
    all += decoded(bytes, at + 7);
  return all;
}

}  // namespace handlebody::test
