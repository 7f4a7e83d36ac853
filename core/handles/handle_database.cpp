#include "core/handles/handle_database.h"

#include <algorithm>
#include <charconv>
#include <numeric>
#include <tuple>

#include "core/errors.h"

namespace handlebody {

extern const std::string_view kHandleDatabaseText;  // in a source made by the build

namespace {

constexpr std::string_view kHeader = "handlebody handles 1";
constexpr std::string_view kChecksum = "checksum ";
constexpr int kLargestOfTwo = 6;
constexpr int kLargestMonotone = 9;
constexpr int kLargestOfThree = 9;
constexpr int kLargestOfFour = 5;

//! 64-bit FNV-1a.
std::string checksum(std::string_view text) {
  std::uint64_t hash = 14695981039346656037ull;
  for (const char c : text) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 1099511628211ull;
  }
  std::string digits(16, '0');
  for (auto digit = digits.rbegin(); digit != digits.rend(); ++digit, hash >>= 4)
    *digit = "0123456789abcdef"[hash & 15];
  return digits;
}

[[noreturn]] void throwDamaged(const char* what) {
  throw InputError(std::string("The handle database is damaged: ") + what + ".");
}

//! Takes words and numbers off the front of a text.
class Words {
 public:
  explicit Words(std::string_view text) : rest_(text) {}
  bool atEnd() {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(" \n"), rest_.size()));
    return rest_.empty();
  }
  std::string_view word() {
    if (atEnd()) throwDamaged("it ends too early");
    const std::string_view out = rest_.substr(0, rest_.find_first_of(" \n"));
    rest_.remove_prefix(out.size());
    return out;
  }
  int number(int least, int most) {
    const std::string_view text = word();
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || value < least || value > most)
      throwDamaged("a number is out of range");
    return value;
  }

 private:
  std::string_view rest_;
};

Family familyOf(std::string_view name) {
  for (const Family family : {Family::balanced, Family::monotone, Family::all})
    if (name == familyName(family)) return family;
  throwDamaged("it has an unknown family");
}

//! The vertex next to each along its cap.
std::vector<int> nextVertices(std::span<const int> sizes) {
  std::vector<int> next;
  for (const int size : sizes) {
    const int first = static_cast<int>(next.size());
    for (int i = 0; i < size; ++i) next.push_back(first + (i + 1) % size);
  }
  return next;
}

Handle readHandle(Words& words, std::span<const int> sizes) {
  const std::vector<int> next = nextVertices(sizes);
  const int m = static_cast<int>(next.size());
  Handle handle;
  for (int v = 0; v < m; ++v) handle.push_back({v, next[v], words.number(0, m - 1)});
  for (std::size_t i = 0; i < 2 * sizes.size() - 4; ++i) {
    const int a = words.number(0, m - 1);
    const int b = words.number(0, m - 1);
    handle.push_back({a, b, words.number(0, m - 1)});
  }
  for (Triangle& f : handle) std::rotate(f.begin(), std::min_element(f.begin(), f.end()), f.end());
  std::sort(handle.begin(), handle.end());
  return handle;
}

StoredHandles readEntry(Words& words) {
  StoredHandles entry;
  entry.family = familyOf(words.word());
  const int caps = words.number(2, 4);
  for (int i = 0; i < caps; ++i) entry.sizes.push_back(words.number(3, 1000));
  entry.handles = static_cast<std::uint64_t>(words.number(0, static_cast<int>(kMaxListedHandles)));
  const int generators = words.number(0, static_cast<int>(kMaxListedHandles));
  for (int i = 0; i < generators; ++i) entry.generators.push_back(readHandle(words, entry.sizes));
  return entry;
}

auto keyOf(const StoredHandles& entry) { return std::tie(entry.family, entry.sizes); }

std::string textOf(const Handle& handle, std::span<const int> sizes) {
  const std::vector<int> next = nextVertices(sizes);
  std::vector<int> apexes(next.size(), -1);
  std::string typeTwo;
  for (const Triangle& f : handle) {
    bool isTypeTwo = true;
    for (std::size_t i = 0; i < 3; ++i) {
      if (next[f[i]] != f[(i + 1) % 3]) continue;
      apexes[f[i]] = f[(i + 2) % 3];
      isTypeTwo = false;
    }
    for (const int v : f)
      if (isTypeTwo) typeTwo += ' ' + std::to_string(v);
  }
  std::string out;
  for (const int apex : apexes) out += (out.empty() ? "" : " ") + std::to_string(apex);
  return out + typeTwo + '\n';
}

std::string makeEntry(const std::vector<int>& sizes, Family family) {
  const std::vector<Handle> handles = enumerateHandles(sizes, family);
  if (handles.empty()) return {};
  const std::vector<Handle> generators = generatorsOf(sizes, handles);
  std::string out = std::string(familyName(family)) + ' ' + std::to_string(sizes.size());
  for (const int size : sizes) out += ' ' + std::to_string(size);
  out += ' ' + std::to_string(handles.size()) + ' ' + std::to_string(generators.size()) + '\n';
  for (const Handle& generator : generators) out += textOf(generator, sizes);
  return out;
}

//! All ascending sequences of `caps` sizes from 3 to `largest`.
std::vector<std::vector<int>> allSizes(std::size_t caps, int largest) {
  std::vector<std::vector<int>> out;
  std::vector<int> sizes(caps, 3);
  for (;;) {
    out.push_back(sizes);
    std::size_t i = caps;
    while (i > 0 && sizes[i - 1] == largest) --i;
    if (i == 0) return out;
    std::fill(sizes.begin() + static_cast<std::ptrdiff_t>(i) - 1, sizes.end(), sizes[i - 1] + 1);
  }
}

}  // namespace

const char* familyName(Family family) {
  return family == Family::balanced ? "balanced" : family == Family::monotone ? "monotone" : "all";
}

std::string_view handleDatabaseText() { return kHandleDatabaseText; }

const HandleDatabase& HandleDatabase::stored() {
  static const HandleDatabase database(handleDatabaseText());
  return database;
}

HandleDatabase::HandleDatabase(std::string_view text) {
  const std::size_t end = text.rfind(kChecksum);
  if (text.substr(0, kHeader.size()) != kHeader) throwDamaged("it does not begin as one");
  if (end == std::string_view::npos) throwDamaged("its checksum is missing");
  if (Words(text.substr(end + kChecksum.size())).word() != checksum(text.substr(0, end)))
    throwDamaged("its checksum is wrong");
  Words words(text.substr(kHeader.size(), end - kHeader.size()));
  while (!words.atEnd()) entries_.push_back(readEntry(words));
  std::sort(entries_.begin(), entries_.end(),
            [](const StoredHandles& a, const StoredHandles& b) { return keyOf(a) < keyOf(b); });
}

const StoredHandles* HandleDatabase::find(std::span<const int> sizes, Family family) const {
  std::vector<int> ascending(sizes.begin(), sizes.end());
  std::sort(ascending.begin(), ascending.end());
  const auto at =
      std::lower_bound(entries_.begin(), entries_.end(), std::tie(family, ascending),
                       [](const StoredHandles& entry, const auto& key) { return keyOf(entry) < key; });
  return at != entries_.end() && keyOf(*at) == std::tie(family, ascending) ? &*at : nullptr;
}

std::vector<Handle> expand(const StoredHandles& entry) {
  std::vector<Handle> out;
  for (const Handle& generator : entry.generators) {
    const std::vector<Handle> orbit = orbitOf(entry.sizes, generator);
    out.insert(out.end(), orbit.begin(), orbit.end());
  }
  std::sort(out.begin(), out.end());
  return out;
}

std::string makeHandleDatabase() {
  std::string text = std::string(kHeader) + '\n';
  for (const auto& sizes : allSizes(2, kLargestMonotone)) text += makeEntry(sizes, Family::monotone);
  for (const auto& sizes : allSizes(3, kLargestOfThree)) text += makeEntry(sizes, Family::balanced);
  for (const auto& sizes : allSizes(4, kLargestOfFour)) text += makeEntry(sizes, Family::balanced);
  for (const auto& sizes : allSizes(2, kLargestOfTwo)) text += makeEntry(sizes, Family::all);
  text += makeEntry({3, 3, 3}, Family::all);
  return text + std::string(kChecksum) + checksum(text) + '\n';
}

}  // namespace handlebody
