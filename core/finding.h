#pragma once
// What is to be told a person, as a kind with numbers: a warning about a result, a refusal, the reason of an
// event. Code looks at the kind and the numbers; the words are in finding_words.cpp (English, for reports,
// the command line and Python) and in the window (translated), and nothing reads them. Where they name an
// option they say which, and how it is written is said by who tells them.

#include <array>
#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "core/finding_kind.h"

namespace handlebody {

//! A number, a place (mm, LPS) or the name of something.
class FindingValue : public std::variant<double, std::array<double, 3>, std::string> {
 public:
  // NOLINTBEGIN(google-explicit-constructor): values are listed as they are
  template <typename Number, typename = std::enable_if_t<std::is_arithmetic_v<Number>>>
  FindingValue(Number n) : variant(static_cast<double>(n)) {}
  FindingValue(const std::array<double, 3>& place) : variant(place) {}
  FindingValue(std::string name) : variant(std::move(name)) {}
  // NOLINTEND(google-explicit-constructor)
};

struct Finding {
  using Values = std::vector<std::pair<std::string_view, FindingValue>>;

  FindingKind kind = FindingKind::none;
  Values values{};                //!< the names are literals
  std::vector<Finding> causes{};  //!< one, or the entries of a list

  Finding() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): a kind alone is a finding
  Finding(FindingKind k, Values v = {}) : kind(k), values(std::move(v)) {}
  Finding(FindingKind k, Values v, Finding cause) : kind(k), values(std::move(v)), causes{std::move(cause)} {}
  Finding(FindingKind k, Values v, std::vector<Finding> list)
      : kind(k), values(std::move(v)), causes(std::move(list)) {}

  bool any() const { return kind != FindingKind::none; }
  //! Null if there is none of that name.
  const FindingValue* find(std::string_view name) const;
  //! Precondition: there is a number of that name.
  double number(std::string_view name) const;
};

//! For places: anything with three coordinates.
template <typename V>
std::array<double, 3> placeValue(const V& v) {
  return {v[0], v[1], v[2]};
}

//! "held-at-neck": what reports and programs go by. Never changes.
const char* findingName(FindingKind kind);

//! The English words, with {name} or {name:FORMAT} where a value goes; FORMAT is the digits and f or g as for
//! printf. {cause} is the words of what caused it, {list} those of all its entries with ", " between,
//! {choices} the same with "; ", and {option:edge-length} that option. No capital letter and no full stop
//! unless it is a whole sentence.
const char* findingText(FindingKind kind);

//! How the option "edge-length" is written where a sentence is told.
using OptionSpelling = std::string (*)(std::string_view option);
//! "--edge-length": on the command line, and with it in reports and in the messages of errors.
std::string dashed(std::string_view option);

//! The text with its values filled in by `written`, which is given name, value and FORMAT ("" for none),
//! {cause} and lists by `told`, and options by `spelled`. What is no value of the finding stays as it is.
using ValueWriter =
    std::function<std::string(std::string_view name, const FindingValue&, std::string_view format)>;
using CauseWriter = std::function<std::string(const Finding& cause)>;
std::string filled(std::string_view text, const Finding& finding, const ValueWriter& written,
                   const CauseWriter& told, OptionSpelling spelled);

//! In English, with options as they are `dashed` or as told.
std::string sentence(const Finding& finding);
std::string sentence(const Finding& finding, OptionSpelling spelled);
std::string sentence(const std::vector<Finding>& findings);  //!< with "; " between
std::vector<std::string> sentences(const std::vector<Finding>& findings);
std::vector<std::string> sentences(const std::vector<Finding>& findings, OptionSpelling spelled);

}  // namespace handlebody
