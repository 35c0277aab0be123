#pragma once
#include <cstdlib>
#include <filesystem>

namespace velum {

/// The project's folder, for tests that read its shaders, documents and golden pictures: where it was built, unless the
/// environment's VELUM_SOURCE_DIR says where it lies on this machine.
inline std::filesystem::path sourceFolder() {
  const char* folder = std::getenv("VELUM_SOURCE_DIR");
  return folder ? folder : VELUM_SOURCE_DIR;
}

}  // namespace velum
