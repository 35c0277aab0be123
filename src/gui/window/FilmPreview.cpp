#include "gui/window/FilmPreview.h"

#include <QGridLayout>
#include <algorithm>
#include <cmath>

#include "core/Clock.h"
#include "gui/kit/CoreWords.h"
#include "gui/rows/PictureList.h"
#include "gui/service/CallLater.h"
#include "scene/timeline/SceneAt.h"
#include "session/Session.h"
#include "session/picture/Picture.h"

namespace velum::gui {

namespace {

constexpr double kTallest = 0.75;     ///< of a picture, in its width
constexpr int kFilmPatienceMs = 200;  ///< while numbers are being typed
constexpr int kLarger = 4;            ///< by which a picture is larger that tells how long pixels take

/// From the first frame of a film, or of a part of it, to the last one.
std::vector<double> momentsOf(const scene::Scene& film, const std::optional<session::FilmSpan>& span, int count) {
  scene::FilmFrames frames = scene::framesOf(film.timeline);
  double begin = span ? span->start : frames.start;
  double end = span ? span->start + span->seconds - 1.0 / frames.framesPerSecond : frames.timeOf(frames.count - 1);
  std::vector<double> moments;
  for (int i = 0; i < count; ++i) moments.push_back(begin + std::max(end - begin, 0.0) * i / (count - 1));
  return moments;
}

}  // namespace

FilmPreview::FilmPreview(int width, QWidget* parent) : QWidget(parent), mWidth(width), mJob(kFilmPatienceMs, this) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(6);
  grid->setVerticalSpacing(4);
  for (int i = 0; i < kPictures; ++i) {
    mPictures[i] = new QLabel(this);
    mPictures[i]->setFixedSize(mWidth, mWidth * 9 / 16);
    mPictures[i]->setAlignment(Qt::AlignCenter);
    mTimes[i] = new QLabel(this);
    mTimes[i]->setProperty("role", "muted");
    mTimes[i]->setAlignment(Qt::AlignCenter);
    grid->addWidget(mPictures[i], 0, i);
    grid->addWidget(mTimes[i], 1, i);
  }
  mTimes[kPictures / 2]->setText(tr("Drawing..."));
}

void FilmPreview::show(Asked asked) {
  double scale = mWidth * std::min(1.0 / asked.size.x, kTallest / asked.size.y);
  glm::ivec2 size = glm::max(glm::ivec2(glm::round(glm::dvec2(asked.size) * scale)), 1);
  for (QLabel* picture : mPictures) picture->setFixedHeight(std::max(size.y, mWidth * 9 / 16));
  int turn = ++mTurn;
  mJob.want(
      [this, asked = std::move(asked), size, turn] {
        return [this, asked, size, turn](Progress& progress) {
          std::string why;
          try {
            draw(asked, size, turn, progress);
          } catch (const Cancelled&) {
            throw;
          } catch (const std::exception& error) {
            why = error.what();
          }
          callLater(this, [this, turn, why] {
            if (turn == mTurn) emit told(inWords(why));
          });
        };
      },
      [] {});
}

/// In the job's thread.
void FilmPreview::draw(const Asked& asked, glm::ivec2 size, int turn, Progress& progress) {
  scene::Scene film = asked.film(progress);
  std::vector<double> moments = momentsOf(film, asked.span, kPictures);
  session::Session session(std::move(film));
  session::PictureOptions options;
  options.size = size;
  options.samples = 1;
  auto timed = [&] {
    auto start = Clock::now();
    session.picture(options, progress);
    return msSince(start);
  };
  double othersMs = 0.0;  // than the first, which waits for the data to reach the graphics card
  for (int i = 0; i < kPictures; ++i) {
    double time = moments[std::size_t(i)];
    auto start = Clock::now();
    session.document().setPlayhead(time);
    QImage picture = toQImage(session.picture(options, progress));
    if (i > 0) othersMs += msSince(start) / (kPictures - 1);
    callLater(this, [=, this] { take(turn, i, picture, time); });
  }
  if (!asked.measures) return;
  double smallMs = timed();
  options.size *= kLarger;
  timed();  // its textures are made
  double largeMs = timed(), moreMegapixels = 1e-6 * size.x * size.y * (kLarger * kLarger - 1);
  DrawingTime time{othersMs, std::max(largeMs - smallMs, 0.0) / moreMegapixels};
  callLater(this, [=, this] {
    if (turn == mTurn) emit measured(time);
  });
}

void FilmPreview::take(int turn, int place, const QImage& picture, double time) {
  if (turn != mTurn) return;
  mPictures[std::size_t(place)]->setPixmap(QPixmap::fromImage(picture));
  mTimes[std::size_t(place)]->setText(tr("%L1 s").arg(time, 0, 'f', 1));
}

}  // namespace velum::gui
