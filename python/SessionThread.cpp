#include "SessionThread.h"

#include <chrono>
#include <exception>
#include <optional>
#include <utility>

#include "core/Error.h"
#include "core/Memory.h"

namespace velum::python {

namespace {

constexpr auto kPulse = std::chrono::milliseconds(50);

}  // namespace

/// Work, and what has become of it.
struct SessionThread::Task {
  Task(const Work& toDo, std::mutex& mutex)
      : work(toDo), progress([this, &mutex](double fraction, const std::string& what) {
          std::lock_guard lock(mutex);
          news = News{fraction, what};
        }) {}
  const Work& work;
  Progress progress;
  std::optional<News> news;  ///< that no pulse has told yet
  std::exception_ptr error;
  bool isDone = false;
};

SessionThread::SessionThread(gpu::ContextKind context) : mProcess(::getpid()), mState(std::make_unique<State>()) {
  mState->thread = std::thread([state = mState.get(), context] { live(*state, context); });
}

SessionThread::~SessionThread() {
  close();
  if (isForked()) static_cast<void>(mState.release());
}

void SessionThread::live(State& state, gpu::ContextKind context) {
  {
    session::Session session;
    session.setContextKind(context);
    std::unique_lock lock(state.mutex);
    for (;;) {
      state.called.wait(lock, [&] { return state.isClosed || !state.tasks.empty() || !state.dropped.empty(); });
      if (!state.dropped.empty()) {
        endDropped(state, lock);
        continue;
      }
      if (state.tasks.empty()) break;
      Task& task = *state.tasks.front();
      lock.unlock();
      std::exception_ptr error;
      try {
        task.progress.throwIfCancelled();
        task.work(session, task.progress);
      } catch (...) {
        error = std::current_exception();
      }
      lock.lock();
      task.error = error;
      task.isDone = true;
      state.tasks.pop_front();
      state.done.notify_all();
    }
    state.kept.clear();
  }
  releaseFreeMemory();
}

void SessionThread::endDropped(State& state, std::unique_lock<std::mutex>& lock) {
  auto dropped = std::exchange(state.dropped, {});
  lock.unlock();
  auto isSame = [](const auto& a, const auto& b) { return !a.owner_before(b) && !b.owner_before(a); };
  for (const auto& thing : dropped) std::erase_if(state.kept, [&](const auto& kept) { return isSame(kept, thing); });
  lock.lock();
}

void SessionThread::run(const Work& work, const Pulse& pulse) {
  if (isForked()) throw ArgumentError("a session belongs to the process that made it; make another one after a fork");
  Task task(work, mState->mutex);
  std::exception_ptr stop;
  std::unique_lock lock(mState->mutex);
  if (mState->isClosed) throw ArgumentError("the session is closed");
  mState->tasks.push_back(&task);
  mState->called.notify_all();
  auto isDone = [&] { return task.isDone; };
  while (!mState->done.wait_for(lock, kPulse, isDone)) {
    std::optional<News> news = std::exchange(task.news, {});
    lock.unlock();
    try {
      if (!stop) pulse(news ? &*news : nullptr);
    } catch (...) {
      stop = std::current_exception();
      task.progress.cancel();
    }
    lock.lock();
  }
  lock.unlock();
  if (stop) std::rethrow_exception(stop);
  if (task.error) std::rethrow_exception(task.error);
  if (task.news) pulse(&*task.news);
}

void SessionThread::keep(std::shared_ptr<void> thing) { mState->kept.push_back(std::move(thing)); }

void SessionThread::drop(std::weak_ptr<void> thing) {
  if (isForked()) return;
  {
    std::lock_guard lock(mState->mutex);
    mState->dropped.push_back(std::move(thing));
  }
  mState->called.notify_all();
}

void SessionThread::cancel() {
  if (isForked()) return;
  std::lock_guard lock(mState->mutex);
  if (!mState->tasks.empty()) mState->tasks.front()->progress.cancel();
}

void SessionThread::close() {
  if (isForked()) return;
  std::thread thread;
  {
    std::lock_guard lock(mState->mutex);
    mState->isClosed = true;
    for (Task* task : mState->tasks) task->progress.cancel();
    thread = std::move(mState->thread);
  }
  mState->called.notify_all();
  if (thread.joinable()) thread.join();
}

}  // namespace velum::python
