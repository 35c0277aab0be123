#include "FuzzReader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static velum::io::FuzzFile file("a.mrc");
  return velum::io::fuzzVolume(file, velum::io::readMrc, data, size);
}
