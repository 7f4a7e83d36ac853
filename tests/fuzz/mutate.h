#pragma once
// Damages bytes in the ways that files are damaged, and in those that parsers do not expect.

#include <random>
#include <string>

namespace handlebody::test {

//! One to a handful of changes: flipped bits, extreme numbers, pieces cut, doubled or moved, digits of texts.
inline std::string mutated(std::string bytes, std::mt19937_64& random) {
  const auto below = [&](std::size_t n) { return n == 0 ? 0 : static_cast<std::size_t>(random() % n); };
  // Headers come first: most changes go there.
  const auto place = [&] {
    return below(3) ? below(std::min<std::size_t>(bytes.size(), 700)) : below(bytes.size());
  };
  const auto overwrite = [&](std::uint64_t value, std::size_t size) {
    for (std::size_t i = 0, at = place(); i < size && at + i < bytes.size(); ++i)
      bytes[at + i] = static_cast<char>(value >> (8 * i));
  };
  static constexpr std::uint64_t kExtreme[] = {0,
                                               1,
                                               0x7f,
                                               0x80,
                                               0xff,
                                               0x7fff,
                                               0x8000,
                                               0xffff,
                                               0x7fffffff,
                                               0x80000000,
                                               0xffffffff,
                                               0x7fffffffffffffff,
                                               0xffffffffffffffff};
  static const char* const kNumbers[] = {"0",   "-1",  "99999999999", "4294967296", "1e308",
                                         "nan", "inf", "-0.0",        "1e-320",     ""};
  for (std::size_t change = 0, n = 1 + below(5); change < n && !bytes.empty(); ++change) switch (below(8)) {
      case 0:
        bytes[place()] ^= static_cast<char>(1 << below(8));
        break;
      case 1:
        overwrite(random(), 1);
        break;
      case 2:
        overwrite(kExtreme[below(std::size(kExtreme))], std::size_t{1} << below(4));
        break;
      case 3:
        bytes.erase(place(), 1 + below(40));
        break;
      case 4: {
        const std::size_t at = place();
        bytes.insert(place(), bytes.substr(at, 1 + below(60)));
        break;
      }
      case 5:
        if (below(4) == 0) bytes.resize(below(bytes.size() + 1));
        break;
      case 6: {
        const std::size_t digit = bytes.find_first_of("0123456789", place());
        if (digit == std::string::npos) break;
        const std::size_t end = bytes.find_first_not_of("0123456789.+-e", digit);
        bytes.replace(digit, std::min(end, bytes.size()) - digit, kNumbers[below(std::size(kNumbers))]);
        break;
      }
      default: {
        const std::size_t from = place(), to = place(), length = 1 + below(16);
        const std::string piece = bytes.substr(from, length);
        bytes.replace(to, std::min(length, bytes.size() - to), piece);
      }
    }
  return bytes;
}

}  // namespace handlebody::test
