#include "FuzzStore.h"
#include "io/stores/BdvImage.h"
#include "io/stores/N5Image.h"

namespace velum::io {

/// Metadata of all images, and voxels of the small ones, as N5 and as N5 of BigDataViewer.
inline void readAll(std::shared_ptr<const Store> store) {
  if (isBdv(*store)) {
    auto voxels = bdvInN5(store);
    BdvImages images(voxels->describe(), voxels, false);
    for (const StoreImage& image : images.list()) readSmall(ArraySource(images.read(image.key)));
  }
  for (const StoreImage& image : listN5Images(*store)) readSmall(ArraySource(readN5Image(store, image.key)));
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
