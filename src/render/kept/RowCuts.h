#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "render/upload/CutSheets.h"
#include "render/upload/SpareTable.h"
#include "scene/SceneFwd.h"
#include "scene/SectionPlane.h"
#include "shared/cuts.h"

namespace velum::render {

/// Tells, row by row, which pixels of a section the cuts of a scene remove. Any thread.
class RowCuts {
 public:
  RowCuts(const scene::Scene& scene, const scene::SectionPlane& plane, const SheetIndices& sheets);
  bool isEmpty() const { return mCuts.empty(); }
  /// 1 for each pixel of a row that the cuts remove, else 0. Pixels within half a voxel of a sheet are not removed: on
  /// a section that lies in the sheet's own plane, or nearly, they would be removed in meaningless bands.
  /// @param ids  structure of each pixel; empty: no labels are shown
  std::vector<char> removedOf(int y, int width, std::span<const std::uint16_t> ids) const;

  /// A row as a ray: the middle of pixel x is at start + x * lengthPerPixel * along, from the frame's centre.
  struct Row {
    glm::vec3 start, along;
    int width = 0;
    double lengthPerPixel = 1.0;
  };
  /// @param ease  distance from a sheet within which nothing is removed; world length
  std::vector<char> removedOf(const Row& row, std::span<const std::uint16_t> ids, double ease = 0.0) const;

  /// Marks the pixels of a row that one cut removes: markConvex() for a convex cut, markWalked() for any cut except a
  /// membrane.
  static void markConvex(const shared::CutData& cut, const Row& row, std::vector<char>& removed);
  static void markWalked(const shared::CutData& cut, const Row& row, std::vector<char>& removed);

 private:
  void markMembrane(const shared::CutData& cut, const Row& row, std::vector<char>& removed) const;
  bool isJoined(std::size_t cut) const;
  void keepNear(const shared::CutData& cut, Row row, double ease, std::vector<char>& removed) const;
  void takeBack(std::size_t cut, const Row& row, std::span<const std::uint16_t> ids, std::vector<char>& removed) const;

  const scene::SectionPlane& mFrame;
  CpuSheets mSheets;
  std::vector<shared::CutData> mCuts;
  SpareTable mSpares;
  double mHalfVoxel = 0.0;
};

}  // namespace velum::render
