#include "membrane/sheet/Sheet.h"

#include <span>
#include <utility>
#include <vector>

#include "core/Vectors.h"
#include "gpu/Program.h"
#include "membrane/sheet/SheetIndex.h"
#include "shared/sheet.h"

namespace velum::membrane {

struct Sheet::Programs {
  gpu::Program normals{{"membrane/sheet_normals.comp"}}, count{{"membrane/sheet_count.comp"}},
      scan{{"membrane/sheet_scan.comp"}}, fill{{"membrane/sheet_fill.comp"}}, cells{{"membrane/sheet_cells.comp"}};
};

Sheet::Sheet(const scene::SheetShape& shape, glm::ivec2 flat, glm::dvec3 size)
    : mPrograms(std::make_unique<Programs>()), mEntriesPerCell(shared::kSheetEntriesPerCell) {
  setShape(shape, flat, size);
}
Sheet::~Sheet() = default;
Sheet::Sheet(Sheet&&) noexcept = default;
Sheet& Sheet::operator=(Sheet&&) noexcept = default;

std::size_t Sheet::rowCount() const { return mRows.bytes() / sizeof(glm::vec4); }

/// Where there is no memory for both the sheet stays as it is.
void Sheet::makeBuffers(glm::ivec2 particles, int entriesPerCell) {
  std::size_t count = std::size_t(particles.x) * std::size_t(particles.y);
  std::size_t rowCount = fixedRows(particles) + (count * std::size_t(entriesPerCell) + 3) / 4;
  gpu::Buffer rows("sheet", rowCount * sizeof(glm::vec4)), counts("sheet counts", (count + 1) * sizeof(std::uint32_t));
  mRows = std::move(rows);
  mCounts = std::move(counts);
  mRows.clear();
  mParticles = particles;
  mEntriesPerCell = entriesPerCell;
}

void Sheet::setShape(const scene::SheetShape& shape, glm::ivec2 flat, glm::dvec3 size) {
  scene::SheetShape fitted = fitShape(shape, flat, size);
  bool fits = mRows && fitted.particles == mParticles;
  if (!fits) makeBuffers(fitted.particles, mEntriesPerCell);
  mSize = size;
  std::vector<glm::vec4> places(fitted.places.size());
  for (std::size_t v = 0; v < places.size(); ++v) places[v] = glm::vec4(fitted.places[v], 0.0f);
  mRows.write(0, places.size() * sizeof(places[0]), places.data());
  index();
}

void Sheet::index() {
  int count = mParticles.x * mParticles.y;
  glm::ivec4 particles(mParticles, count * mEntriesPerCell, 0);
  glm::vec4 half(glm::vec3(solidEdges(mSize) * 0.5), 0.0f);
  mRows.bindStorage(shared::kSheetBinding);
  mRows.bindStorage(shared::kSheetValuesBinding);
  mCounts.bindStorage(shared::kSheetCountsBinding);
  int groups = (count + shared::kSheetGroup - 1) / shared::kSheetGroup;
  auto run = [&](const gpu::Program& program, int groupCount) {
    program.set(0, particles);
    program.set(1, half);
    gpu::dispatch(program, {groupCount, 1, 1});
    gpu::barrier();
  };
  run(mPrograms->normals, groups);
  run(mPrograms->count, groups);
  run(mPrograms->scan, 1);
  run(mPrograms->fill, groups);
  run(mPrograms->cells, groups);
  ++mRevision;
}

bool Sheet::grow() {
  std::size_t count = std::size_t(mParticles.x) * std::size_t(mParticles.y);
  bool grew = false;
  for (std::uint32_t isFull = 0;; grew = true) {
    mCounts.read(count * sizeof(isFull), sizeof(isFull), &isFull);
    if (!isFull) return grew;
    std::vector<glm::vec4> places(count);
    mRows.read(0, count * sizeof(places[0]), places.data());
    makeBuffers(mParticles, 2 * mEntriesPerCell);
    mRows.write(0, count * sizeof(places[0]), places.data());
    index();
  }
}

scene::SheetShape Sheet::shape() const {
  scene::SheetShape shape{mParticles, {}};
  std::vector<glm::vec4> places(std::size_t(mParticles.x) * std::size_t(mParticles.y));
  mRows.read(0, places.size() * sizeof(places[0]), places.data());
  shape.places.assign(places.begin(), places.end());
  return shape;
}

}  // namespace velum::membrane
