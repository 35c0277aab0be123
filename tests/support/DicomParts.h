#pragma once
#include <gdcmItem.h>
#include <gdcmSequenceOfItems.h>
#include <gdcmWriter.h>

#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <vector>

/// Elements of DICOM files that are put together by hand, for GDCM's writer of images would mend what tests want.
namespace velum::io {

inline void putText(gdcm::DataSet& set, gdcm::Tag tag, gdcm::VR vr, std::string text) {
  if (text.size() % 2) text += vr == gdcm::VR::UI ? '\0' : ' ';
  gdcm::DataElement element(tag);
  element.SetVR(vr);
  element.SetByteValue(text.data(), std::uint32_t(text.size()));
  set.Replace(element);
}

inline gdcm::SmartPointer<gdcm::SequenceOfItems> sequenceWith(const gdcm::DataSet& set) {
  auto sequence = gdcm::SequenceOfItems::New();
  gdcm::Item item;
  item.SetNestedDataSet(set);
  item.SetVLToUndefined();
  sequence->SetLengthToUndefined();
  sequence->AddItem(item);
  return sequence;
}

inline void putSequence(gdcm::DataSet& set, gdcm::Tag tag, gdcm::SmartPointer<gdcm::SequenceOfItems> sequence) {
  gdcm::DataElement element(tag);
  element.SetVR(gdcm::VR::SQ);
  element.SetValue(*sequence);
  element.SetVLToUndefined();
  set.Replace(element);
}

inline void putShort(gdcm::DataSet& set, gdcm::Tag tag, std::uint16_t value) {
  gdcm::DataElement element(tag);
  element.SetVR(gdcm::VR::US);
  element.SetByteValue(reinterpret_cast<const char*>(&value), 2);
  set.Replace(element);
}

/// Binary values of 16 bits.
inline void putWords(gdcm::DataSet& set, gdcm::Tag tag, gdcm::VR vr, const std::vector<std::uint16_t>& words) {
  gdcm::DataElement element(tag);
  element.SetVR(vr);
  element.SetByteValue(reinterpret_cast<const char*>(words.data()), std::uint32_t(words.size() * 2));
  set.Replace(element);
}

/// Functional groups of frames at the given places, downwards along x: rows run along y, columns along -z.
inline void putGroups(gdcm::DataSet& set, const std::vector<double>& places,
                      const std::vector<std::uint16_t>& segments = {}) {
  gdcm::DataSet shared, orientation, measures;
  putText(orientation, gdcm::Tag(0x0020, 0x0037), gdcm::VR::DS, "0\\1\\0\\0\\0\\-1");
  putText(measures, gdcm::Tag(0x0028, 0x0030), gdcm::VR::DS, "0.75\\0.5");
  putSequence(shared, gdcm::Tag(0x0020, 0x9116), sequenceWith(orientation));
  putSequence(shared, gdcm::Tag(0x0028, 0x9110), sequenceWith(measures));
  putSequence(set, gdcm::Tag(0x5200, 0x9229), sequenceWith(shared));
  auto perFrame = gdcm::SequenceOfItems::New();
  perFrame->SetLengthToUndefined();
  for (std::size_t i = 0; i < places.size(); ++i) {
    gdcm::DataSet frame, position, segment, rescale;
    putText(position, gdcm::Tag(0x0020, 0x0032), gdcm::VR::DS, std::to_string(places[i]) + "\\5\\6");
    putSequence(frame, gdcm::Tag(0x0020, 0x9113), sequenceWith(position));
    putText(rescale, gdcm::Tag(0x0028, 0x1052), gdcm::VR::DS, "-100");
    putText(rescale, gdcm::Tag(0x0028, 0x1053), gdcm::VR::DS, "1");
    if (segments.empty()) {
      putSequence(frame, gdcm::Tag(0x0028, 0x9145), sequenceWith(rescale));
    } else {
      putShort(segment, gdcm::Tag(0x0062, 0x000b), segments[i]);
      putSequence(frame, gdcm::Tag(0x0062, 0x000a), sequenceWith(segment));
    }
    gdcm::Item item;
    item.SetNestedDataSet(frame);
    item.SetVLToUndefined();
    perFrame->AddItem(item);
  }
  putSequence(set, gdcm::Tag(0x5200, 0x9230), perFrame);
}

/// An axial plane of voxels of 1 mm at (10, 20, z).
inline void putPlace(gdcm::DataSet& set, double z) {
  putText(set, gdcm::Tag(0x0020, 0x0032), gdcm::VR::DS, fmt::format("10\\20\\{}", z));
  putText(set, gdcm::Tag(0x0020, 0x0037), gdcm::VR::DS, "1\\0\\0\\0\\1\\0");
  putText(set, gdcm::Tag(0x0028, 0x0030), gdcm::VR::DS, "1\\1");
}

inline void putRescale(gdcm::DataSet& set, const std::string& slope, const std::string& intercept,
                       const std::string& type = "") {
  putText(set, gdcm::Tag(0x0028, 0x1053), gdcm::VR::DS, slope);
  putText(set, gdcm::Tag(0x0028, 0x1052), gdcm::VR::DS, intercept);
  if (!type.empty()) putText(set, gdcm::Tag(0x0028, 0x1054), gdcm::VR::LO, type);
}

/// What every image has; `pixels` and its kind are the caller's.
struct DicomImage {
  gdcm::DataSet set;  ///< Elements that win over those below.
  std::string sopClass = "1.2.840.10008.5.1.4.1.1.2", modality = "CT", series = "1.2.3.8";
  int columns = 4, rows = 2, frames = 1;
  int bits = 16, stored = 16;
  bool isSigned = false;
  std::string pixels;  ///< Little-endian.
  gdcm::TransferSyntax::TSType syntax = gdcm::TransferSyntax::ExplicitVRLittleEndian;
};

template <class T>
std::string pixelBytes(const std::vector<T>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(T)};
}

/// @return false when it cannot be written
inline bool writeDicom(const std::filesystem::path& path, const DicomImage& image) {
  gdcm::Writer writer;
  gdcm::DataSet set;
  static int number = 0;
  putText(set, gdcm::Tag(0x0008, 0x0016), gdcm::VR::UI, image.sopClass);
  putText(set, gdcm::Tag(0x0008, 0x0018), gdcm::VR::UI, "1.2.3.9." + std::to_string(++number));
  putText(set, gdcm::Tag(0x0008, 0x0060), gdcm::VR::CS, image.modality);
  putText(set, gdcm::Tag(0x0020, 0x000e), gdcm::VR::UI, image.series);
  putText(set, gdcm::Tag(0x0028, 0x0004), gdcm::VR::CS, "MONOCHROME2");
  if (image.frames > 1) putText(set, gdcm::Tag(0x0028, 0x0008), gdcm::VR::IS, std::to_string(image.frames));
  putShort(set, gdcm::Tag(0x0028, 0x0002), 1);
  putShort(set, gdcm::Tag(0x0028, 0x0010), std::uint16_t(image.rows));
  putShort(set, gdcm::Tag(0x0028, 0x0011), std::uint16_t(image.columns));
  putShort(set, gdcm::Tag(0x0028, 0x0100), std::uint16_t(image.bits));
  putShort(set, gdcm::Tag(0x0028, 0x0101), std::uint16_t(image.stored));
  putShort(set, gdcm::Tag(0x0028, 0x0102), std::uint16_t(image.stored - 1));
  putShort(set, gdcm::Tag(0x0028, 0x0103), image.isSigned ? 1 : 0);
  gdcm::DataElement data(gdcm::Tag(0x7fe0, 0x0010));
  data.SetVR(image.bits > 8 ? gdcm::VR::OW : gdcm::VR::OB);
  data.SetByteValue(image.pixels.data(), std::uint32_t(image.pixels.size()));
  set.Replace(data);
  for (const gdcm::DataElement& element : image.set.GetDES()) set.Replace(element);
  writer.GetFile().SetDataSet(set);
  writer.GetFile().GetHeader().SetDataSetTransferSyntax(image.syntax);
  writer.SetFileName(path.c_str());
  return writer.Write();
}

}  // namespace velum::io
