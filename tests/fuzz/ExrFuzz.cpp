#include "FuzzPicture.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static velum::io::FuzzFile file("a.exr");
  return velum::io::fuzzPicture(file, data, size);
}
