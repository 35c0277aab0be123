#include "FuzzReader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace velum;
  static io::FuzzFile file("a.dcm");
  file.hold(data, size);
  Progress progress;
  scene::Source source;
  source.path = file.path().string();
  try {
    LabelVolume labels = io::readDicomSeg(source, progress);
    io::require(labels.dims().x >= 1 && labels.dims().y >= 1 && labels.dims().z >= 1);
    io::require(glm::determinant(labels.worldFromVoxel()) != 0.0);
    for (auto id : labels.idsInUse())
      io::require(std::any_of(labels.table.begin(), labels.table.end(), [&](auto& l) { return l.id == id; }));
  } catch (const Error& error) {
    io::expectOneLine(error);
  }
  return 0;
}
