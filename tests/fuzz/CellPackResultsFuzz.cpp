#include "FuzzModel.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static velum::io::FuzzFile file("a.cpr");
  return velum::io::fuzzModel(file, velum::io::readCellPackResults, data, size);
}
