#pragma once
#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>
#include <string>

#include "scene/SceneFwd.h"

namespace velum::gui {

/// What lies over a view whose picture is not that of the scene: dim where the picture is an older one of the same
/// data, closed where it is one of other data, which could be taken for these. Says "Preparing", or that there will be
/// none. Lets the mouse through.
class PreparingVeil : public QWidget {
  Q_OBJECT
 public:
  enum class Kind { None, Dim, Closed, Failed };

  /// @param view  that it covers, whatever its size
  explicit PreparingVeil(QWidget& view);

  /// The view's picture is no longer the scene's: other data's is not seen any more, an older one of the same data is
  /// dimmed where the new one is long in coming.
  void await(const scene::Scene& scene);
  /// The same at once: a long piece of work is next, while which nothing is painted.
  void awaitLong();
  /// A picture of this scene is on the screen.
  void lift(const scene::Scene& shown);
  /// There will be no picture.
  void fail();
  /// There is no picture any more.
  void forget();

  Kind kind() const { return mKind; }
  bool hasFailed() const { return mHasFailed; }
  /// It is not on the screen yet as it is, and will soon be: what it covers must not be held up before.
  bool awaitsPaint() const;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void set(Kind kind);

  Kind mKind = Kind::None;
  std::string mShown;  ///< Whose picture is on the screen; empty: there is none.
  bool mHasFailed = false, mAwaitsPaint = false;
  QTimer mPatience;
  QElapsedTimer mSinceSet;
};

}  // namespace velum::gui
