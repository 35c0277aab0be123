#pragma once
#include <gtest/gtest.h>

#include <map>

#include "GeneratedSource.h"
#include "io/labels/LabelBricks.h"

namespace velum::io {

inline constexpr std::uint64_t kFirst = 864691135000000001ull;  ///< doubles do not tell it from its neighbours

inline LabelBrickOptions carried() {
  LabelBrickOptions how;
  how.carriesIds = true;
  how.mostBytes = 1e12;
  return how;
}

/// Blobs of some sizes, of nothing, of ids of ours and of wide ones.
inline std::uint64_t blobs(glm::ivec3 p) {
  int cell = (p.x / 23 * 31 + p.y / 17 * 7 + p.z / 11 * 3) % 6;
  return cell == 0 ? 0 : cell == 1 ? 3 : cell == 2 ? 40000 : kFirst + std::uint64_t(cell) - 3;
}

/// By id of ours, the number in the file.
inline std::map<int, std::uint64_t> fileIds(const LabelVolume& labels) {
  std::map<int, std::uint64_t> ids;
  for (const LabelInfo& info : labels.table) ids[info.id] = info.fileId != 0 ? info.fileId : info.id;
  return ids;
}

/// Each voxel has the id of ours that stands for what a function gives there.
template <class Value>
void expectIds(const LabelVolume& labels, const Value& value) {
  auto ids = fileIds(labels);
  glm::ivec3 dims = labels.dims(), p;
  for (p.z = 0; p.z < dims.z; ++p.z)
    for (p.y = 0; p.y < dims.y; ++p.y)
      for (p.x = 0; p.x < dims.x; ++p.x) {
        int id = labels.at(p);
        ASSERT_EQ(id == 0            ? 0
                  : ids.contains(id) ? ids[id]
                                     : std::uint64_t(id),
                  value(p))
            << p.x << " " << p.y << " " << p.z;
      }
}

}  // namespace velum::io
