#pragma once
#include <QMessageLogContext>
#include <QStringList>
#include <string>

#include "core/Error.h"

/// Checks what the program needs of the machine before there is a window, and what is said where that is missing.
namespace velum::gui {

/// Keeps Qt's messages while this object lives; they are printed on stderr at its end unless drop() was called. Where
/// Qt would abort, as it finds no platform for windows, one line says why and the process ends with ExitCode::Gpu. Only
/// one such object at a time; to be made before QApplication.
class StartMessages {
 public:
  StartMessages();
  ~StartMessages();
  StartMessages(const StartMessages&) = delete;
  StartMessages& operator=(const StartMessages&) = delete;

  /// Forgets the messages, as the same was said in other words.
  void drop();
  /// What Qt has warned of so far, without categories.
  static QStringList warnings();

 private:
  static void take(QtMsgType type, const QMessageLogContext& context, const QString& text);
  QtMessageHandler mBefore;
};

/// A context beside the window system, where its own OpenGL will not do.
struct BesideWindows {
  std::string why;       ///< In words; empty: the window system's own draws, or VELUM_CONTEXT says what does.
  std::string renderer;  ///< What draws instead, as it calls itself.
  bool isSoftware = false;
};
/// Tries what the 3D view will need, and has views draw beside the window system where that gives no OpenGL 4.5 (see
/// ViewSurface); QApplication and a StartMessages must exist. Where the driver tells of resets, the default format asks
/// for that from then on. A driver that stands in is said on stderr.
/// @throw gpu::GpuError when nothing draws on this machine; ArgumentError when VELUM_CONTEXT names no kind of context
BesideWindows chooseSurface();

/// Lets Qt say nothing more of what its platforms without a screen do not do.
void hushPlatform();

/// Says on stderr why there will be no window. @param asks  also says so in a dialog, if there is a screen, and waits
/// until the dialog is closed
/// @return exit code
int refuseStart(const Error& error, bool asks);

}  // namespace velum::gui
