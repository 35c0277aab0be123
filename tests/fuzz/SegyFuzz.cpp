#include "FuzzReader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static velum::io::FuzzFile file("a.sgy");
  return velum::io::fuzzVolume(file, velum::io::readSegy, data, size);
}
