#pragma once
// What is to be told a person, as a kind with numbers: a warning about a result, a refusal, the reason of an
// event. Code looks at the kind and the numbers; the words are in finding_words.cpp (English, for reports and
// the command line) and in the window (translated), and nothing reads them.

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
//! {choices} the same with "; ". No capital letter and no full stop unless it is a whole sentence.
const char* findingText(FindingKind kind);

//! The text with its values filled in by `written`, which is given name, value and FORMAT ("" for none), and
//! {cause} and lists by `told`. What is no value of the finding stays as it is.
using ValueWriter =
    std::function<std::string(std::string_view name, const FindingValue&, std::string_view format)>;
using CauseWriter = std::function<std::string(const Finding& cause)>;
std::string filled(std::string_view text, const Finding& finding, const ValueWriter& written,
                   const CauseWriter& told);

//! In English.
std::string sentence(const Finding& finding);
std::string sentence(const std::vector<Finding>& findings);  //!< with "; " between
std::vector<std::string> sentences(const std::vector<Finding>& findings);

}  // namespace handlebody
