#pragma once
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>

#include "gpu/Buffer.h"
#include "scene/SheetShape.h"

namespace velum::membrane {

/// A sheet on the GPU with an index that makes queries cheap, laid out as in shaders/shared/sheet.h. Its particles'
/// places are the first rows of rows(): a solver writes the places there, then calls gpu::barrier() and index();
/// nothing has to be read back for drawing. GL thread, also for the destructor.
class Sheet {
 public:
  /// Makes a sheet that is indexed and ready to be drawn. Parameters as in fitShape().
  Sheet(const scene::SheetShape& shape, glm::ivec2 flat, glm::dvec3 size);
  ~Sheet();
  Sheet(Sheet&&) noexcept;
  Sheet& operator=(Sheet&&) noexcept;

  /// Gives the sheet another shape, number of particles or size of the rest plane, and indexes it.
  void setShape(const scene::SheetShape& shape, glm::ivec2 flat, glm::dvec3 size);
  /// Makes normals and cells anew from the places, on the GPU; must be called after the places have changed, or shaders
  /// see no valid sheet. The lists of the cells have room for four times as many entries as a flat sheet needs: see
  /// grow().
  void index();
  /// Makes more room in the lists where the sheet is stretched or folded so much that it needs more, and indexes it
  /// again. Waits for the GPU: to be called when a sheet has come to rest. @return false when there was room enough
  bool grow();

  glm::ivec2 particles() const { return mParticles; }
  glm::dvec3 size() const { return mSize; }
  /// [rowCount] vec4: places, normals, cells, lists.
  const gpu::Buffer& rows() const { return mRows; }
  gpu::Buffer& rows() { return mRows; }
  std::size_t rowCount() const;
  /// Changes with every index(), so that frames that show the sheet differ.
  std::uint64_t revision() const { return mRevision; }
  /// Reads the places back. Waits for the GPU.
  scene::SheetShape shape() const;

 private:
  struct Programs;
  void makeBuffers(glm::ivec2 particles, int entriesPerCell);
  std::unique_ptr<Programs> mPrograms;
  glm::ivec2 mParticles{0};
  glm::dvec3 mSize{0.0};
  int mEntriesPerCell = 0;
  gpu::Buffer mRows, mCounts;
  std::uint64_t mRevision = 0;
};

}  // namespace velum::membrane
