#include "FuzzHdf5.h"
#include "FuzzStore.h"
#include "io/stores/BdvImage.h"
#include "io/stores/ImarisImage.h"

namespace velum::io {

/// Metadata of all images, and voxels of the small ones, as Imaris and as BigDataViewer lay them out.
inline void readAll(const std::shared_ptr<const FuzzHdf5>& file) {
  if (isBdv(*file)) {
    auto voxels = bdvInHdf5(file);
    BdvImages images(voxels->describe(), voxels, false);
    for (const StoreImage& image : images.list()) readSmall(ArraySource(images.read(image.key)));
  }
  for (const StoreImage& image : listImarisImages(*file)) readSmall(ArraySource(readImarisImage(file, image.key)));
}

}  // namespace velum::io

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace velum::io;
  try {
    readAll(std::make_shared<const FuzzHdf5>(data, size));
  } catch (const velum::Error& error) {
    expectOneLine(error);
  }
  return 0;
}
