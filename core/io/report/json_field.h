#pragma once
// A value of a session together with its place in it, which is told where the value is not what it must be:
// "requested.constraints.pins[2].radius". Only sources include this header, as json.h.
//
// Stricter than the library, which makes numbers of true and false, cuts 1.5 to 1 and wraps what does not
// fit. All of it throws Told<UsageError>.

#include <optional>
#include <string>
#include <vector>

#include "core/finding.h"
#include "core/io/report/json.h"

namespace handlebody {

class JsonField {
 public:
  //! Precondition: `root` outlives it and all that is read from it.
  explicit JsonField(const Json& root) : json_(&root) {}

  const Json& json() const { return *json_; }
  bool isNull() const { return json_->is_null(); }

  //! Of an object: null counts as there.
  bool has(const char* key) const { return json_->contains(key); }
  //! What is no object has none.
  JsonField at(const char* key) const;
  //! None where it is not there, or null.
  std::optional<JsonField> given(const char* key) const;
  //! The object has no other keys.
  void requireKeys(const std::vector<std::string>& known) const;

  //! Null is an empty one.
  std::vector<JsonField> list() const;
  std::vector<JsonField> list(std::size_t entries) const;

  double number() const;
  double numberAtLeast(double least) const;
  double numberAbove(double least) const;
  Vec3 point() const;
  //! Not of length 0.
  Vec3 direction() const;
  int whole() const;
  int wholeAtLeast(int least) const;
  int wholeWithin(int least, int most) const;
  bool flag() const;
  std::string text() const;
  //! `fromName`: a word → an optional, empty for one that is not known.
  template <typename FromName>
  auto word(FromName&& fromName) const {
    const auto value = fromName(text());
    if (!value) refuseWord();
    return *value;
  }

  //! The finding gets the field's place as its value "field" before `more`.
  [[noreturn]] void refuse(FindingKind kind, Finding::Values more = {}) const;
  [[noreturn]] void refuseWord() const;

 private:
  JsonField(const Json& json, std::string place) : json_(&json), place_(std::move(place)) {}
  std::string placeOf(const std::string& key) const { return place_.empty() ? key : place_ + "." + key; }
  [[noreturn]] void refuseValue(FindingKind kind, Finding::Values more = {}) const;

  const Json* json_;
  std::string place_;  //!< empty for the root
};

}  // namespace handlebody
