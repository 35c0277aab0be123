#pragma once
#include <QObject>
#include <QSocketNotifier>

namespace velum::gui {

/// Tells in the event loop that the system, or a terminal, wants the program to end: SIGTERM, SIGINT and SIGHUP, unless
/// these signals were ignored when the program was started (nohup). A second signal ends the program at once. At most
/// one object of this class in a process.
class QuitSignals : public QObject {
  Q_OBJECT
 public:
  QuitSignals();
  ~QuitSignals() override;

 signals:
  /// @param exitCode  128 and the signal's number, as shells have it
  void asked(int exitCode);

 private:
  void read();
  int mPipe[2] = {-1, -1};
  QSocketNotifier* mNotifier = nullptr;
};

}  // namespace velum::gui
