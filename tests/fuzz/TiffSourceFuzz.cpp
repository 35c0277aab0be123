#include "FuzzSource.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static velum::io::FuzzFile file("b.tif");
  return velum::io::fuzzSource(file, data, size);
}
