#pragma once
#include <fmt/format.h>
#include <gdcmDataSet.h>
#include <gdcmItem.h>
#include <gdcmSequenceOfItems.h>

#include <cstdint>
#include <glm/glm.hpp>
#include <initializer_list>
#include <string>

/// Functions that put elements into a GDCM data set. Only the DICOM writers include this header.
namespace velum::io {

inline void put(gdcm::DataSet& set, gdcm::Tag tag, gdcm::VR vr, const void* bytes, std::size_t count) {
  gdcm::DataElement element(tag);
  element.SetVR(vr);
  element.SetByteValue(static_cast<const char*>(bytes), std::uint32_t(count));
  set.Replace(element);
}

inline void putText(gdcm::DataSet& set, gdcm::Tag tag, gdcm::VR vr, std::string text) {
  if (text.size() % 2) text += vr == gdcm::VR::UI ? '\0' : ' ';
  put(set, tag, vr, text.data(), text.size());
}

/// Puts binary values in the machine's byte order: the writer is little-endian, and so are the machines that we run on.
template <class T>
inline void putNumbers(gdcm::DataSet& set, gdcm::Tag tag, gdcm::VR vr, std::initializer_list<T> values) {
  put(set, tag, vr, values.begin(), values.size() * sizeof(T));
}

inline void putWord(gdcm::DataSet& set, gdcm::Tag tag, int value) {
  putNumbers(set, tag, gdcm::VR::US, {std::uint16_t(value)});
}

/// A number as a DICOM decimal string, which has 16 characters at most.
inline std::string decimal(double value) {
  for (int digits = 15; digits > 1; --digits)
    if (std::string text = fmt::format("{:.{}g}", value, digits); text.size() <= 16) return text;
  return "0";
}

inline std::string decimals(const glm::dvec3& v) { return decimal(v.x) + "\\" + decimal(v.y) + "\\" + decimal(v.z); }

class Sequence {
 public:
  Sequence() : mItems(gdcm::SequenceOfItems::New()) { mItems->SetLengthToUndefined(); }
  void add(const gdcm::DataSet& set) {
    gdcm::Item item;
    item.SetNestedDataSet(set);
    item.SetVLToUndefined();
    mItems->AddItem(item);
  }
  void putInto(gdcm::DataSet& set, gdcm::Tag tag) const {
    gdcm::DataElement element(tag);
    element.SetVR(gdcm::VR::SQ);
    element.SetValue(*mItems);
    element.SetVLToUndefined();
    set.Replace(element);
  }

 private:
  gdcm::SmartPointer<gdcm::SequenceOfItems> mItems;
};

inline void putItem(gdcm::DataSet& set, gdcm::Tag tag, const gdcm::DataSet& item) {
  Sequence sequence;
  sequence.add(item);
  sequence.putInto(set, tag);
}

}  // namespace velum::io
