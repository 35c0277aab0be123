#pragma once
#include <vector>

#include "Hdf5Seeds.h"
#include "N5Seeds.h"

namespace velum::io {

/// What a target begins with.
struct StoreSeed {
  std::string target, name, bytes;
};

/// Of all targets that read stores. @param root  a folder to work in
inline std::vector<StoreSeed> storeSeeds(const std::filesystem::path& root) {
  std::vector<StoreSeed> seeds;
  for (auto& [name, bytes] : storeRecords(root / "zarr-files")) seeds.push_back({"zarr", name, bytes});
  for (auto& [name, bytes] : n5Records(root / "n5-files")) seeds.push_back({"n5", name, bytes});
  for (auto& [name, bytes] : hdf5Records()) seeds.push_back({"hdf5-image", name, bytes});
  std::filesystem::path xml = root / "a.xml";
  writeSpimData(xml, "hdf5", "a.h5", "<channel>1</channel><tile>0</tile>",
                registration(0, 0, {"1 0 0 10 0 1 0 20 0 0 1 30", "0 -0.5 0 0 0.5 0 0 0 0 0 2 0"}));
  std::ifstream text(xml);
  seeds.push_back({"spim-data", "channels", {std::istreambuf_iterator<char>(text), {}}});
  std::filesystem::remove(xml);
  return seeds;
}

}  // namespace velum::io
