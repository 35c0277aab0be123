#pragma once
#include <gdcmImageWriter.h>
#include <gdcmTrace.h>
#include <gdcmUIDGenerator.h>
#include <gdcmWriter.h>

#include <filesystem>
#include <string>

#include "velum/core/Volume.h"

namespace velum {

/// Writes a volume of signed 16 bits (HU), whose axes are the patient's, as a CT series of one file a plane.
/// @return false when a file cannot be written
inline bool writeDicomSeries(const Volume& volume, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  gdcm::Trace::WarningOff();  // about the new image itself
  gdcm::UIDGenerator uids;
  std::string series = uids.Generate();
  glm::dvec3 mm = spacingOf(volume);
  std::size_t plane = std::size_t(volume.dims.x) * std::size_t(volume.dims.y) * 2;
  bool written = true;
  for (int z = 0; z < volume.dims.z; ++z) {
    gdcm::ImageWriter writer;
    gdcm::Image& image = writer.GetImage();
    image.SetNumberOfDimensions(2);
    unsigned int dims[2] = {unsigned(volume.dims.x), unsigned(volume.dims.y)};
    image.SetDimensions(dims);
    image.SetPixelFormat(gdcm::PixelFormat(1, 16, 16, 15, 1));
    image.SetPhotometricInterpretation(gdcm::PhotometricInterpretation::MONOCHROME2);
    image.SetTransferSyntax(gdcm::TransferSyntax::ExplicitVRLittleEndian);
    gdcm::DataElement data(gdcm::Tag(0x7fe0, 0x0010));
    data.SetByteValue(reinterpret_cast<const char*>(volume.voxels.data()) + plane * std::size_t(z),
                      std::uint32_t(plane));
    image.SetDataElement(data);
    image.SetSlope(volume.scale);
    image.SetIntercept(volume.offset);
    image.SetSpacing(0, mm.x);
    image.SetSpacing(1, mm.y);
    glm::dvec4 origin = volume.worldFromVoxel * glm::dvec4(0, 0, z, 1);
    for (int i = 0; i < 3; ++i) image.SetOrigin(unsigned(i), origin[i]);
    double axial[] = {1, 0, 0, 0, 1, 0};
    image.SetDirectionCosines(axial);
    auto put = [&](gdcm::Tag tag, gdcm::VR vr, std::string text) {
      if (text.size() % 2) text += vr == gdcm::VR::UI ? '\0' : ' ';
      gdcm::DataElement element(tag);
      element.SetVR(vr);
      element.SetByteValue(text.data(), std::uint32_t(text.size()));
      writer.GetFile().GetDataSet().Replace(element);
    };
    put(gdcm::Tag(0x0008, 0x0016), gdcm::VR::UI, "1.2.840.10008.5.1.4.1.1.2");
    put(gdcm::Tag(0x0008, 0x0018), gdcm::VR::UI, uids.Generate());
    put(gdcm::Tag(0x0008, 0x0060), gdcm::VR::CS, "CT");
    put(gdcm::Tag(0x0020, 0x000e), gdcm::VR::UI, series);
    writer.SetFileName((folder / ("section" + std::to_string(1000 + z) + ".dcm")).c_str());
    written = writer.Write() && written;
  }
  return written;
}

}  // namespace velum
