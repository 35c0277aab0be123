#include "FuzzReader.h"

/// The first bytes are the layout, the others the file.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace velum;
  if (size < 6) return 0;
  scene::RawLayout raw;
  raw.dims = {data[0], data[1], data[2]};
  raw.type = static_cast<SampleType>(data[3] % 8);
  raw.channels = data[4] % 6;
  raw.bigEndian = data[5] & 1;
  raw.headerBytes = data[5] >> 1;
  static io::FuzzFile file("a.raw");
  return io::fuzzVolume(file, io::readRaw, data + 6, size - 6, raw);
}
