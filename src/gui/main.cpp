#include <fmt/format.h>

#include <unistd.h>

#include <QApplication>
#include <QCommandLineParser>
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QFileInfo>
#include <QIcon>
#include <QPixmap>
#include <QSurfaceFormat>
#include <QTimer>
#include <clocale>
#include <cstdio>
#include <memory>
#include <string_view>
#include <vector>

#include "core/Error.h"
#include "core/GuardWrites.h"
#include "core/Log.h"
#include "gui/kit/CoreWords.h"
#include "gui/kit/Language.h"
#include "gui/kit/Preferences.h"
#include "gui/look/LookPanel.h"
#include "gui/service/SaveImage.h"
#include "gui/window/MainWindow.h"
#include "gui/window/QuitSignals.h"
#include "gui/window/Script.h"
#include "gui/window/Start.h"
#include "session/document/Folders.h"

namespace {

constexpr int kScreenshotWaitMs = 60'000;

/// One line on the console.
void say(const QString& text) { velum::log::say("velum: " + text.toStdString()); }

/// Saves the whole window once its picture is complete, then leaves.
void takeScreenshot(velum::gui::MainWindow& window, const QString& path) {
  auto* timer = new QTimer(&window);
  auto clock = std::make_shared<QElapsedTimer>();
  clock->start();
  QObject::connect(timer, &QTimer::timeout, &window, [&window, path, clock] {
    auto* look = window.findChild<velum::gui::LookPanel*>();
    bool ready = window.isSettled() && look->isComplete();
    if (!ready && clock->elapsed() < kScreenshotWaitMs) return;
    velum::ExitCode code = velum::ExitCode::Ok;
    try {
      velum::gui::saveImage(window.grab().toImage(), path.toStdString());
      if (window.messages().isVisible()) say(window.messages().text());
    } catch (const velum::Error& error) {
      say(error.what());
      code = error.exitCode();
    } catch (const std::exception& error) {
      say(error.what());
      code = velum::ExitCode::Input;
    }
    QCoreApplication::exit(static_cast<int>(code));
  });
  timer->start(100);
}

/// @throw InputError when there is no such file
void runScript(velum::gui::MainWindow& window, const QString& path, bool echo) {
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly))
    throw velum::InputError(fmt::format("{}: {}", path.toStdString(), file.errorString().toStdString()));
  auto* script = new velum::gui::Script(window, path, QString::fromUtf8(file.readAll()));
  script->setEcho(echo);
  QObject::connect(script, &velum::gui::Script::failed, &window, [&window](const QString& error, int code) {
    say(error);
    window.leave(code);
  });
  script->start();
}

void describeOptions(QCommandLineParser& parser) {
  parser.setApplicationDescription("Volumes, cut open the way illustrators do. Not a medical device.");
  parser.addHelpOption();
  parser.addVersionOption();
  parser.addOption({"screenshot", "Save a picture of the window once it is complete, and leave.", "file"});
  parser.addOption({"script", "Run the commands of a file, one a line; the user guide lists them.", "file"});
  parser.addOption(
      {"echo", "With --script: say each line when it is done, with the time and the memory that is allocated."});
  parser.addOption({"language", "The language of the window, en or de; else that of the preferences.", "code"});
  parser.addPositionalArgument("files", "What to open: a volume, then labels and surfaces; a folder; a scene.",
                               "[files...]");
}

/// Qt says so on the console where there is none.
void provideRuntimeFolder() {
  if (qEnvironmentVariableIsSet("XDG_RUNTIME_DIR")) return;
  QString folder = QDir::temp().filePath(QString("runtime-%1").arg(getuid()));
  QDir().mkpath(folder);
  QFile::setPermissions(folder, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
  qputenv("XDG_RUNTIME_DIR", folder.toUtf8());
}

/// All windows but the first, which is the caller's.
std::vector<velum::gui::MainWindow*> otherWindows(const velum::gui::MainWindow& first) {
  std::vector<velum::gui::MainWindow*> found;
  for (QWidget* widget : QApplication::topLevelWidgets())
    if (auto* window = qobject_cast<velum::gui::MainWindow*>(widget); window && window != &first)
      found.push_back(window);
  return found;
}

/// Until the last window is closed, the script says so, or the system does. @return exit code
int runWindows(velum::gui::MainWindow& window) {
  velum::gui::QuitSignals quitSignals;
  QObject::connect(&quitSignals, &velum::gui::QuitSignals::asked, &window, [&window](int exitCode) {
    window.abandon();
    for (auto* other : otherWindows(window)) other->abandon();
    QCoreApplication::exit(exitCode);
  });
  int exitCode = QApplication::exec();
  for (auto* other : otherWindows(window)) delete other;
  return exitCode;
}

/// Where something draws in place of the window system. @param opens  a job follows, which clears the messages
void tellOfSurface(velum::gui::MainWindow& window, const velum::gui::BesideWindows& beside, bool opens) {
  if (beside.why.empty()) return;
  using velum::gui::MainWindow;
  QString why = velum::gui::inWords(beside.why);
  QString words = beside.isSoftware
                      ? MainWindow::tr(
                            "%1, and OpenGL 4.5 is needed: Mesa's software driver draws instead, which is "
                            "slower. Install or update the graphics driver to draw with the card.")
                            .arg(why)
                      : MainWindow::tr("%1: the 3D view is drawn beside the window, by %2.")
                            .arg(why, QString::fromStdString(beside.renderer));
  auto show = [&window, words] {
    if (!window.messages().isVisible()) window.messages().showNote(words);  // else why nothing was opened
  };
  if (!opens) return show();
  QObject::connect(&window, &MainWindow::jobEnded, &window, show, Qt::SingleShotConnection);
}

int run(int argc, char** argv) {
  provideRuntimeFolder();
  auto messages = std::make_unique<velum::gui::StartMessages>();
  QSurfaceFormat format;
  format.setVersion(4, 5);
  format.setProfile(QSurfaceFormat::CoreProfile);
  QSurfaceFormat::setDefaultFormat(format);
  QApplication application(argc, argv);
  // Qt takes the user's locale for C's functions, too. Libraries that read files by them would take 0.5 for 0 where 0,5
  // is written.
  std::setlocale(LC_NUMERIC, "C");
  QApplication::setApplicationName("velum");
  QApplication::setApplicationDisplayName("Velum");
  QApplication::setApplicationVersion(VELUM_VERSION);
  QApplication::setDesktopFileName("io.github.velum.Velum");
  QApplication::setWindowIcon(QIcon(":/velum/velum.svg"));
  velum::gui::applyTheme(application, velum::gui::Preferences().theme());
  velum::setMemoryBudget(velum::gui::Preferences().memory());
  int memory = velum::gui::Preferences().graphicsMemory();
  if (memory > 0 && !qEnvironmentVariableIsSet("VELUM_GPU_MEMORY_MB"))
    qputenv("VELUM_GPU_MEMORY_MB", QByteArray::number(memory));

  QCommandLineParser parser;
  describeOptions(parser);
  if (!parser.parse(QApplication::arguments())) {
    say(parser.errorText() + "; see velum --help");
    return static_cast<int>(velum::ExitCode::Usage);
  }
  velum::gui::speak(parser.isSet("language") ? parser.value("language") : velum::gui::Preferences().language());
  for (const QString& path : parser.positionalArguments())
    if (!QFileInfo::exists(path)) {
      say(path + ": there is no such file or folder");
      return static_cast<int>(velum::ExitCode::Input);
    }

  velum::gui::BesideWindows beside;
  try {
    beside = velum::gui::chooseSurface();
    if (!beside.why.empty()) messages->drop();  // of what will not be used
  } catch (const velum::Error& error) {
    messages->drop();
    return velum::gui::refuseStart(error, !parser.isSet("script") && !parser.isSet("screenshot"));
  }
  messages.reset();
  if (!beside.why.empty()) velum::gui::hushPlatform();

  velum::gui::MainWindow window;
  window.show();
  tellOfSurface(window, beside, !parser.positionalArguments().isEmpty());
  window.protectWork(velum::session::recoveryFolder(), !parser.isSet("screenshot"));
  window.openPaths(parser.positionalArguments());
  if (parser.isSet("script")) runScript(window, parser.value("script"), parser.isSet("echo"));
  if (parser.isSet("screenshot")) takeScreenshot(window, parser.value("screenshot"));
  return runWindows(window);
}

}  // namespace

int main(int argc, char** argv) {
  velum::guardWrites();
  // Version and help need no display.
  for (int i = 1; i < argc; ++i) {
    std::string_view word = argv[i];
    if (word == "--version" || word == "-v") {
      fmt::print("velum {} (not a medical device)\n", VELUM_VERSION);
      return 0;
    }
    if (word == "--help" || word == "-h") {
      QCoreApplication application(argc, argv);
      QCommandLineParser parser;
      describeOptions(parser);
      fmt::print("{}", parser.helpText().toStdString());
      return 0;
    }
  }
  try {
    return run(argc, argv);
  } catch (const velum::Error& error) {
    say(error.what());
    return static_cast<int>(error.exitCode());
  } catch (const std::exception& error) {
    say(error.what());
    return static_cast<int>(velum::ExitCode::Input);
  }
}
