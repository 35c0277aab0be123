#include "FuzzStore.h"
#include "io/stores/ZarrSource.h"

namespace velum::io {

/// Metadata of all images, and voxels of the small ones.
inline void readAll(std::shared_ptr<const Store> store) {
  for (const StoreImage& image : listImages(*store))
    if (auto read = readOmeImage(*store, image.key)) readSmall(ZarrSource(store, *read, {}));
}

}  // namespace velum::io

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace velum::io;
  try {
    readAll(std::make_shared<FuzzStore>(data, size));
  } catch (const velum::Error& error) {
    expectOneLine(error);
  }
  return 0;
}
