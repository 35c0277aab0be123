#pragma once
#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>
#include <string>

#include "scene/SceneFwd.h"

namespace velum::gui {

/// Lies over a view whose picture is not that of the scene: dim where the picture is an older one of the same data,
/// opaque where the picture is of other data and could be taken for the scene's. Says "Preparing", or that there will
/// be no picture. Lets the mouse through.
class PreparingVeil : public QWidget {
  Q_OBJECT
 public:
  enum class Kind { None, Dim, Closed, Failed };

  /// @param view  the view that the veil covers, and whose size it follows
  explicit PreparingVeil(QWidget& view);

  /// The view's picture is no longer the scene's: a picture of other data is covered at once, an older picture of the
  /// same data is dimmed if the new one takes long.
  void await(const scene::Scene& scene);
  /// Dims the picture at once, as a long piece of work comes next during which nothing is painted.
  void awaitLong();
  /// A picture of this scene is on the screen.
  void lift(const scene::Scene& shown);
  /// There will be no picture.
  void fail();
  /// There is no picture any more.
  void forget();

  Kind kind() const { return mKind; }
  bool hasFailed() const { return mHasFailed; }
  /// True when the veil has changed and is about to be painted: no long work may begin before.
  bool awaitsPaint() const;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void set(Kind kind);

  Kind mKind = Kind::None;
  std::string mShown;  ///< The data whose picture is on the screen; empty: there is no picture.
  bool mHasFailed = false, mAwaitsPaint = false;
  QTimer mPatience;
  QElapsedTimer mSinceSet;
};

}  // namespace velum::gui
