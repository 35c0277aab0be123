#pragma once
#include <map>
#include <string>

#include "../io/N5Files.h"
#include "ZarrSeeds.h"

namespace velum::io {

/// A pyramid packed by each codec, and views of BigDataViewer, by names. @param folder  to work in, removed at the end
inline std::map<std::string, std::string> n5Records(const std::filesystem::path& folder) {
  std::map<std::string, std::string> all;
  for (const char* codec : {"raw", "gzip", "bzip2", "xz", "lz4", "blosc", "zstd"}) {
    std::filesystem::remove_all(folder);
    N5File file = n5Ramp(folder / "s0");
    file.codec = codec;
    file.tellsCount = codec[0] == 'l';
    file.write();
    file.folder = folder / "s1";
    file.shape = {3, 3, 5};
    file.more = {{"downsamplingFactors", {2, 2, 1}}};
    file.write();
    writeBytes(folder / "attributes.json", R"({"n5":"4.0.0","pixelResolution":{"unit":"um","dimensions":[1,1,2]}})");
    all[codec] = recordsOf(folder);
  }
  std::filesystem::remove_all(folder);
  n5Ramp(folder / "setup0/timepoint0/s0").write();
  writeBytes(folder / "setup0/attributes.json", R"({"downsamplingFactors":[[1,1,1]],"dataType":"uint16"})");
  all["bdv"] = recordsOf(folder);
  std::filesystem::remove_all(folder);
  return all;
}

}  // namespace velum::io
