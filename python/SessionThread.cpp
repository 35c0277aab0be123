#include "SessionThread.h"

#include <unistd.h>

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

SessionThread::SessionThread(gpu::ContextKind context)
    : mProcess(::getpid()), mThread(std::make_unique<std::thread>([this, context] { live(context); })) {}

SessionThread::~SessionThread() { close(); }

void SessionThread::live(gpu::ContextKind context) {
  {
    session::Session session;
    session.setContextKind(context);
    std::unique_lock lock(mMutex);
    for (;;) {
      mCalled.wait(lock, [this] { return mIsClosed || !mTasks.empty(); });
      if (mTasks.empty()) break;
      Task& task = *mTasks.front();
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
      mTasks.pop_front();
      mDone.notify_all();
    }
  }
  releaseFreeMemory();
}

void SessionThread::run(const Work& work, const Pulse& pulse) {
  if (::getpid() != mProcess)
    throw ArgumentError("a session belongs to the process that made it; make another one after a fork");
  Task task(work, mMutex);
  std::exception_ptr stop;
  std::unique_lock lock(mMutex);
  if (mIsClosed) throw ArgumentError("the session is closed");
  mTasks.push_back(&task);
  mCalled.notify_all();
  auto isDone = [&] { return task.isDone; };
  while (!mDone.wait_for(lock, kPulse, isDone)) {
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

void SessionThread::cancel() {
  std::lock_guard lock(mMutex);
  if (!mTasks.empty()) mTasks.front()->progress.cancel();
}

void SessionThread::close() {
  std::unique_ptr<std::thread> thread;
  {
    std::lock_guard lock(mMutex);
    mIsClosed = true;
    for (Task* task : mTasks) task->progress.cancel();
    thread = std::move(mThread);
  }
  mCalled.notify_all();
  if (::getpid() != mProcess)
    static_cast<void>(thread.release());  // a fork has no such thread
  else if (thread)
    thread->join();
}

}  // namespace velum::python
