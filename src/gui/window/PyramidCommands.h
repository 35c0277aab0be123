#pragma once
#include <QElapsedTimer>
#include <QMessageBox>
#include <QPointer>

#include "gui/service/Job.h"
#include "gui/view/Room.h"
#include "gui/window/FileLoads.h"
#include "session/document/PyramidBeside.h"

namespace velum::gui {

/// Offers to make a pyramid beside a large file, makes it while the window goes on working, and lets the document use
/// it. Once for a file after it was opened; at any time by the Edit menu.
class PyramidCommands : public Room {
  Q_OBJECT
 public:
  PyramidCommands(const WindowParts& parts, FileLoads& loads);
  void refresh(const session::Session& session) override;
  /// True while a pyramid is being written.
  bool isWriting() const { return mJob != nullptr; }

 signals:
  /// The volume that is open is to be read from another source. @param step  what the undo step is called
  void sourceWanted(const QString& step, const velum::scene::Source& source);
  /// A file is to be opened in the place of what is open.
  void openWanted(const QString& path);

 private:
  enum class Why { Asked, Opened, TooLarge };
  void look(const scene::Source& source, Why why);
  void offer(const scene::Source& source, const session::PyramidBeside& plan, Why why);
  void write(const scene::Source& source, const session::PyramidBeside& plan);
  void showProgress(double fraction, const QString& what);
  void ended(bool done, const QString& error);
  void use(const scene::Source& source, const QString& pyramid);
  bool isOpen(const scene::Source& source) const;

  FileLoads& mLoads;
  QAction* mMake;
  ProgressStrip* mStrip;
  QPointer<QMessageBox> mOffer;
  Job* mLook = nullptr;
  Job* mJob = nullptr;
  scene::Source mSource;  ///< of the file whose pyramid is being written
  QString mPath;          ///< of that pyramid
  QElapsedTimer mSince;
  double mFirst = -1;  ///< fraction that was there when this writer began
};

}  // namespace velum::gui
