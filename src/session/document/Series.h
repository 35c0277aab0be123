#pragma once
#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "core/Image.h"
#include "session/document/WorkFile.h"

/// The series of images in a folder as a hospital sends it, and how one of them is opened.
namespace velum::session {

/// Segments (labels) that go with a series.
struct SeriesLabels {
  std::string name;
  std::filesystem::path file;
};

/// A DICOM series of images.
struct Series {
  std::string uid, description, modality;
  std::string date;  ///< "2024-03-15"; empty when unknown
  int imageCount = 0;
  glm::ivec2 size{0};                ///< columns, rows
  std::filesystem::path middleFile;  ///< the image half way through
  std::vector<SeriesLabels> labels;  ///< segmentations of this series, and segmentations that do not say to which
                                     ///< series they belong
};

/// Series in a folder and all below it, or of a medium's index (DICOMDIR), the largest first; empty for anything else.
/// Headers only. Any thread. @throw InputError, Cancelled
std::vector<Series> seriesIn(const std::filesystem::path& path, Progress& progress);

/// The series' middle image in grey, from its dark to its light values. Any thread. @throw InputError, Cancelled
/// @param size  most pixels along the longer side
Image seriesPicture(const Series& series, int size, Progress& progress);

/// A volume of one section in grey, from its dark to its light values. @param size  as of seriesPicture()
Image planePicture(const Volume& section, int size);

/// Reads one series, with labels. @param path  what seriesIn() was given  @param labels  empty: none. Throws as
/// readPaths().
Loaded readSeries(const std::string& path, const std::string& uid, const std::filesystem::path& labels,
                  Progress& progress, const DataPolicy& policy);

}  // namespace velum::session
