#pragma once
// Errors that carry what is wrong as a finding, for those who need it in another language or decide by it:
// all of the engine's (tests/layering/told_errors.h). Apart from errors.h, whose types the programs throw
// with words alone, which name options.

#include <utility>

#include "core/errors.h"
#include "core/finding.h"

namespace handlebody {

class CarriesFinding {
 public:
  explicit CarriesFinding(Finding finding) : finding_(std::move(finding)) {}
  virtual ~CarriesFinding() = default;
  const Finding& finding() const { return finding_; }

 protected:
  CarriesFinding(const CarriesFinding&) = default;

 private:
  Finding finding_;
};

//! One of the errors of errors.h, caught as such; its message is the finding in English.
template <typename Error>
class Told : public Error, public CarriesFinding {
 public:
  explicit Told(const Finding& finding) : Error(sentence(finding)), CarriesFinding(finding) {}
  Told(const Finding& finding, const std::string& message) : Error(message), CarriesFinding(finding) {}
};

//! What the error is about; FindingKind::none where there is only its message (saidBy has that).
template <typename Error>
Finding findingOf(const Error& error) {
  const auto* told = dynamic_cast<const CarriesFinding*>(&error);
  return told ? told->finding() : Finding();
}

//! The same, with a message that has no kind yet as FindingKind::other.
template <typename Error>
Finding saidBy(const Error& error) {
  const Finding told = findingOf(error);
  return told.any() ? told : Finding(FindingKind::other, {{"text", std::string(error.what())}});
}

}  // namespace handlebody
