#include "FuzzDrawing.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static velum::io::FuzzFile file("a.pdf");
  return velum::io::fuzzDrawing(file, data, size);
}
