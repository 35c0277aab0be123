#pragma once
#include <QObject>
#include <QString>
#include <functional>
#include <thread>

#include "velum/core/Task.h"

namespace velum::gui {

/// Long work in a thread of its own: it tells how far it is, can be cancelled, and is cancelled and awaited when the
/// object goes. Signals arrive in the thread of whoever listens.
class Job : public QObject {
  Q_OBJECT
 public:
  using Work = std::function<void(Progress&)>;
  Job(Work work, QObject* parent);
  ~Job() override;

  void start();
  void cancel() { mProgress.cancel(); }

 signals:
  void progressed(double fraction, const QString& what);
  /// @param error  one line for the user; empty when the work is done or was cancelled
  void finished(bool done, const QString& error);

 private:
  void run();

  Work mWork;
  Progress mProgress;
  std::thread mThread;
};

}  // namespace velum::gui
