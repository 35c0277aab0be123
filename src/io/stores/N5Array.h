#pragma once
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "io/read/JsonParts.h"
#include "io/stores/ChunkArray.h"
#include "io/stores/Codecs.h"
#include "io/stores/Store.h"

namespace velum::io {

/// A dataset of N5. Its axes, of which there are two to five, are x, y, z, channels, time.
class N5Array : public ChunkArray {
 public:
  /// @param attributes  those of the dataset @throw InputError, of what we cannot read by its name
  N5Array(std::shared_ptr<const Store> store, std::string key, const Json& attributes);
  std::optional<Chunk> read(const FiveSizes& index) const override;

 private:
  std::shared_ptr<const Store> mStore;
  std::string mKey;
  std::size_t mAxes = 3;
  std::vector<Codec> mCodecs;
};

/// The attributes of a group or a dataset; null where it has none. @throw InputError
Json n5Attributes(const Store& store, const std::string& key);
/// Whether these are the attributes of a dataset.
bool isN5Dataset(const Json& attributes);

/// The dataset of a key; null where there is none. @throw InputError
std::shared_ptr<const N5Array> openN5(std::shared_ptr<const Store> store, const std::string& key);

}  // namespace velum::io
