#include "session/membrane/MembraneMover.h"

#include <algorithm>

#include "core/Assert.h"
#include "core/Clock.h"
#include "gpu/Loss.h"
#include "session/membrane/LiveSheet.h"
#include "session/membrane/Membranes.h"

namespace velum::session {

namespace {

/// So often sections follow a sheet that moves.
constexpr double kIndexEveryMs = 200.0;
constexpr int kStepOnce = 5;

/// The scene without the parts on which no force depends: cheap to hold while work is done for it.
scene::Scene forcesScene(const scene::Scene& scene) {
  scene::Scene part;
  part.volume = scene.volume;
  part.labels = scene.labels;
  part.model = scene.model;
  part.unit = scene.unit;
  return part;
}

}  // namespace

MembraneMover::MembraneMover(Purpose purpose) { setPurpose(purpose); }
MembraneMover::~MembraneMover() = default;

void MembraneMover::setPurpose(Purpose purpose) {
  VELUM_ASSERT(mSheets.empty(), "whom it plays for is said before there are sheets");
  mPurpose = purpose;
  mMeasures = purpose == Purpose::Show;
}

LiveSheet* MembraneMover::find(std::uint64_t id) {
  auto found = std::find_if(mSheets.begin(), mSheets.end(), [id](const auto& sheet) { return sheet->id() == id; });
  return found == mSheets.end() ? nullptr : found->get();
}

LiveSheet* MembraneMover::sheetOf(int cut) const {
  auto found =
      std::find_if(mSheets.begin(), mSheets.end(), [cut](const auto& sheet) { return sheet->cut().id == cut; });
  return found == mSheets.end() ? nullptr : found->get();
}

void MembraneMover::follow(const scene::Scene& scene) {
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
      mSheets.push_back(std::make_unique<LiveSheet>(mNextId++, cut, data, mPurpose));
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

/// In another context than before, as after the driver has lost that, what is on the GPU is made anew.
void MembraneMover::keepUp() {
  unsigned now = gpu::contextNumber();
  if (now == mContext || now == 0) return;
  if (mContext != 0) releaseGpu();
  for (const auto& sheet : mSheets) sheet->resume();
  mContext = now;
}

MembraneMover::Work MembraneMover::nextWork() {
  if (mOut.id) return {};
  keepUp();
  for (const auto& sheet : mSheets)
    if (sheet->needsForces()) return forcesWork(*sheet);
  for (const auto& sheet : mSheets)
    if (sheet->needsFigures(mMeasures)) return measureWork(*sheet);
  return {};
}

/// The data is still the same, but for the time step.
bool MembraneMover::isOf(const scene::Scene& scene) const {
  return scene.volume.data.id() == mScene.volume.data.id() && scene.labels.data.id() == mScene.labels.data.id() &&
         scene.model.data.id() == mScene.model.data.id();
}

MembraneMover::Work MembraneMover::forcesWork(LiveSheet& sheet) {
  auto current = sheet.current();  // which may be lost
  mOut = {sheet.id(), sheet.dataChange(), sheet.wish(), false, sheet.wantsPreview()};
  return [this, out = mOut, scene = forcesScene(mScene), cut = sheet.cut(), current = std::move(current),
          maker = sheet.makerOf(mScene)](Progress& progress) mutable -> Finish {
    if (!maker) maker = std::make_shared<membrane::ForceMaker>(scene);
    auto start = Clock::now();
    auto forces = out.isPreview ? maker->preview(cut, progress) : maker->compute(cut, current, progress);
    auto made =
        std::make_shared<const MadeForces>(MadeForces{std::move(forces), cut, scene.volume.timeStep, msSince(start)});
    return [this, out, maker, made, scene] {
      LiveSheet* found = find(out.id);
      if (!found) return;
      if (isOf(scene)) found->keepMaker(maker);
      if (found->dataChange() != out.data) return;
      found->takeForces(made, out.wish);
    };
  };
}

MembraneMover::Work MembraneMover::measureWork(LiveSheet& sheet) {
  auto shape = sheet.shape();
  mOut = {sheet.id(), sheet.dataChange(), sheet.wish(), true};
  return [this, out = mOut, scene = forcesScene(mScene), cut = sheet.cut(), shape = std::move(shape),
          maker = sheet.makerOf(mScene), whole = mMeasures](Progress& progress) mutable -> Finish {
    if (!maker) maker = std::make_shared<membrane::ForceMaker>(scene);
    SheetFigures figures;
    figures.isWhole = whole;
    bool isOfSomething = maker->potential().dims().x > 0;
    if (isOfSomething && !whole) figures.kept = measureCut(maker->potentialFor(cut, progress), cut, shape, progress);
    if (isOfSomething && whole) {
      figures.kept = measureMembrane(*maker, cut, shape, progress);
      figures.advice = adviceFor(figures.kept, maker->potential(), scene, cut, progress);
      figures.leftOut = maker->potentialFor(cut, progress).computeLeftOut(cut.membrane->field, progress);
    }
    if (isOfSomething) figures.voxels = membrane::voxelsOf(maker->potentialFor(cut, progress));
    return [this, out, maker, figures, scene] {
      LiveSheet* found = find(out.id);
      if (!found) return;
      if (isOf(scene)) found->keepMaker(maker);
      found->takeFigures(figures, out.wish);
    };
  };
}

bool MembraneMover::wantsCancel() const {
  if (!mOut.id) return false;
  const LiveSheet* sheet = const_cast<MembraneMover*>(this)->find(mOut.id);
  if (!sheet || !sheet->cut().enabled || sheet->dataChange() != mOut.data) return true;
  // A hand that takes hold of something does not wait for exact forces.
  if (!mOut.isMeasure && !mOut.isPreview && sheet->wantsPreview() && sheet->wish() != mOut.wish) return true;
  return mOut.isMeasure && (sheet->wish() != mOut.wish || sheet->isMoving());
}

void MembraneMover::endWork(const Finish& finish, const std::string& error) {
  Out out = std::exchange(mOut, {});
  if (finish) return finish();
  LiveSheet* sheet = find(out.id);
  if (!sheet || error.empty()) return;
  out.isMeasure ? sheet->failFigures() : sheet->failForces(error);
}

bool MembraneMover::isMoving() const {
  return std::any_of(mSheets.begin(), mSheets.end(),
                     [this](const auto& sheet) { return (mPlaying && sheet->isMoving()) || sheet->isIndexStale(); });
}

bool MembraneMover::isOnItsWay() const {
  return std::any_of(mSheets.begin(), mSheets.end(),
                     [this](const auto& sheet) { return mPlaying && (sheet->needsForces() || sheet->isMoving()); });
}

bool MembraneMover::isSettled() const {
  return !mOut.id && !isMoving() && std::none_of(mSheets.begin(), mSheets.end(), [this](const auto& sheet) {
    return sheet->needsForces() || sheet->needsFigures(mMeasures);
  });
}

bool MembraneMover::advance(double budgetMs) {
  keepUp();
  mGone.clear();
  auto count = std::count_if(mSheets.begin(), mSheets.end(), [](const auto& sheet) { return sheet->isMoving(); });
  if (mPlaying)
    for (const auto& sheet : mSheets) sheet->advance(budgetMs / double(std::max<std::ptrdiff_t>(count, 1)));
  refreshIndices();
  return mPlaying && count > 0;
}

bool MembraneMover::stepOnce() {
  keepUp();
  bool moved = false;
  for (const auto& sheet : mSheets)
    for (int i = 0; i < kStepOnce; ++i) moved = sheet->advance(0.0) || moved;
  refreshIndices();
  return moved;
}

void MembraneMover::refreshIndices() {
  bool isDue = msSince(mIndexedAt) > kIndexEveryMs;
  for (const auto& sheet : mSheets) {
    bool isStill = !mPlaying || !sheet->isMoving();
    if (!sheet->isIndexStale() || !(isStill || isDue)) continue;
    sheet->makeIndex();
    mIndexedAt = Clock::now();
  }
}

std::map<int, render::FrameSheet> MembraneMover::sheets() {
  keepUp();
  std::map<int, render::FrameSheet> sheets;
  for (const auto& sheet : mSheets)
    if (sheet->cut().enabled) sheets[sheet->cut().id] = sheet->frameSheet();
  return sheets;
}

render::SheetIndices MembraneMover::indices() const {
  render::SheetIndices indices;
  for (const auto& sheet : mSheets)
    if (sheet->cut().enabled) indices[sheet->cut().id] = sheet->index();
  return indices;
}

std::shared_ptr<const membrane::SheetIndex> MembraneMover::index(int cut) const {
  LiveSheet* sheet = sheetOf(cut);
  if (!sheet) return nullptr;
  if (!sheet->index()) sheet->makeIndex();
  return sheet->index();
}

std::uint64_t MembraneMover::shownCount() const {
  std::uint64_t count = mGoneCount;
  for (const auto& sheet : mSheets) count += sheet->shownCount();
  return count;
}

std::optional<MembraneStatus> MembraneMover::status(int cut) const {
  const LiveSheet* sheet = sheetOf(cut);
  if (!sheet) return std::nullopt;
  return sheet->status(mPlaying, mOut.id == sheet->id() && !mOut.isMeasure);
}

std::vector<MembraneReport> MembraneMover::reports() const {
  std::vector<MembraneReport> reports;
  for (const auto& sheet : mSheets)
    if (sheet->cut().enabled) reports.push_back(sheet->report());
  return reports;
}

membrane::KeptWholeLimit MembraneMover::limit(int cut, Progress& progress) const {
  const LiveSheet* sheet = sheetOf(cut);
  VELUM_ASSERT(sheet, "the limit is of a membrane of the scene");
  auto maker = sheet->makerOf(mScene);
  if (!maker) maker = std::make_shared<membrane::ForceMaker>(mScene);
  return limitOf(maker->potentialFor(sheet->cut(), progress), sheet->cut(), progress);
}

void MembraneMover::reset(int cut) {
  if (LiveSheet* sheet = sheetOf(cut)) sheet->reset();
}

std::vector<MembraneMover::Rest> MembraneMover::takeRests() {
  std::vector<Rest> rests;
  for (const auto& sheet : mSheets)
    if (auto shape = sheet->takeRest()) {
      rests.push_back({sheet->cut().id, std::move(*shape)});
      scene::findCut(mScene, sheet->cut().id)->membrane->shape = rests.back().shape;
    }
  return rests;
}

void MembraneMover::complete(scene::Scene& scene) {
  for (auto& rest : takeRests())
    if (scene::Cut* cut = scene::findCut(scene, rest.cut); cut && cut->membrane)
      cut->membrane->shape = std::move(rest.shape);
}

bool MembraneMover::hasRests() const {
  return std::any_of(mSheets.begin(), mSheets.end(), [](const auto& sheet) { return sheet->hasRest(); });
}

scene::Scene MembraneMover::withShapes(scene::Scene scene) const {
  for (const auto& sheet : mSheets)
    if (scene::Cut* cut = scene::findCut(scene, sheet->cut().id); cut && scene::isMembrane(*cut))
      cut->membrane->shape = sheet->shape();
  return scene;
}

void MembraneMover::releaseGpu() {
  mGone.clear();
  for (const auto& sheet : mSheets) sheet->releaseGpu();
  mContext = 0;
}

}  // namespace velum::session
