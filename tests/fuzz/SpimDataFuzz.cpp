#include "FuzzReader.h"
#include "io/stores/SpimData.h"

/// The XML of BigDataViewer, beside a file a.h5.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace velum::io;
  static FuzzFile voxels("a.h5"), xml("a.xml");
  xml.hold(data, size);
  try {
    SpimData read = readSpimData(xml.path());
    require(!read.setups.empty() && !read.timePoints.empty());
  } catch (const velum::Error& error) {
    expectOneLine(error);
  }
  return 0;
}
