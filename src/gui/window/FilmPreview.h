#pragma once
#include <QLabel>
#include <QWidget>
#include <array>
#include <functional>
#include <glm/glm.hpp>

#include "gui/service/NewestJob.h"
#include "scene/SceneFwd.h"
#include "session/film/ReadyFilms.h"

namespace velum::gui {

/// How long pictures take, as the preview has found: a picture of `megapixels` with `samples` takes
/// fixedMs + msPerMegapixel * megapixels * samples.
struct DrawingTime {
  double fixedMs = 0.0, msPerMegapixel = 0.0;
};

/// Small pictures of a film in a row, from its first to its last frame, with their times below, drawn in the
/// background anew whenever the film changes.
class FilmPreview : public QWidget {
  Q_OBJECT
 public:
  /// @param width  of each picture, pixels
  FilmPreview(int width, QWidget* parent);
  /// What is to be shown, and whether it is to be found out how long pictures take.
  struct Asked {
    std::function<scene::Scene(Progress&)> film;  ///< makes its scene; called in another thread, and may throw
    std::optional<session::FilmSpan> span;        ///< part of the film; none: the timeline's range
    glm::ivec2 size{16, 9};                       ///< of the film's frames, or numbers of their proportion
    bool measures = false;
  };
  void show(Asked asked);
  /// The pictures show what was asked for last, or cannot.
  bool isDone() const { return !mJob.isBusy(); }

 signals:
  void measured(velum::gui::DrawingTime time);
  /// @param why  the film cannot be made, or drawn, one line; empty: it can
  void told(const QString& why);

 private:
  static constexpr int kPictures = 5;
  void draw(const Asked& asked, glm::ivec2 size, int turn, Progress& progress);
  void take(int turn, int place, const QImage& picture, double time);

  const int mWidth;
  std::array<QLabel*, kPictures> mPictures, mTimes;
  int mTurn = 0;  ///< counts the calls of show(), so that pictures of an earlier call are known
  NewestJob mJob;
};

}  // namespace velum::gui
