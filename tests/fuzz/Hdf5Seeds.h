#pragma once
#include <map>
#include <string>

#include "../io/Hdf5Files.h"
#include "ZarrSeeds.h"

namespace velum::io {

inline std::string recordOf(const std::string& key, const std::string& bytes) {
  return char(key.size()) + key + bytesOfNumber(std::uint16_t(bytes.size())) + bytes;
}

/// A dataset of 3 x 4 x 5 samples in two chunks of 3 x 4 x 3, as Hdf5ImageFuzz takes it. @param filters  low bytes of
/// their numbers, 125 for 32000
inline std::string datasetRecords(const std::string& name, const std::string& filters) {
  std::string head = std::string(1, '\1') + char(filters.size()) + filters + "\3\4\5\3\4\3", samples;
  for (int i = 0; i < 36; ++i) samples += bytesOfNumber(std::uint16_t(i));
  for (char filter : filters) {
    if (filter == 1) samples = packedBy("zlib", samples, 1);
    if (filter == 2) samples = shuffled(samples, 2);
    if (std::uint8_t(filter) == 125 + 4) samples = packedByHdf5Lz4(samples, 40);
  }
  return recordOf(name, head) + recordOf(name + "#0.0.0", samples) + recordOf(name + "#0.0.1", samples);
}

/// Images of Imaris and BigDataViewer, packed in each way, by names.
inline std::map<std::string, std::string> hdf5Records() {
  std::map<std::string, std::string> all;
  const std::map<std::string, std::string> kFilters = {
      {"raw", ""}, {"gzip", "\1"}, {"shuffled", "\2\1"}, {"lz4", std::string(1, char(129))}};
  for (const auto& [name, filters] : kFilters) {
    std::string group = "DataSet/ResolutionLevel 0/TimePoint 0/Channel 0", info = "DataSetInfo/Image@";
    std::string imaris = recordOf(group + "@ImageSizeX", "4") + recordOf(group + "@ImageSizeY", "4") +
                         recordOf("DataSetInfo/Channel 0@Color", "1 0 0") +
                         recordOf("DataSetInfo/Channel 0@ColorRange", "0 255") + recordOf(info + "Unit", "um");
    for (char axis : std::string("012"))
      imaris += recordOf(info + "ExtMin" + axis, "0") + recordOf(info + "ExtMax" + axis, "9.5");
    all["imaris-" + name] = imaris + datasetRecords(group + "/Data", filters);
    all["bdv-" + name] = recordOf("s00/resolutions", "\1\1\1\2\2\1") + recordOf("s00@dataType", "uint16") +
                         datasetRecords("t00000/s00/0/cells", filters) + datasetRecords("t00000/s00/1/cells", filters);
  }
  return all;
}

}  // namespace velum::io
