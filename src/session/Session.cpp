#include "session/Session.h"

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

#include "core/Assert.h"
#include "core/Clock.h"
#include "session/membrane/Membranes.h"
#include "session/picture/Picture.h"

namespace velum::session {

namespace {

constexpr double kSettleWorkMs = 50.0;
constexpr auto kSettlePause = std::chrono::milliseconds(1);

}  // namespace

Session::Session() {
  mPlaying.push_back({&mGrowth, nullptr, {}, {}});
  mPlaying.push_back({&mMembranes, nullptr, {}, {}});
  mDocument.setListener([this] { changed(); });
}

Session::~Session() {
  mDocument.setListener({});
  dropJob();
  for (auto& playing : mPlaying) playing.job.reset();  // they know their players
  if (mContext) {
    mContext->makeCurrent();
    releaseGpu();
    mRenderer.reset();
  }
}

void Session::changed() {
  for (auto& playing : mPlaying) playing.player->follow(mDocument.scene());
  mFile.journalChange();
  if (mListener) mListener();
}

// Players.

void Session::collect() {
  collectJob();
  for (auto& playing : mPlaying) collect(playing);
}

void Session::collect(Playing& playing) {
  if (!playing.job || !playing.job->hasEnded()) return;
  playing.job.reset();  // waits for its last word
  playing.player->endWork(std::exchange(playing.finish, {}), playing.outcome.error);
}

void Session::startWork(Playing& playing) {
  if (playing.job && playing.player->wantsCancel()) playing.job->cancel();
  if (playing.job) return;
  Player::Work work = playing.player->nextWork();
  if (!work) return;
  playing.job = std::make_unique<Job>(
      [&playing, work = std::move(work)](Progress& progress) { playing.finish = work(progress); }, nullptr,
      [this, &playing](const JobOutcome& outcome) {
        playing.outcome = outcome;
        wake();
      });
}

bool Session::advance(double budgetMs) {
  bool isMoving = false;
  auto moving = std::count_if(mPlaying.begin(), mPlaying.end(), [](const Playing& p) { return p.player->isMoving(); });
  for (auto& playing : mPlaying) {
    collect(playing);
    startWork(playing);
    playing.player->advance(budgetMs / double(std::max<std::ptrdiff_t>(moving, 1)));
    if (playing.player->hasRests()) mDocument.complete([&](scene::Scene& scene) { playing.player->complete(scene); });
    startWork(playing);  // what is asked of what has just come to rest
    isMoving = isMoving || playing.player->isMoving();
  }
  return isMoving;
}

bool Session::isOnItsWay() const {
  return std::any_of(mPlaying.begin(), mPlaying.end(),
                     [](const Playing& playing) { return playing.player->isOnItsWay(); });
}

bool Session::isSettled() const {
  return std::all_of(mPlaying.begin(), mPlaying.end(),
                     [](const Playing& playing) { return playing.player->isSettled() && !playing.player->hasRests(); });
}

std::uint64_t Session::shownCount() const {
  std::uint64_t count = 0;
  for (const auto& playing : mPlaying) count += playing.player->shownCount();
  return count;
}

render::Frame Session::frame(glm::ivec2 size) {
  render::Frame frame;
  frame.scene = scene();
  frame.pictureSize = size;
  for (auto& playing : mPlaying) playing.player->show(frame);
  return frame;
}

void Session::bindContext() {
  if (!mOwnsContext) return;
  if (!mContext) mContext = gpu::Context::create(mContextKind);
  mContext->makeCurrent();
}

void Session::settle(Progress& progress) {
  if (isSettled()) return;
  if (hasMembranes(scene())) bindContext();
  while (!isSettled()) {
    progress.throwIfCancelled();
    if (!advance(kSettleWorkMs)) std::this_thread::sleep_for(kSettlePause);  // for what is computed beside
  }
}

Image Session::picture(const PictureOptions& options, Progress& progress) {
  VELUM_ASSERT(mOwnsContext, "a session that has borrowed a context leaves pictures to whoever lent it");
  settle(progress);
  bindContext();
  if (!mRenderer) mRenderer = std::make_unique<render::Renderer>(*mContext);
  return drawPicture(*mRenderer, mMembranes.withShapes(scene()), options, mContext->limits(), progress);
}

void Session::releaseGpu() {
  for (auto& playing : mPlaying) playing.player->releaseGpu();
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
  while (mJob && !mJob->hasEnded() && msSince(start) < longestMs) std::this_thread::sleep_for(kSettlePause);
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
