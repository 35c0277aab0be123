#include "render/upload/CutSheets.h"

#include "scene/Shown.h"
#include "shared/sheet.h"

namespace velum::render {

namespace {

membrane::SheetIndex indexOf(const scene::Cut& cut) {
  return membrane::makeSheetIndex(cut.membrane->shape, cut.membrane->cloth.particles, cut.size);
}

}  // namespace

std::vector<const scene::Cut*> membranesOf(const scene::Scene& scene) {
  std::vector<const scene::Cut*> membranes;
  for (const auto& cut : scene::enabledOf(scene.cuts))
    if (scene::isMembrane(cut)) membranes.push_back(&cut);
  return membranes;
}

const FrameSheet* liveSheet(const Frame& frame, const scene::Cut& cut) {
  auto found = frame.sheets.find(cut.id);
  if (found == frame.sheets.end()) return nullptr;
  const FrameSheet& live = found->second;
  return live.sheet && live.sheet->size() == cut.size ? &live : nullptr;
}

void CutSheets::prepare(const Frame& frame) {
  SheetSources sources;
  for (const scene::Cut* cut : membranesOf(frame.scene)) {
    if (const FrameSheet* live = liveSheet(frame, *cut))
      sources[cut->id].live = *live;
    else
      sources[cut->id] = {{}, cut->membrane->shape, cut->membrane->cloth.particles, cut->size};
  }
  if (sources == mSources && mRows) return;
  std::map<int, membrane::SheetIndex> indices;
  std::size_t total = 0;
  mPlans.clear();
  for (const scene::Cut* cut : membranesOf(frame.scene)) {
    const auto& live = sources[cut->id].live.sheet;
    if (!live) indices[cut->id] = indexOf(*cut);
    mPlans[cut->id] = {int(total), live ? live->particles() : indices[cut->id].particles, 0};
    total += live ? live->rowCount() : indices[cut->id].rows.size();
  }
  std::size_t bytes = std::max<std::size_t>(total, 1) * sizeof(glm::vec4);
  if (!mRows || mRows.bytes() != bytes) {
    mTexels = {};
    mRows = gpu::Buffer("sheets", bytes);
    mTexels = gpu::Texture::makeOfBuffer("sheets", gpu::Format::Rgba32f, mRows);
  }
  for (const auto& [id, source] : sources) {
    std::size_t offset = std::size_t(mPlans[id].x) * sizeof(glm::vec4);
    if (source.live.sheet)
      source.live.sheet->rows().copyTo(mRows, offset);
    else
      mRows.write(offset, indices[id].rows.size() * sizeof(glm::vec4), indices[id].rows.data());
  }
  mSources = std::move(sources);
}

void CutSheets::bind() const {
  if (mTexels) mTexels.bindSampler(shared::kSheetUnit);
}

CpuSheets makeCpuSheets(const scene::Scene& scene, const SheetIndices& sheets) {
  CpuSheets out;
  for (const scene::Cut* cut : membranesOf(scene)) {
    auto given = sheets.find(cut->id);
    bool isGiven = given != sheets.end() && given->second && given->second->size == cut->size;
    membrane::SheetIndex made = isGiven ? membrane::SheetIndex{} : indexOf(*cut);
    const membrane::SheetIndex& index = isGiven ? *given->second : made;
    out.plans[cut->id] = {int(out.rows.size()), index.particles, 0};
    out.rows.insert(out.rows.end(), index.rows.begin(), index.rows.end());
  }
  return out;
}

}  // namespace velum::render
