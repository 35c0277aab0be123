#include "session/membrane/MembranePlayer.h"

#include <algorithm>

#include "core/Assert.h"
#include "session/membrane/LiveSheet.h"
#include "session/membrane/Membranes.h"

namespace velum::session {

namespace {

/// So often sections follow a sheet that moves.
constexpr double kIndexEveryMs = 200.0;
constexpr int kStepOnce = 5;

/// The scene without what no force depends on: cheap to hold while it is worked on.
scene::Scene forcesScene(const scene::Scene& scene) {
  scene::Scene part;
  part.volume = scene.volume;
  part.labels = scene.labels;
  part.model = scene.model;
  part.unit = scene.unit;
  return part;
}

}  // namespace

MembranePlayer::MembranePlayer() = default;
MembranePlayer::~MembranePlayer() = default;

LiveSheet* MembranePlayer::find(std::uint64_t id) {
  auto found = std::find_if(mSheets.begin(), mSheets.end(), [id](const auto& sheet) { return sheet->id() == id; });
  return found == mSheets.end() ? nullptr : found->get();
}

LiveSheet* MembranePlayer::sheetOf(int cut) const {
  auto found =
      std::find_if(mSheets.begin(), mSheets.end(), [cut](const auto& sheet) { return sheet->cut().id == cut; });
  return found == mSheets.end() ? nullptr : found->get();
}

void MembranePlayer::follow(const scene::Scene& scene) {
  DataKey data = dataKeyOf(scene);
  bool sameData = data == dataKeyOf(mScene);
  bool same = sameData && scene.cuts == mScene.cuts;
  if (same) return;
  mScene = forcesScene(scene);
  mScene.cuts = scene.cuts;
  auto old = std::exchange(mSheets, {});
  for (const auto& cut : scene.cuts) {
    if (!scene::isMembrane(cut)) continue;
    VELUM_ASSERT(cut.id > 0, "a cut in a scene has an id (scene::addCut)");
    auto known =
        std::find_if(old.begin(), old.end(), [&](const auto& sheet) { return sheet && sheet->cut().id == cut.id; });
    if (known == old.end()) {
      mSheets.push_back(std::make_unique<LiveSheet>(mNextId++, cut, data));
    } else {
      (*known)->follow(cut, data);
      mSheets.push_back(std::move(*known));
    }
  }
  for (auto& gone : old) {
    if (!gone) continue;
    mGoneCount += gone->shownCount();
    mGone.push_back(std::move(gone));
  }
}

MembranePlayer::Work MembranePlayer::nextWork() {
  if (mOut.id) return {};
  for (const auto& sheet : mSheets)
    if (sheet->needsForces()) return forcesWork(*sheet);
  for (const auto& sheet : mSheets)
    if (sheet->needsFigures()) return measureWork(*sheet);
  return {};
}

/// The data is still the same, but for the time step.
bool MembranePlayer::isOf(const scene::Scene& scene) const {
  return scene.volume.data.id() == mScene.volume.data.id() && scene.labels.data.id() == mScene.labels.data.id() &&
         scene.model.data.id() == mScene.model.data.id();
}

MembranePlayer::Work MembranePlayer::forcesWork(LiveSheet& sheet) {
  mOut = {sheet.id(), sheet.dataChange(), sheet.wish(), false, sheet.wantsPreview()};
  return [this, out = mOut, scene = forcesScene(mScene), cut = sheet.cut(), current = sheet.current(),
          maker = sheet.makerOf(mScene)](Progress& progress) mutable -> Finish {
    if (!maker) maker = std::make_shared<membrane::ForceMaker>(scene);
    auto forces = out.isPreview ? maker->preview(cut, progress) : maker->compute(cut, current, progress);
    auto made = std::make_shared<const MadeForces>(MadeForces{std::move(forces), cut, scene.volume.timeStep});
    return [this, out, maker, made, scene] {
      LiveSheet* found = find(out.id);
      if (!found) return;
      if (isOf(scene)) found->keepMaker(maker);
      if (found->dataChange() != out.data) return;
      found->takeForces(made, out.wish);
    };
  };
}

MembranePlayer::Work MembranePlayer::measureWork(LiveSheet& sheet) {
  mOut = {sheet.id(), sheet.dataChange(), sheet.wish(), true};
  return [this, out = mOut, scene = forcesScene(mScene), cut = sheet.cut(), shape = sheet.shape(),
          maker = sheet.makerOf(mScene)](Progress& progress) mutable -> Finish {
    if (!maker) maker = std::make_shared<membrane::ForceMaker>(scene);
    const membrane::Potential& potential = maker->potential();
    membrane::KeptWhole figures;
    std::vector<Advice> advice;
    membrane::LeftOut leftOut;
    if (potential.dims().x > 0) {
      figures = measureMembrane(potential, cut, shape, progress);
      advice = adviceFor(figures, potential, scene, cut, progress);
      leftOut = potential.computeLeftOut(cut.membrane->field, progress);
    }
    return [this, out, maker, figures, advice, leftOut, scene] {
      LiveSheet* found = find(out.id);
      if (!found) return;
      if (isOf(scene)) found->keepMaker(maker);
      found->takeFigures(figures, advice, leftOut, out.wish);
    };
  };
}

bool MembranePlayer::wantsCancel() const {
  if (!mOut.id) return false;
  const LiveSheet* sheet = const_cast<MembranePlayer*>(this)->find(mOut.id);
  if (!sheet || !sheet->cut().enabled || sheet->dataChange() != mOut.data) return true;
  // A hand that takes hold of something does not wait for exact forces.
  if (!mOut.isMeasure && !mOut.isPreview && sheet->wantsPreview() && sheet->wish() != mOut.wish) return true;
  return mOut.isMeasure && (sheet->wish() != mOut.wish || sheet->isMoving());
}

void MembranePlayer::endWork(const Finish& finish, const std::string& error) {
  Out out = std::exchange(mOut, {});
  if (finish) return finish();
  LiveSheet* sheet = find(out.id);
  if (!sheet || error.empty()) return;
  out.isMeasure ? sheet->failFigures() : sheet->failForces(error);
}

bool MembranePlayer::isMoving() const {
  return std::any_of(mSheets.begin(), mSheets.end(),
                     [this](const auto& sheet) { return (mPlaying && sheet->isMoving()) || sheet->isIndexStale(); });
}

bool MembranePlayer::isOnItsWay() const {
  return std::any_of(mSheets.begin(), mSheets.end(),
                     [this](const auto& sheet) { return mPlaying && (sheet->needsForces() || sheet->isMoving()); });
}

bool MembranePlayer::isSettled() const {
  return !mOut.id && !isMoving() && std::none_of(mSheets.begin(), mSheets.end(), [](const auto& sheet) {
    return sheet->needsForces() || sheet->needsFigures();
  });
}

bool MembranePlayer::advance(double budgetMs) {
  mGone.clear();
  auto count = std::count_if(mSheets.begin(), mSheets.end(), [](const auto& sheet) { return sheet->isMoving(); });
  if (mPlaying)
    for (const auto& sheet : mSheets) sheet->advance(budgetMs / double(std::max<std::ptrdiff_t>(count, 1)));
  refreshIndices();
  return mPlaying && count > 0;
}

bool MembranePlayer::stepOnce() {
  bool moved = false;
  for (const auto& sheet : mSheets)
    for (int i = 0; i < kStepOnce; ++i) moved = sheet->advance(0.0) || moved;
  refreshIndices();
  return moved;
}

void MembranePlayer::refreshIndices() {
  bool isDue = msSince(mIndexedAt) > kIndexEveryMs;
  for (const auto& sheet : mSheets) {
    bool isStill = !mPlaying || !sheet->isMoving();
    if (!sheet->isIndexStale() || !(isStill || isDue)) continue;
    sheet->makeIndex();
    mIndexedAt = Clock::now();
  }
}

std::map<int, render::FrameSheet> MembranePlayer::sheets() {
  std::map<int, render::FrameSheet> sheets;
  for (const auto& sheet : mSheets)
    if (sheet->cut().enabled) sheets[sheet->cut().id] = sheet->frameSheet();
  return sheets;
}

render::SheetIndices MembranePlayer::indices() const {
  render::SheetIndices indices;
  for (const auto& sheet : mSheets)
    if (sheet->cut().enabled) indices[sheet->cut().id] = sheet->index();
  return indices;
}

std::shared_ptr<const membrane::SheetIndex> MembranePlayer::index(int cut) const {
  LiveSheet* sheet = sheetOf(cut);
  if (!sheet) return nullptr;
  if (!sheet->index()) sheet->makeIndex();
  return sheet->index();
}

std::uint64_t MembranePlayer::shownCount() const {
  std::uint64_t count = mGoneCount;
  for (const auto& sheet : mSheets) count += sheet->shownCount();
  return count;
}

std::optional<MembraneStatus> MembranePlayer::status(int cut) const {
  const LiveSheet* sheet = sheetOf(cut);
  if (!sheet) return std::nullopt;
  return sheet->status(mPlaying, mOut.id == sheet->id() && !mOut.isMeasure);
}

void MembranePlayer::reset(int cut) {
  if (LiveSheet* sheet = sheetOf(cut)) sheet->reset();
}

std::vector<MembranePlayer::Rest> MembranePlayer::takeRests() {
  std::vector<Rest> rests;
  for (const auto& sheet : mSheets)
    if (auto shape = sheet->takeRest()) {
      rests.push_back({sheet->cut().id, std::move(*shape)});
      scene::findCut(mScene, sheet->cut().id)->membrane->shape = rests.back().shape;
    }
  return rests;
}

void MembranePlayer::complete(scene::Scene& scene) {
  for (auto& rest : takeRests())
    if (scene::Cut* cut = scene::findCut(scene, rest.cut); cut && cut->membrane)
      cut->membrane->shape = std::move(rest.shape);
}

bool MembranePlayer::hasRests() const {
  return std::any_of(mSheets.begin(), mSheets.end(), [](const auto& sheet) { return sheet->hasRest(); });
}

scene::Scene MembranePlayer::withShapes(scene::Scene scene) const {
  for (const auto& sheet : mSheets)
    if (scene::Cut* cut = scene::findCut(scene, sheet->cut().id); cut && scene::isMembrane(*cut))
      cut->membrane->shape = sheet->shape();
  return scene;
}

void MembranePlayer::releaseGpu() {
  mGone.clear();
  for (const auto& sheet : mSheets) sheet->releaseGpu();
}

}  // namespace velum::session
