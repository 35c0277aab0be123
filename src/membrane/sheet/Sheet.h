#pragma once
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>

#include "gpu/Buffer.h"
#include "scene/SheetShape.h"

namespace velum::membrane {

/// A sheet on the GPU with what makes queries cheap, as shaders/shared/sheet.h lays it out. Its particles' places are
/// the first rows of rows(): a solver writes them there, calls gpu::barrier() and index(), and nothing is read back to
/// draw. GL thread, its destructor too.
class Sheet {
 public:
  /// Indexed, ready to be drawn. Parameters as of fitShape().
  Sheet(const scene::SheetShape& shape, glm::ivec2 flat, glm::dvec3 size);
  ~Sheet();
  Sheet(Sheet&&) noexcept;
  Sheet& operator=(Sheet&&) noexcept;

  /// Another shape, number of particles, or size of the rest plane; indexed.
  void setShape(const scene::SheetShape& shape, glm::ivec2 flat, glm::dvec3 size);
  /// Makes normals and cells anew from the places, on the GPU. Without it what shaders see is no sheet. The lists of
  /// the cells have room for four times as many entries as a sheet needs that hangs flat: see grow().
  void index();
  /// Makes room for a sheet that is stretched or folded beyond measure, and indexes it again. Waits for the GPU: for
  /// when a sheet has come to rest. @return false when there was room enough
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
  void makeBuffers();
  std::unique_ptr<Programs> mPrograms;
  glm::ivec2 mParticles{0};
  glm::dvec3 mSize{0.0};
  int mEntriesPerCell = 0;
  gpu::Buffer mRows, mCounts;
  std::uint64_t mRevision = 0;
};

}  // namespace velum::membrane
