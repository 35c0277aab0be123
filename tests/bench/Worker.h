#pragma once
#include <condition_variable>
#include <future>
#include <mutex>
#include <thread>
#include <utility>

namespace velum::bench {

/// One thread that does one thing at a time for whoever waits. A GL context made on it stays there: GLX and EGL
/// contexts cannot take turns on one thread.
class Worker {
 public:
  Worker() : mThread([this] { loop(); }) {}
  ~Worker() {
    run([this] { mEnds = true; });
    mThread.join();
  }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// Runs it over there and waits. What it throws is thrown here.
  template <class Job>
  void run(Job job) {
    std::packaged_task<void()> task(std::move(job));
    auto done = task.get_future();
    {
      std::lock_guard lock(mMutex);
      mTask = std::move(task);
    }
    mWakes.notify_one();
    done.get();
  }

 private:
  void loop() {
    while (!mEnds) {
      std::unique_lock lock(mMutex);
      mWakes.wait(lock, [this] { return mTask.valid(); });
      auto task = std::exchange(mTask, {});
      lock.unlock();
      task();
    }
  }

  std::mutex mMutex;
  std::condition_variable mWakes;
  std::packaged_task<void()> mTask;
  bool mEnds = false;  // read and written on the thread only
  std::thread mThread;
};

}  // namespace velum::bench
