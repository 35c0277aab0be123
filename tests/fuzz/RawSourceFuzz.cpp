#include "FuzzSource.h"

/// The bytes say which format it is.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static velum::io::FuzzFile file("b.nii");
  return velum::io::fuzzSource(file, data, size);
}
