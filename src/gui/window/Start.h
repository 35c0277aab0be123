#pragma once
#include <QMessageLogContext>
#include <QStringList>

#include "core/Error.h"

/// What the program needs of the machine before there is a window.
namespace velum::gui {

/// Keeps what Qt says while it lives, which is told on stderr at its end unless it was dropped. Where Qt would abort,
/// for it can make no platform, one line says why and the process ends with ExitCode::Gpu. One at a time; made before
/// QApplication.
class StartMessages {
 public:
  StartMessages();
  ~StartMessages();
  StartMessages(const StartMessages&) = delete;
  StartMessages& operator=(const StartMessages&) = delete;

  /// It was said in other words.
  void drop();
  /// What Qt has warned of so far, without categories.
  static QStringList warnings();

 private:
  static void take(QtMsgType type, const QMessageLogContext& context, const QString& text);
  QtMessageHandler mBefore;
};

/// Tries what the 3D view will need. QApplication and a StartMessages live. @throw gpu::GpuError when windows get no
/// OpenGL 4.5 here
void requireOpenGl();

/// Says on stderr why there will be no window. @param asks  also in a dialog, where somebody can see it, and waits
/// until that is closed
/// @return exit code
int refuseStart(const Error& error, bool asks);

}  // namespace velum::gui
