#pragma once
#include <gdcmImageWriter.h>
#include <gdcmTrace.h>
#include <gdcmUIDGenerator.h>
#include <gdcmWriter.h>

#include <filesystem>
#include <functional>
#include <string>

#include "DicomParts.h"
#include "core/Volume.h"

namespace velum {

/// Writes a volume of signed 16 bits, whose axes are the patient's, as a series of one file a plane.
/// @param kind  of images: "CT", "PT"  @param more  puts in what this kind has besides
/// @return false when a file cannot be written
inline bool writeDicomSeries(const Volume& volume, const std::filesystem::path& folder, const std::string& kind = "CT",
                             const std::function<void(gdcm::DataSet&)>& more = {}) {
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
    gdcm::DataSet& set = writer.GetFile().GetDataSet();
    const char* sopClass = kind == "PT" ? "1.2.840.10008.5.1.4.1.1.128" : "1.2.840.10008.5.1.4.1.1.2";
    io::putText(set, gdcm::Tag(0x0008, 0x0016), gdcm::VR::UI, sopClass);
    io::putText(set, gdcm::Tag(0x0008, 0x0018), gdcm::VR::UI, uids.Generate());
    io::putText(set, gdcm::Tag(0x0008, 0x0060), gdcm::VR::CS, kind);
    io::putText(set, gdcm::Tag(0x0020, 0x000e), gdcm::VR::UI, series);
    if (more) more(set);
    writer.SetFileName((folder / ("section" + std::to_string(1000 + z) + ".dcm")).c_str());
    written = writer.Write() && written;
  }
  return written;
}

/// What a PET says of dose and time so that uptake values can be had: decay corrected to the scan's start, two
/// half-lives of an hour after the injection.
struct PetDose {
  double weightKg = 70, doseBq = 280e6;
  std::string units = "BQML";
  /// Bq/ml of an uptake value of 1.
  double activityOfOne() const { return 0.25 * doseBq / (weightKg * 1000); }
};

/// Writes a volume of signed 16 bits, whose scale makes Bq/ml of them, as a PET series. @param dose  weightKg 0: the
/// file does not say
inline bool writePetSeries(const Volume& volume, const std::filesystem::path& folder, const PetDose& dose = {}) {
  return writeDicomSeries(volume, folder, "PT", [&](gdcm::DataSet& set) {
    using gdcm::Tag;
    using gdcm::VR;
    io::putText(set, Tag(0x0054, 0x1001), VR::CS, dose.units);
    io::putText(set, Tag(0x0054, 0x1102), VR::CS, "START");
    io::putText(set, Tag(0x0028, 0x0051), VR::CS, "DECY\\ATTN\\SCAT");
    io::putText(set, Tag(0x0010, 0x1030), VR::DS, dose.weightKg > 0 ? std::to_string(dose.weightKg) : "");
    for (auto element : {0x0021, 0x0022}) io::putText(set, Tag(0x0008, std::uint16_t(element)), VR::DA, "20200301");
    for (auto element : {0x0031, 0x0032}) io::putText(set, Tag(0x0008, std::uint16_t(element)), VR::TM, "120000");
    gdcm::DataSet drug;
    io::putText(drug, Tag(0x0018, 0x1072), VR::TM, "100000");
    io::putText(drug, Tag(0x0018, 0x1074), VR::DS, std::to_string(std::int64_t(dose.doseBq)));
    io::putText(drug, Tag(0x0018, 0x1075), VR::DS, "3600");
    io::putSequence(set, Tag(0x0054, 0x0016), io::sequenceWith(drug));
  });
}

}  // namespace velum
