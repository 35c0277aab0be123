#pragma once
#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/Task.h"
#include "io/volumes/DicomPet.h"
#include "io/volumes/DicomValues.h"

/// What the DICOM readers know of files before any pixel is decoded.
namespace velum::io {

/// One plane: a file of its own, or a frame of a multi-frame file.
struct DicomFrame {
  std::size_t file = 0;                       ///< Index of its file in the series.
  int index = 0;                              ///< Which frame of that file.
  bool hasPlace = false;                      ///< The file gives the frame's position and orientation.
  glm::dvec3 position{0.0};                   ///< Centre of the first voxel, mm, LPS.
  glm::dvec3 rowDirection{1.0, 0.0, 0.0};     ///< Along a row: with growing column index.
  glm::dvec3 columnDirection{0.0, 1.0, 0.0};  ///< Down a column: with growing row index.
  glm::dvec2 spacing{0.0};                    ///< mm between columns (x) and rows (y); 0 when unknown.
  double sliceSpacing = 0;                    ///< mm, as the file claims; 0 when unknown. The positions are the truth.
  double slope = 1, intercept = 0;
  std::string unit;  ///< Unit of its values, in words for people; empty when the file gives none.
  int instance = 0;
  int segment = 0;  ///< Segment number, in segmentations.
  /// Numbers by which frames at the same place differ: temporal position, trigger, acquisition, echo.
  std::vector<double> timeKey;
};

struct DicomFile {
  std::filesystem::path path;
  std::string seriesUid, instanceUid, description, modality, sopClass, photometric;
  std::string date;              ///< Date of the series, else of the study: "2024-03-15"; empty when unknown.
  std::string referencedSeries;  ///< For segmentations: UID of the segmented series; empty when unknown.
  int rows = 0, columns = 0, samplesPerPixel = 1, bitsAllocated = 0, bitsStored = 0;
  bool isSigned = false;
  bool isJpeg = false;         ///< Pixels are stored as some kind of JPEG, whose codecs know 16 bits at most.
  bool isFloat = false;        ///< Float or Double Float Pixel Data instead of Pixel Data.
  double timeStepSeconds = 0;  ///< Temporal resolution; 0 when unknown.
  std::string flaw;      ///< Why the file's pixels cannot be read, for people; empty when nothing is known to be wrong.
  DicomTable table;      ///< Modality LUT; used instead of slope and intercept where it has entries.
  DicomPalette palette;  ///< Has entries for PALETTE COLOR only.
  DicomPet pet;          ///< Filled for PET only.
  std::vector<std::string> warnings;
  std::vector<DicomFrame> frames;
  bool isSegmentation() const {
    return modality == "SEG" || sopClass == "1.2.840.10008.5.1.4.1.1.66.4" ||
           sopClass == "1.2.840.10008.5.1.4.1.1.66.7";
  }
  bool isRtStruct() const { return modality == "RTSTRUCT" || sopClass == "1.2.840.10008.5.1.4.1.1.481.3"; }
  /// The file holds structures, not values.
  bool holdsLabels() const { return isSegmentation() || isRtStruct(); }
  bool isDose() const { return modality == "RTDOSE" || sopClass == "1.2.840.10008.5.1.4.1.1.481.2"; }
  /// True when zero is white and the samples have no table and no unit, so that inverting them spoils no meaning.
  bool isToBeInverted() const {
    return photometric == "MONOCHROME1" && table.entries.empty() && !frames.empty() && frames[0].unit.empty();
  }
  /// True when samples are indices of colours in a palette.
  bool hasPalette() const { return photometric.find("PALETTE") != std::string::npos; }
  bool hasImage() const { return rows > 0 && columns > 0 && bitsAllocated > 0; }
};

/// Header of a DICOM file, without pixels; nothing when the file is no DICOM file or too damaged to read.
std::optional<DicomFile> readDicomHeader(const std::filesystem::path& path);
/// Whether files are searched in a folder alone or in all folders below it, too. Links to folders are not followed; at
/// most a hundred thousand files are looked at.
enum class Depth { Folder, AllBelow };
/// Headers of all images in a folder by path, each image once. @throw InputError, Cancelled
std::vector<DicomFile> scanDicomFolder(const std::filesystem::path& folder, Depth depth, Progress& progress);
/// True when the folder holds a DICOM image; stops at the first. @throw InputError, Cancelled
bool holdsDicom(const std::filesystem::path& folder, Depth depth, Progress& progress);
/// Headers of the segmentations and structure sets in a folder and all folders below it, provided that there is no
/// image among them; empty when there is one: the search stops at the first image. @throw InputError, Cancelled
std::vector<DicomFile> labelsWithoutImages(const std::filesystem::path& folder, Progress& progress);
/// True when the file is the index of a DICOM medium, "DICOMDIR".
bool isDicomIndex(const std::filesystem::path& path);
/// @throw InputError where an index lists files and none of them is there
void checkDicomIndex(const std::filesystem::path& path);
/// True when the file is a DICOM segmentation. Reads its header only; false for a file that is not DICOM.
bool isDicomSeg(const std::filesystem::path& path);
/// True when the file is a radiotherapy structure set; as isDicomSeg().
bool isRtStruct(const std::filesystem::path& path);

}  // namespace velum::io
