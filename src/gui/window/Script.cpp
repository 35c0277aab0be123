#include "gui/window/Script.h"

#include <fmt/format.h>

#include <QFileInfo>
#include <chrono>
#include <cstdio>

#include "core/Error.h"
#include "core/Memory.h"
#include "gui/service/SaveImage.h"
#include "gui/window/FilmCommands.h"
#include "gui/window/MainWindow.h"
#include "session/command/Command.h"
#include "session/command/DocumentCommands.h"
#include "session/command/SaveFilm.h"

namespace velum::gui {

namespace {

constexpr int kPollMs = 5, kMostMs = 300'000, kLongestWaitMs = 600'000;

double monotonicSeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

int wholeNumber(const QString& text, int least, int most, const QString& what) {
  bool ok = false;
  int value = text.toInt(&ok);
  if (!ok || value < least || value > most)
    throw ArgumentError(
        fmt::format("'{}' is not {}, a whole number of {} to {}", text.toStdString(), what.toStdString(), least, most));
  return value;
}

QString wholePath(const QString& text) {
  if (text.isEmpty()) throw ArgumentError("a path is missing");
  return QFileInfo(text).absoluteFilePath();
}

}  // namespace

Script::Script(MainWindow& window, QString name, const QString& text)
    : QObject(&window), mWindow(window), mName(std::move(name)), mLines(text.split('\n')) {
  connect(&mTimer, &QTimer::timeout, this, &Script::check);
  connect(&window.jobs(), &JobRunner::cancelled, this, [this] { mIsInterrupted = mTimer.isActive(); });
}

void Script::start() {
  mWindow.setUnattended(true);
  // The files that the command line names are read first.
  waitFor([this] { return !mWindow.isBusy() && !mWindow.isLookingForWork(); }, kMostMs, "the files");
}

void Script::stop() {
  mTimer.stop();
  mWindow.setUnattended(false);
}

void Script::interrupt() {
  stop();
  MessageBar& messages = mWindow.messages();
  // What was stopped may have said what is there of it.
  QString said = messages.isVisible() ? messages.text() : tr("Stopped");
  messages.showNote(tr("%1; line %2 of the script was the last.").arg(said).arg(mLine));
  emit interrupted();
}

/// A line that has to wait goes on in check().
void Script::next() {
  while (!mReady) {
    if (mLine == mLines.size()) {
      stop();
      emit finished();
      return;
    }
    QString line = mLines[mLine++].trimmed();
    if (line.isEmpty() || line.startsWith('#')) continue;
    try {
      run(line.section(' ', 0, 0), line.section(' ', 1).trimmed());
    } catch (const std::exception& error) {
      stop();
      auto* ours = dynamic_cast<const Error*>(&error);
      emit failed(QString("%1:%2: %3").arg(mName).arg(mLine).arg(QString::fromUtf8(error.what())),
                  static_cast<int>(ours ? ours->exitCode() : ExitCode::Input));
      return;
    }
    if (line == "quit") return stop();
    if (mReady) return;
    // One line an event: the window draws and answers in between.
    say();
    waitFor([] { return true; }, kMostMs, {});
    mIsSaid = true;
  }
}

void Script::say() const {
  if (!mEcho || mLine == 0) return;
  std::string line = fmt::format("{:.3f} s, {:.1f} MiB: {}\n", monotonicSeconds(), double(allocatedBytes()) / (1 << 20),
                                 mLines[mLine - 1].trimmed().toStdString());
  std::fputs(line.c_str(), stdout);  // a reader that has gone does not stop the script
  std::fflush(stdout);
}

void Script::check() {
  if (mReady && !mReady()) {
    mTimer.setInterval(kPollMs);
    if (mWaited.elapsed() < mMostMs) return;
    stop();
    emit failed(QString("%1:%2: waited too long for %3").arg(mName).arg(mLine).arg(mWhat), 2);
    return;
  }
  mReady = {};
  mTimer.stop();
  if (QString error = mWindow.lastError(); !error.isEmpty()) {
    stop();
    emit failed(mLine == 0 ? error : QString("%1:%2: %3").arg(mName).arg(mLine).arg(error), 2);
    return;
  }
  if (mIsInterrupted) return interrupt();
  if (!mIsSaid) say();
  mIsSaid = false;
  next();
}

void Script::waitFor(std::function<bool()> ready, int mostMs, const QString& what) {
  mReady = std::move(ready);
  mMostMs = mostMs;
  mWhat = what;
  mWaited.start();
  mTimer.start(0);
}

void Script::run(const QString& command, const QString& rest) {
  if (runAction(command, rest) || runFile(command, rest)) return;
  if (command == "wait") {
    int ms = wholeNumber(rest, 0, kLongestWaitMs, "milliseconds");
    waitFor([this, ms] { return mWaited.elapsed() >= ms; }, kLongestWaitMs + 1000, {});
  } else if (command == "settle") {
    waitFor([this] { return mWindow.isSettled(); }, kMostMs, "the picture");
  } else if (command == "page") {
    if (!mWindow.tabs().showPage(rest))
      throw ArgumentError(fmt::format("'{}' is no page of the side panel", rest.toStdString()));
  } else if (command == "size") {
    mWindow.resize(wholeNumber(rest.section(' ', 0, 0), 200, 16384, "a width"),
                   wholeNumber(rest.section(' ', 1), 200, 16384, "a height"));
  } else if (command == "quit") {
    mWindow.leave(0);
  } else {
    runCommand(rest.isEmpty() ? command : command + ' ' + rest);
  }
}

bool Script::runAction(const QString& command, const QString& rest) {
  if (command != "do") return false;
  QAction* action = mWindow.actions().find(rest);
  if (!action) throw ArgumentError(fmt::format("'{}' is no command of the window", rest.toStdString()));
  if (!action->isEnabled()) throw InputError(fmt::format("{}: cannot be done now", rest.toStdString()));
  action->trigger();
  waitFor([this] { return !mWindow.isBusy(); }, kMostMs, rest);
  return true;
}

/// Runs a command that scripts without a window have, too. Here long commands are jobs.
void Script::runCommand(const QString& line) {
  session::Call call = session::parseCall(line.toStdString());
  bool isLong = !call.command().act && session::isLong(mWindow.document().shown(), call);
  if (isLong) {
    mWindow.jobs().run(call);
    return waitFor([this] { return !mWindow.isBusy(); }, kMostMs, line);
  }
  Progress progress;
  auto told = session::run(mWindow.session(), call, progress);
  if (!call.command().answers && !told.empty()) return mWindow.messages().showNote({}, told);
  for (const std::string& answer : told) fmt::print("{}\n", answer);
  std::fflush(stdout);
}

/// Runs the commands that the window does in its own way: it shows what was read, and draws pictures in the background.
bool Script::runFile(const QString& command, const QString& rest) {
  auto waitForJob = [this](const QString& what) { waitFor([this] { return !mWindow.isBusy(); }, kMostMs, what); };
  auto argumentsOf = [&]<class Arguments>(Arguments) {
    return std::any_cast<Arguments>(session::parseCall((command + ' ' + rest).toStdString()).arguments());
  };
  auto open = [&](const std::string& name, bool add) {
    QString path = wholePath(QString::fromStdString(name));
    if (!QFileInfo::exists(path))
      throw InputError(fmt::format("{}: there is no such file or folder", path.toStdString()));
    mWindow.openPaths({path}, add);
    waitForJob(path);
  };
  if (command == "open") {
    auto file = argumentsOf(session::OpenFile{});
    session::OpenFile plain;
    plain.path = file.path;
    if (!(plain == file)) return false;
    open(file.path, false);
  } else if (command == "add") {
    auto file = argumentsOf(session::AddFile{});
    if (file.asLabels) return false;
    open(file.path, true);
  } else if (command == "recover") {
    if (!mWindow.restoreWork()) throw InputError("no unsaved work was left behind");
    waitForJob("the recovered work");
  } else if (command == "save") {
    mWindow.saveSceneTo(
        QString::fromStdString(session::pathToSave(mWindow.session().file(), argumentsOf(session::SaveScene{}))));
  } else if (command == "picture") {
    auto picture = argumentsOf(session::MakePicture{});
    QString path = wholePath(QString::fromStdString(picture.path));
    mWindow.exports().savePictureTo(path, session::optionsOf(picture), mWindow.document().shown());
    waitForJob(path);
  } else if (command == "film.save") {
    auto film = argumentsOf(session::SaveFilm{});
    Progress progress;
    mWindow.films().saveFilmTo(session::outputOf(film),
                               session::filmedScene(mWindow.document().scene(), film, progress));
    waitForJob(QString::fromStdString(film.path));
  } else if (command == "screenshot") {
    saveImage(mWindow.grab().toImage(), wholePath(rest).toStdString());
  } else {
    return false;
  }
  return true;
}

}  // namespace velum::gui
