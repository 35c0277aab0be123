#pragma once
#include <QMessageLogContext>
#include <QStringList>

#include "core/Error.h"
#include "gpu/GpuError.h"

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

/// Tries what the 3D view will need; QApplication and a StartMessages must exist. Where the driver tells of resets, the
/// default format asks for that from then on. @throw gpu::TooOld when the driver makes no OpenGL 4.5; gpu::GpuError
/// when a window gets no OpenGL on this machine at all
void requireOpenGl();

/// Says on stderr why there will be no window. @param asks  also says so in a dialog, if there is a screen, and waits
/// until the dialog is closed
/// @return exit code
int refuseStart(const Error& error, bool asks);

}  // namespace velum::gui
