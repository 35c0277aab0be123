#include "gui/window/Start.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <QGuiApplication>
#include <QMessageBox>
#include <QMutex>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLWidget>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "core/Log.h"
#include "gpu/Context.h"
#include "gpu/GpuError.h"
#include "gpu/SoftwareDriver.h"
#include "gui/kit/CoreWords.h"
#include "gui/view/ViewSurface.h"

namespace velum::gui {

namespace {

constexpr std::size_t kMostSaid = 1000;  // bytes of a driver's own words

/// The messages that the handler, of which Qt has one for each process, has taken.
struct Taken {
  QMutex mutex;
  QStringList warnings, lines;
};

Taken& taken() {
  static Taken instance;
  return instance;
}

bool isUnset(const char* variable) { return qEnvironmentVariable(variable).isEmpty(); }

/// Why Qt finds no platform. @param warnings  what it has said of it; the last one only that it cannot go on
std::string whyNoPlatform(QStringList warnings) {
  if (isUnset("DISPLAY") && isUnset("WAYLAND_DISPLAY") && isUnset("QT_QPA_PLATFORM"))
    return "neither DISPLAY nor WAYLAND_DISPLAY is set";
  warnings.removeIf([](const QString& text) { return text.contains("even though it was found"); });
  return warnings.isEmpty() ? "Qt finds no platform" : warnings.join("; ").simplified().toStdString();
}

/// True where windows are on a screen that somebody can see.
bool hasScreen() {
  QString name = QGuiApplication::platformName();
  return !name.startsWith("offscreen") && !name.startsWith("minimal");
}

/// Everything that the 3D view will ask for. @throw gpu::GpuError
void tryOpenGl() {
  // Some platforms have contexts, but none for widgets; Qt says that in a warning only.
  { QOpenGLWidget widget; }
  if (!StartMessages::warnings().filter("QOpenGLWidget is not supported").isEmpty())
    throw gpu::GpuError(
        fmt::format("this display ({}) gives windows no OpenGL", QGuiApplication::platformName().toStdString()));
  QSurfaceFormat usual = QSurfaceFormat::defaultFormat(), robust = usual;
  robust.setOption(QSurfaceFormat::ResetNotification);
  QOffscreenSurface surface;
  surface.create();
  for (const QSurfaceFormat& format : {robust, usual}) {
    QOpenGLContext context;
    context.setFormat(format);
    bool isMade = context.create() && context.makeCurrent(&surface);
    bool isLast = !format.testOption(QSurfaceFormat::ResetNotification);
    if (!isMade && isLast) throw gpu::TooOld("the graphics driver makes no OpenGL context");
    if (!isMade || (!isLast && context.format().version() < usual.version())) continue;
    gpu::Context::adopt(
        [](const char* name) {
          return reinterpret_cast<void*>(QOpenGLContext::currentContext()->getProcAddress(name));
        },
        [] { return static_cast<const void*>(QOpenGLContext::currentContext()); });
    return QSurfaceFormat::setDefaultFormat(format);
  }
}

/// Takes what libraries write to stderr while it lives, so that it can be part of a line of ours; tells it at its end
/// where nobody took it. Does nothing where there is no room for a file.
class StderrAside {
 public:
  StderrAside() : mKept(std::tmpfile()) {
    if (!mKept) return;
    std::fflush(stderr);
    mStderr = ::fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
    if (mStderr >= 0) ::dup2(::fileno(mKept), STDERR_FILENO);
  }
  ~StderrAside() {
    QString said = take();
    if (!said.isEmpty()) log::say(said.toStdString());
  }
  StderrAside(const StderrAside&) = delete;
  StderrAside& operator=(const StderrAside&) = delete;

  /// Ends it. @return its lines in one, each once, not too many
  QString take() {
    if (!mKept) return {};
    if (mStderr >= 0) {
      std::fflush(stderr);
      ::dup2(mStderr, STDERR_FILENO);
      ::close(mStderr);
    }
    std::rewind(mKept);
    QByteArray bytes(kMostSaid, '\0');
    bytes.resize(int(std::fread(bytes.data(), 1, kMostSaid, mKept)));
    std::fclose(std::exchange(mKept, nullptr));
    QStringList lines;
    for (const QString& line : QString::fromUtf8(bytes).split('\n', Qt::SkipEmptyParts)) lines << line.simplified();
    lines.removeDuplicates();
    return lines.join("; ");
  }

 private:
  std::FILE* mKept;
  int mStderr = -1;
};

/// An error's words, with what libraries have said meanwhile.
std::string wordsOf(const gpu::GpuError& error, StderrAside& aside) {
  QString said = aside.take();
  return said.isEmpty() ? error.what() : fmt::format("{} (libraries say: {})", error.what(), said.toStdString());
}

/// Tries to draw beside the window system. @param why  not in it @throw gpu::GpuError that says both
BesideWindows tryBeside(const std::string& why) {
  StderrAside aside;
  try {
    gpu::Limits limits = gpu::Context::create(gpu::ContextKind::Auto)->limits();
    if (!why.empty()) aside.take();  // the caller says it
    return {why, limits.renderer, limits.isSoftware};
  } catch (const gpu::GpuError& error) {
    std::string words = wordsOf(error, aside);
    if (!words.starts_with(why)) words = why + "; " + words;
    throw gpu::GpuError(words);
  }
}

}  // namespace

StartMessages::StartMessages() : mBefore(qInstallMessageHandler(&StartMessages::take)) {}

StartMessages::~StartMessages() {
  qInstallMessageHandler(mBefore);
  QMutexLocker guard(&taken().mutex);
  for (const QString& line : taken().lines) log::say(line.toStdString());
  taken().lines.clear();
}

void StartMessages::drop() {
  QMutexLocker guard(&taken().mutex);
  taken().lines.clear();
}

QStringList StartMessages::warnings() {
  QMutexLocker guard(&taken().mutex);
  return taken().warnings;
}

void StartMessages::take(QtMsgType type, const QMessageLogContext& context, const QString& text) {
  if (type == QtFatalMsg) {
    log::say(
        fmt::format("velum: there is no display to open a window on ({}); start it in a graphical session, or use "
                    "velum-batch, which needs none",
                    whyNoPlatform(warnings())));
    std::_Exit(static_cast<int>(ExitCode::Gpu));  // Qt's threads and statics are half made
  }
  QMutexLocker guard(&taken().mutex);
  if (type != QtDebugMsg && type != QtInfoMsg) taken().warnings << text;
  taken().lines << qFormatLogMessage(type, context, text);
}

BesideWindows chooseSurface() {
  if (gpu::Context::kindOfEnvironment() != gpu::ContextKind::Auto) {
    tryBeside({});
    return {};
  }
  std::string why;
  {
    StderrAside aside;
    try {
      tryOpenGl();
      return {};
    } catch (const gpu::GpuError& error) {
      why = wordsOf(error, aside);
    }
  }
  BesideWindows beside = tryBeside(why);
  ViewSurface::drawBesideWindows();
  log::warning(beside.isSoftware
                   ? gpu::softwareInstead(why)
                   : fmt::format("{}: the 3D view is drawn beside the window, by {}", why, beside.renderer));
  return beside;
}

namespace {

QtMessageHandler gUsual = nullptr;

void passOn(QtMsgType type, const QMessageLogContext& context, const QString& text) {
  if (!text.startsWith("This plugin does not support ")) gUsual(type, context, text);
}

}  // namespace

void hushPlatform() { gUsual = qInstallMessageHandler(passOn); }

int refuseStart(const Error& error, bool asks) {
  log::say(fmt::format("velum: {}", error.what()));
  if (asks && hasScreen())
    QMessageBox::critical(nullptr, QGuiApplication::applicationDisplayName(),
                          QMessageBox::tr("Velum cannot start: %1").arg(inWords(error.what())));
  return static_cast<int>(error.exitCode());
}

}  // namespace velum::gui
