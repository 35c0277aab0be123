#pragma once
#include <gdcmDataSet.h>
#include <gdcmSequenceOfItems.h>

#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

#include "core/Text.h"

/// Functions that read values from a GDCM data set. Only the DICOM readers include this header.
namespace velum::io {

/// The text of an element without its padding; empty when the element is missing or empty.
inline std::string textOf(const gdcm::DataSet& set, gdcm::Tag tag) {
  if (!set.FindDataElement(tag)) return {};
  const gdcm::ByteValue* bytes = set.GetDataElement(tag).GetByteValue();
  if (!bytes || bytes->GetLength() == 0 || bytes->GetLength() > (1u << 20)) return {};
  std::string text(bytes->GetPointer(), bytes->GetLength());
  while (!text.empty() && (text.back() == ' ' || text.back() == '\0')) text.pop_back();
  text.erase(0, text.find_first_not_of(' '));
  return text;
}

/// The numbers of an element of decimal or integer strings, separated by backslashes. The list ends before the first
/// string that is not a number.
inline std::vector<double> numbersOf(const gdcm::DataSet& set, gdcm::Tag tag) {
  std::vector<double> numbers;
  std::string text = textOf(set, tag);
  for (std::string_view rest = text; auto value = takeNumber(rest);) {
    numbers.push_back(*value);
    rest = trimmed(rest);
    if (!rest.starts_with('\\')) break;
    rest.remove_prefix(1);
  }
  return numbers;
}

inline double numberOf(const gdcm::DataSet& set, gdcm::Tag tag, double otherwise) {
  auto numbers = numbersOf(set, tag);
  return numbers.empty() ? otherwise : numbers[0];
}

/// A binary value (US, UL, FD, ...); GDCM has put it into machine order.
template <class T>
T binaryOf(const gdcm::DataSet& set, gdcm::Tag tag, T otherwise) {
  if (!set.FindDataElement(tag)) return otherwise;
  const gdcm::ByteValue* bytes = set.GetDataElement(tag).GetByteValue();
  if (!bytes || bytes->GetLength() < sizeof(T)) return otherwise;
  T value;
  std::memcpy(&value, bytes->GetPointer(), sizeof(T));
  return value;
}

/// Binary values of 16 bits, in machine order.
inline std::vector<std::uint16_t> wordsOf(const gdcm::DataSet& set, gdcm::Tag tag) {
  const gdcm::ByteValue* bytes = set.FindDataElement(tag) ? set.GetDataElement(tag).GetByteValue() : nullptr;
  std::vector<std::uint16_t> words(bytes ? bytes->GetLength() / 2 : 0);
  if (!words.empty()) std::memcpy(words.data(), bytes->GetPointer(), words.size() * 2);
  return words;
}

inline gdcm::SmartPointer<gdcm::SequenceOfItems> sequenceOf(const gdcm::DataSet& set, gdcm::Tag tag) {
  if (!set.FindDataElement(tag)) return nullptr;
  return set.GetDataElement(tag).GetValueAsSQ();
}

/// The data set of a sequence's first item. A copy, as the sequence may have been parsed for this call only.
inline std::optional<gdcm::DataSet> firstItem(const gdcm::DataSet& set, gdcm::Tag tag) {
  auto sequence = sequenceOf(set, tag);
  if (!sequence || sequence->GetNumberOfItems() == 0) return std::nullopt;
  return sequence->GetItem(1).GetNestedDataSet();
}

}  // namespace velum::io
