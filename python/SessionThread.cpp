#include "SessionThread.h"

#include <algorithm>
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
  std::thread::id caller = std::this_thread::get_id();
  std::optional<News> news;  ///< that no pulse has told yet
  std::exception_ptr error;
  bool isWorked = false;  ///< All is done but what the last pulse says of it.
  bool isTold = false;    ///< The last pulse has had its say.
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
      doTask(state, task, session);
      lock.lock();
      task.isDone = true;
      state.tasks.pop_front();
      state.done.notify_all();
    }
    lock.unlock();  // what ends here may want Python's lock
    state.kept.clear();
  }
  releaseFreeMemory();
}

void SessionThread::doTask(State& state, Task& task, session::Session& session) {
  auto before = session.file().before();
  try {
    task.progress.throwIfCancelled();
    task.work(session, task.progress);
    std::unique_lock lock(state.mutex);
    task.isWorked = true;
    state.done.notify_all();
    state.called.wait(lock, [&] { return task.isTold || state.isClosed; });
    task.progress.throwIfCancelled();
  } catch (...) {
    task.error = std::current_exception();
    session.file().restore(std::move(before));
  }
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
  // It would wait for itself.
  if (std::any_of(mState->tasks.begin(), mState->tasks.end(),
                  [&](Task* other) { return other->caller == task.caller; }))
    throw ArgumentError("the session is at work: what it calls meanwhile can only cancel or close it");
  mState->tasks.push_back(&task);
  mState->called.notify_all();
  auto hasMoved = [&] { return task.isDone || (task.isWorked && !task.isTold); };
  for (;;) {
    mState->done.wait_for(lock, kPulse, hasMoved);
    if (task.isDone) break;
    bool isLast = task.isWorked;
    std::optional<News> news = std::exchange(task.news, {});
    lock.unlock();
    try {
      if (!stop && (news || !isLast)) pulse(news ? &*news : nullptr);
    } catch (...) {
      stop = std::current_exception();
      task.progress.cancel();
    }
    lock.lock();
    task.isTold = isLast;
    if (isLast) mState->called.notify_all();
  }
  lock.unlock();
  if (stop) std::rethrow_exception(stop);
  if (task.error) std::rethrow_exception(task.error);
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
