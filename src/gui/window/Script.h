#pragma once
#include <QElapsedTimer>
#include <QObject>
#include <QStringList>
#include <QTimer>
#include <functional>

namespace velum::gui {

class MainWindow;

/// Drives a window by a text, one command a line; the user guide lists them. Nothing is asked while it runs. The
/// window's thread; events go on between lines.
class Script : public QObject {
  Q_OBJECT
 public:
  /// @param name  of the text, for errors
  Script(MainWindow& window, QString name, const QString& text);

  void start();
  /// Sets whether each line is printed on stdout when it is done, with the time of the monotonic clock in seconds
  /// before it.
  void setEcho(bool echo) { mEcho = echo; }

 signals:
  /// The last line is done.
  void finished();
  /// A line has failed, and no further line is run. @param error  one line with file and line number  @param exitCode
  /// 1 usage, 2 input
  void failed(const QString& error, int exitCode);
  /// The user has stopped what a line does, and no further line is run: the window is the user's.
  void interrupted();

 private:
  void next();
  void run(const QString& command, const QString& rest);
  bool runAction(const QString& command, const QString& rest);
  void runCommand(const QString& line);
  bool runFile(const QString& command, const QString& rest);
  void waitFor(std::function<bool()> ready, int mostMs, const QString& what);
  void check();
  void say() const;
  void stop();
  void interrupt();

  MainWindow& mWindow;
  QString mName;
  QStringList mLines;
  int mLine = 0;  ///< number of the line that runs, from 1
  bool mEcho = false;
  bool mIsSaid = false;
  bool mIsInterrupted = false;   ///< by the user, in this line
  std::function<bool()> mReady;  ///< what the line waits for; empty: nothing
  int mMostMs = 0;
  QString mWhat;
  QElapsedTimer mWaited;
  QTimer mTimer;
};

}  // namespace velum::gui
