// Ways from a worker's thread into the window.
#include <gtest/gtest.h>

#include <QApplication>
#include <QThread>
#include <atomic>
#include <chrono>
#include <memory>
#include <thread>
#include <vector>

#include "core/Error.h"
#include "gui/service/CallLater.h"
#include "gui/service/Job.h"

namespace velum::gui {

using namespace std::chrono_literals;

TEST(CallLater, CallsComeInTheirOrderAndInTheOwnersThread) {
  QObject owner;
  std::vector<int> came;
  std::thread worker([&] {
    for (int i = 0; i < 100; ++i)
      callLater(&owner, [&came, i] { came.push_back(QThread::currentThread() == qApp->thread() ? i : -1); });
  });
  worker.join();
  EXPECT_TRUE(came.empty()) << "before the thread came back to its events";
  QApplication::processEvents();
  std::vector<int> all(100);
  for (int i = 0; i < 100; ++i) all[std::size_t(i)] = i;
  EXPECT_EQ(came, all);
}

TEST(CallLater, WhatIsCalledSeesWhatTheWorkerWrote) {
  // In the preset tsan this is a test of what the sanitizer is told: it must find nothing here.
  QObject owner;
  int sum = 0;
  std::atomic<bool> isOver = false;
  std::thread worker([&] {
    for (int i = 0; i < 200; ++i) callLater(&owner, [&sum, row = std::vector<int>(100, i)] { sum += row.front(); });
    isOver.store(true, std::memory_order_relaxed);
  });
  while (!isOver.load(std::memory_order_relaxed)) QApplication::processEvents();
  QApplication::processEvents();
  EXPECT_EQ(sum, 199 * 100);
  worker.join();
}

TEST(CallLater, WhatWasCalledGoesInTheOwnersThread) {
  // It may hold what belongs to that thread.
  QObject owner;
  std::atomic<int> here = 0, elsewhere = 0;
  std::atomic<bool> isOver = false;
  auto count = [&](void*) { ++(QThread::currentThread() == qApp->thread() ? here : elsewhere); };
  std::thread worker([&] {
    for (int i = 0; i < 2000; ++i) callLater(&owner, [held = std::shared_ptr<void>(nullptr, count)] {});
    isOver = true;
  });
  while (!isOver) QApplication::processEvents();
  worker.join();
  QApplication::processEvents();
  EXPECT_EQ(here, 2000);
  EXPECT_EQ(elsewhere, 0);
}

TEST(CallLater, NothingIsCalledAndNothingLeaksWhereTheOwnerHasGone) {
  auto owner = std::make_unique<QObject>();
  auto held = std::make_shared<int>(7);
  bool isCalled = false;
  callLater(owner.get(), [held, &isCalled] { isCalled = true; });
  EXPECT_EQ(held.use_count(), 2);
  owner.reset();
  EXPECT_EQ(held.use_count(), 1);
  QApplication::processEvents();
  EXPECT_FALSE(isCalled);
}

TEST(GuiJob, WhoGivesItUpHearsNoMoreOfIt) {
  // A preview that was given up for another one must not be shown, though it was done just then.
  QObject listener;
  int heard = 0;
  std::atomic<bool> isDone = false;
  auto job = std::make_unique<Job>([&](Progress&) { isDone = true; }, nullptr);
  QObject::connect(job.get(), &Job::finished, &listener, [&] { ++heard; });
  job->start();
  while (!isDone) std::this_thread::sleep_for(1ms);
  std::this_thread::sleep_for(50ms);  // until it has said so, into the queue
  job.reset();
  QApplication::processEvents();
  EXPECT_EQ(heard, 0);
}

TEST(GuiJob, TellsHowFarItIsAndThatItHasFailed) {
  QObject listener;
  std::vector<double> fractions;
  QString error;
  bool isOver = false;
  Job job(
      [](Progress& progress) {
        progress.report(0.25, "a quarter");
        throw ArgumentError("the rest is missing");
      },
      nullptr);
  QObject::connect(&job, &Job::progressed, &listener, [&](double fraction) { fractions.push_back(fraction); });
  QObject::connect(&job, &Job::finished, &listener, [&](bool done, const QString& text) {
    EXPECT_FALSE(done);
    error = text;
    isOver = true;
  });
  job.start();
  auto end = std::chrono::steady_clock::now() + 10s;
  while (!isOver && std::chrono::steady_clock::now() < end) QApplication::processEvents();
  ASSERT_TRUE(isOver);
  EXPECT_EQ(fractions, std::vector<double>{0.25});
  EXPECT_EQ(error.toStdString(), "the rest is missing");
}

}  // namespace velum::gui
