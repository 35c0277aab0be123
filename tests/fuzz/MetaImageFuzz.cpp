#include "FuzzReader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return velum::io::fuzzReader(velum::io::readMetaImage, data, size);
}
