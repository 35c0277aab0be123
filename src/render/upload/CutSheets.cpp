#include "CutSheets.h"

#include "shared/sheet.h"

namespace velum::render {

namespace {

membrane::SheetIndex indexOf(const scene::Cut& cut) {
  return membrane::makeSheetIndex(cut.membrane.shape, cut.membrane.cloth.particles, cut.sizeMm);
}

}  // namespace

std::vector<const scene::Cut*> membranesOf(const scene::Scene& scene) {
  std::vector<const scene::Cut*> membranes;
  for (const auto& cut : scene.cuts)
    if (cut.enabled && cut.shape == scene::CutShape::Membrane) membranes.push_back(&cut);
  return membranes;
}

const FrameSheet* liveSheet(const Frame& frame, std::size_t membrane, const scene::Cut& cut) {
  if (membrane >= frame.sheets.size()) return nullptr;
  const FrameSheet& live = frame.sheets[membrane];
  return live.sheet && live.sheet->sizeMm() == cut.sizeMm ? &live : nullptr;
}

void CutSheets::prepare(const Frame& frame) {
  auto membranes = membranesOf(frame.scene);
  std::vector<Source> sources(membranes.size());
  for (std::size_t i = 0; i < membranes.size(); ++i) {
    const scene::Cut& cut = *membranes[i];
    if (const FrameSheet* live = liveSheet(frame, i, cut))
      sources[i].live = *live;
    else
      sources[i] = {{}, cut.membrane.shape, cut.membrane.cloth.particles, cut.sizeMm};
  }
  if (sources == mSources && mRows) return;
  std::vector<membrane::SheetIndex> indices(sources.size());
  std::size_t total = 0;
  mPlans.clear();
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const auto& live = sources[i].live.sheet;
    if (!live) indices[i] = indexOf(*membranes[i]);
    mPlans.emplace_back(int(total), live ? live->particles() : indices[i].particles, 0);
    total += live ? live->rowCount() : indices[i].rows.size();
  }
  std::size_t bytes = std::max<std::size_t>(total, 1) * sizeof(glm::vec4);
  if (!mRows || mRows.bytes() != bytes) {
    mTexels = {};
    mRows = gpu::Buffer("sheets", bytes);
    mTexels = gpu::Texture::makeOfBuffer("sheets", gpu::Format::Rgba32f, mRows);
  }
  for (std::size_t i = 0; i < sources.size(); ++i) {
    std::size_t offset = std::size_t(mPlans[i].x) * sizeof(glm::vec4);
    if (sources[i].live.sheet)
      sources[i].live.sheet->rows().copyTo(mRows, offset);
    else
      mRows.write(offset, indices[i].rows.size() * sizeof(glm::vec4), indices[i].rows.data());
  }
  mSources = std::move(sources);
}

void CutSheets::bind() const {
  if (mTexels) mTexels.bindSampler(shared::kSheetUnit);
}

CpuSheets makeCpuSheets(const scene::Scene& scene,
                        std::span<const std::shared_ptr<const membrane::SheetIndex>> sheets) {
  CpuSheets out;
  auto membranes = membranesOf(scene);
  for (std::size_t i = 0; i < membranes.size(); ++i) {
    const scene::Cut& cut = *membranes[i];
    bool isGiven = i < sheets.size() && sheets[i] && sheets[i]->sizeMm == cut.sizeMm;
    membrane::SheetIndex made = isGiven ? membrane::SheetIndex{} : indexOf(cut);
    const membrane::SheetIndex& index = isGiven ? *sheets[i] : made;
    out.plans.emplace_back(int(out.rows.size()), index.particles, 0);
    out.rows.insert(out.rows.end(), index.rows.begin(), index.rows.end());
  }
  return out;
}

}  // namespace velum::render
