#include <cstdlib>
#include <set>
#include <sstream>
#include <tuple>

#include "core/Error.h"
#include "io/read/TiffPages.h"
#include "io/volumes/TiffDescription.h"

/// The same bytes as a description and as a whole TIFF. Planes that are placed must be on their own pages and places.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace velum::io;
  std::string bytes(reinterpret_cast<const char*>(data), size);
  auto layout = parseTiffDescription(bytes, "a.tif");
  for (std::uint64_t pages : {1u, 6u, 24u}) {
    std::set<std::tuple<std::uint64_t, std::uint64_t, std::uint64_t>> places;
    for (const auto& p : placePlanes(layout, layout.sizeC, pages)) {
      bool isInside = p.page < pages && p.z < layout.sizeZ && p.c < layout.sizeC && p.t < layout.sizeT;
      if (!isInside || !places.insert({p.z, p.c, p.t}).second) std::abort();
    }
  }
  try {
    std::istringstream file(bytes);
    if (scanTiff(file, "a.tif").pages.empty()) std::abort();
  } catch (const velum::Error&) {
  }
  return 0;
}
