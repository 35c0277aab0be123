#include "session/Session.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

#include "core/Assert.h"
#include "core/Clock.h"
#include "core/Error.h"
#include "core/Memory.h"
#include "io/kinds/FileKind.h"
#include "session/Rest.h"
#include "session/document/Folders.h"
#include "session/film/FilmDrawer.h"
#include "session/film/MakeFilm.h"
#include "session/picture/Picture.h"
#include "session/picture/PictureParts.h"
#include "session/plate/Plate.h"

namespace velum::session {

namespace {

constexpr auto kPause = std::chrono::milliseconds(1);

}  // namespace

Session::Session(scene::Scene scene) : mLevels(levelFolder()) {
  mWorking.push_back({&mGrowth, nullptr, nullptr, {}, {}});
  mWorking.push_back({&mLevels, nullptr, nullptr, {}, {}});
  mWorking.push_back({&mMembranes, &mMembranes, nullptr, {}, {}});
  mDocument.replace(std::move(scene));
  for (auto& working : mWorking) working.worker->follow(mDocument.shown());
  mDocument.setListener([this] { changed(); });
}

Session::~Session() {
  mDocument.setListener({});
  dropJob();
  for (auto& working : mWorking) working.job.reset();  // they know their workers
  if (mContext) {
    try {
      mContext->makeCurrent();
    } catch (const Error&) {
      mContext.reset();  // lost, and with it all that was in it
    }
    releaseGpu();
    mRenderer.reset();
  }
}

void Session::changed() {
  for (auto& working : mWorking) working.worker->follow(mDocument.shown());
  mFile.journalChange();
  if (mListener) mListener();
  bool isDue = std::any_of(mWorking.begin(), mWorking.end(), [](const Working& working) {
    return !working.mover && (!working.worker->isSettled() || working.worker->hasRests());
  });
  if (isDue) wake();
}

// What goes on beside the document.

void Session::collect() {
  collectJob();
  for (auto& working : mWorking) {
    collect(working);
    if (working.mover) continue;
    complete(working);
    startWork(working);
  }
}

void Session::collect(Working& working) {
  if (!working.job || !working.job->hasEnded()) return;
  working.job.reset();  // waits for its last word
  working.worker->endWork(std::exchange(working.finish, {}), working.outcome.error);
}

void Session::complete(Working& working) {
  if (working.worker->hasRests()) mDocument.complete([&](scene::Scene& scene) { working.worker->complete(scene); });
}

void Session::startWork(Working& working) {
  if (working.job && working.worker->wantsCancel()) working.job->cancel();
  if (working.job) return;
  Worker::Work work = working.worker->nextWork();
  if (!work) return;
  working.job = std::make_unique<Job>(
      [&working, work = std::move(work)](Progress& progress) { working.finish = work(progress); }, nullptr,
      [this, &working](const JobOutcome& outcome) {
        working.outcome = outcome;
        wake();
      });
}

bool Session::advance(double budgetMs) {
  bool isMoving = false;
  for (auto& working : mWorking) {
    if (!working.mover) continue;
    collect(working);
    startWork(working);
    working.mover->advance(budgetMs);
    complete(working);
    startWork(working);  // what is asked of what has just come to rest
    isMoving = isMoving || working.mover->isMoving();
  }
  return isMoving;
}

bool Session::isOnItsWay() const {
  return std::any_of(mWorking.begin(), mWorking.end(),
                     [](const Working& working) { return working.worker->isOnItsWay(); });
}

bool Session::isSettled() const {
  return std::all_of(mWorking.begin(), mWorking.end(),
                     [](const Working& working) { return working.worker->isSettled() && !working.worker->hasRests(); });
}

bool Session::isStill() const { return mMembranes.isSettled() && !mMembranes.hasRests(); }

render::Frame Session::frame(glm::ivec2 size) {
  render::Frame frame;
  frame.scene = shown();
  frame.pictureSize = size;
  frame.brickBytes = memoryBudget().gpuBrickBytes;
  mMembranes.show(frame);
  return frame;
}

void Session::borrowContext() {
  mOwnsContext = false;
  mMembranes.setPurpose(MembraneMover::Purpose::Show);
}

void Session::bindContext() {
  if (!mOwnsContext) return;
  if (!mContext) mContext = gpu::Context::create(mContextKind);
  mContext->makeCurrent();
}

// For those who wait.

void Session::bringToRest(Working& working, Progress& progress) {
  while (working.job && !working.job->hasEnded()) std::this_thread::sleep_for(kPause);
  collect(working);
  auto write = [&] { complete(working); };
  if (!working.mover) return session::bringToRest(*working.worker, write, progress);
  if (working.worker->isSettled() && !working.worker->hasRests()) return;
  bindContext();
  session::bringToRest(*working.mover, write, progress);
}

void Session::settle(Progress& progress) {
  while (!isSettled())
    for (auto& working : mWorking) bringToRest(working, progress);
}

std::vector<std::string> Session::grow(Progress& progress) {
  Shared<LabelVolume> before = shown().labels.data;
  bringToRest(mWorking.front(), progress);
  const scene::LabelLayer& labels = shown().labels;
  bool hasNews = !labels.growths.empty() && !(labels.data == before);
  return hasNews ? labels.data->warnings : std::vector<std::string>();
}

scene::Scene Session::settled(Progress& progress) {
  settle(progress);
  return mMembranes.withShapes(shown());
}

render::Renderer& Session::renderer() {
  VELUM_ASSERT(mOwnsContext, "a session that has borrowed a context leaves drawing to whoever lent it");
  bindContext();
  if (!mRenderer) mRenderer = std::make_unique<render::Renderer>(*mContext);
  return *mRenderer;
}

Image Session::picture(const PictureOptions& options, Progress& progress) {
  scene::Scene drawn = settled(progress);
  render::Renderer& draws = renderer();
  return drawPicture(draws, drawn, options, mContext->limits(), progress);
}

vector::Drawing Session::plate(const PictureOptions& options, std::optional<scene::SectionKind> section,
                               Progress& progress) {
  scene::Scene drawn = settled(progress);
  if (section) return drawSectionPlate(drawn, *section, options, progress);
  render::Renderer& draws = renderer();
  return drawPlate(draws, drawn, options, mContext->limits(), progress);
}

std::vector<std::string> Session::savePicture(const PictureOptions& options, std::optional<scene::SectionKind> section,
                                              const std::filesystem::path& path, Progress& progress) {
  if (path != "-") expectPictureFile(path);
  bool isPart = options.part.parts > 1;
  if (isPart && (section || path == "-" || io::isDrawing(path)))
    throw ArgumentError("parts are drawn of pictures in files: .png, .tif, .exr, and not of sections");
  if (isPart) {
    scene::Scene drawn = settled(progress);
    render::Renderer& draws = renderer();
    return savePicturePart(draws, drawn, shown(), options, mContext->limits(), path, progress);
  }
  if (io::isDrawing(path)) {
    vector::Drawing drawing = plate(options, section, progress);
    savePlate(drawing, shown(), options, path);
    return shown().lettering.pageWidth > 0.0 || options.dpi > 0.0 ? journalNotes(drawing) : std::vector<std::string>();
  }
  Image image =
      section ? drawSectionPicture(settled(progress), *section, options, progress) : picture(options, progress);
  session::savePicture(image, shown(), options, path);
  return {};
}

FilmReport Session::film(FilmOutput output, Progress& progress) {
  return drawFilm(*this, scene(), std::move(output), progress);
}

std::vector<MembraneReport> Session::membraneReports(MembraneQuestions questions, Progress& progress) {
  mMembranes.setMeasures(questions.kept || questions.limit);
  settle(progress);
  std::vector<MembraneReport> reports = mMembranes.reports();
  if (questions.limit && scene().volume.data)
    for (MembraneReport& report : reports) report.limit = mMembranes.limit(report.cut, progress);
  return reports;
}

PictureCounter Session::counter(glm::ivec2 size, Progress& progress) {
  return {renderer(), size, mContext->limits(), progress};
}

// The job on whose end the user waits.

bool Session::startJob(Job::Work work, Progress::Listener progressed, Job::Ended ended) {
  if (mJob) return false;
  mJobEnded = std::move(ended);
  mJob = std::make_unique<Job>(std::move(work), std::move(progressed), [this](const JobOutcome& outcome) {
    mJobOutcome = outcome;
    wake();
  });
  return true;
}

void Session::collectJob() {
  if (!mJob || !mJob->hasEnded()) return;
  mJob.reset();
  auto ended = std::exchange(mJobEnded, {});
  if (ended) ended(std::exchange(mJobOutcome, {}));
}

void Session::awaitJob(double longestMs) {
  auto start = Clock::now();
  while (mJob && !mJob->hasEnded() && msSince(start) < longestMs) std::this_thread::sleep_for(kPause);
  collectJob();
}

void Session::cancelJob() {
  if (mJob) mJob->cancel();
}

void Session::dropJob() {
  mJobEnded = {};
  mJob.reset();
}

}  // namespace velum::session
