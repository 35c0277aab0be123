#include <array>

#include "FuzzReader.h"

/// A set of files in one folder, one behind the other, each behind its size (4 bytes, the smallest first). The first is
/// opened; all are looked at.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace velum::io;
  static std::array<FuzzFile, 4> files{FuzzFile("0.dcm"), FuzzFile("1.dcm"), FuzzFile("2.dcm"), FuzzFile("3.dcm")};
  for (std::size_t i = 1; i < files.size(); ++i) files[i].hide();
  const std::uint8_t* first = data;
  std::size_t firstSize = 0;
  for (std::size_t i = 0; i < files.size() && size > 4; ++i) {
    std::size_t told = data[0] | std::size_t(data[1]) << 8 | std::size_t(data[2]) << 16 | std::size_t(data[3]) << 24;
    std::size_t count = std::min(told, size - 4);
    if (i == 0) first = data + 4, firstSize = count;
    if (i > 0) files[i].hold(data + 4, count);
    data += 4 + count, size -= 4 + count;
  }
  return fuzzVolume(files[0], readDicom, first, firstSize);
}
