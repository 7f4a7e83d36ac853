#pragma once
// Internal: values of GDCM's data sets, bounds checked. Only the DICOM sources include this.

#include <gdcmDataSet.h>
#include <gdcmSequenceOfItems.h>

#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/vec.h"

namespace handlebody::dicom {

//! The bytes of a value without the padding at its end; empty if there is none.
inline std::string text(const gdcm::DataSet& data, const gdcm::Tag& tag) {
  if (!data.FindDataElement(tag)) return {};
  const gdcm::ByteValue* value = data.GetDataElement(tag).GetByteValue();
  if (!value || value->GetLength() == 0) return {};
  std::string s(value->GetPointer(), value->GetLength());
  while (!s.empty() && (s.back() == ' ' || s.back() == '\0')) s.pop_back();
  return s.substr(std::min(s.size(), s.find_first_not_of(' ')));
}

//! A value of type T at place i (US, UL, FD …), native byte order as GDCM keeps it.
template <typename T>
std::optional<T> binary(const gdcm::DataSet& data, const gdcm::Tag& tag, std::size_t i = 0) {
  if (!data.FindDataElement(tag)) return std::nullopt;
  const gdcm::ByteValue* value = data.GetDataElement(tag).GetByteValue();
  if (!value || value->GetLength() < (i + 1) * sizeof(T)) return std::nullopt;
  T result;
  std::memcpy(&result, value->GetPointer() + i * sizeof(T), sizeof(T));
  return result;
}

//! The numbers of a text with backslashes, in the C locale whatever the program's is.
std::vector<double> numbers(const std::string& text);

//! The first number of a text value.
inline std::optional<double> number(const gdcm::DataSet& data, const gdcm::Tag& tag) {
  const std::vector<double> values = numbers(text(data, tag));
  return values.empty() ? std::nullopt : std::optional(values[0]);
}

inline std::optional<Vec3> vector(const gdcm::DataSet& data, const gdcm::Tag& tag) {
  const std::vector<double> v = numbers(text(data, tag));
  return v.size() == 3 ? std::optional(Vec3(v[0], v[1], v[2])) : std::nullopt;
}

//! The data set of item i of a sequence, or nullptr. The sequence must outlive it.
inline const gdcm::DataSet* item(const gdcm::SequenceOfItems* sequence, std::size_t i) {
  if (!sequence || i >= sequence->GetNumberOfItems()) return nullptr;
  return &sequence->GetItem(i + 1).GetNestedDataSet();
}

inline gdcm::SmartPointer<gdcm::SequenceOfItems> sequence(const gdcm::DataSet& data, const gdcm::Tag& tag) {
  if (!data.FindDataElement(tag)) return nullptr;
  return data.GetDataElement(tag).GetValueAsSQ();
}

}  // namespace handlebody::dicom
