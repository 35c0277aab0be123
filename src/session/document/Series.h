#pragma once
#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "core/Image.h"
#include "session/document/WorkFile.h"

/// The series of images in a folder as a hospital sends it, or the images in a store of chunks, and how one of them is
/// opened.
namespace velum::session {

/// Segments (labels) that go with a series.
struct SeriesLabels {
  std::string name;
  std::filesystem::path file;
  std::string key;  ///< in a store, which the file then is: scene::Source::series
};

/// A DICOM series of images, or an image in a store: its uid is scene::Source::series.
struct Series {
  std::string uid, description, modality;
  std::string date;  ///< "2024-03-15"; empty when unknown
  int imageCount = 0;
  glm::ivec2 size{0};                ///< columns, rows
  std::filesystem::path middleFile;  ///< the image half way through
  std::vector<SeriesLabels> labels;  ///< segmentations of this series, and segmentations that do not say to which
                                     ///< series they belong
};

/// True for folders, for a medium's index (DICOMDIR) and for stores, which may hold several series. The first bytes of
/// a file are read. Any thread.
bool mayHoldSeries(const std::filesystem::path& path);

/// Series in a folder and all below it, or of a medium's index (DICOMDIR), the largest first; images in a store, in its
/// order, or its labels where there is nothing else; empty for anything else. Headers only. Any thread. @throw
/// InputError, Cancelled
std::vector<Series> seriesIn(const std::filesystem::path& path, Progress& progress);

/// The series' middle image in grey, from its dark to its light values. Any thread. @throw InputError, Cancelled
/// @param size  most pixels along the longer side
Image seriesPicture(const Series& series, int size, Progress& progress);

/// A volume of one section in grey, from its dark to its light values. @param size  as of seriesPicture()
Image planePicture(const Volume& section, int size);

/// Reads one series, with labels. @param path  what seriesIn() was given  @param labels  without a file: none. Throws
/// as readPaths().
Loaded readSeries(const std::string& path, const std::string& uid, const SeriesLabels& labels, Progress& progress,
                  const DataPolicy& policy);

}  // namespace velum::session
