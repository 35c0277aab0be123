#include "FuzzReader.h"
#include "io/meshes/MeshReaders.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static velum::io::FuzzFile file("a.ply");
  return velum::io::fuzzMesh(file, velum::io::readPly, data, size);
}
