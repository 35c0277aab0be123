#pragma once
#include <QImage>
#include <QObject>
#include <memory>
#include <optional>
#include <vector>

#include "gui/service/Job.h"
#include "scene/Scene.h"
#include "session/extrusion/PulledPicture.h"

namespace velum::gui {

/// What is found while a hand pulls, over the picture that stands. Drawn in a thread, one picture at a time, the newest
/// wish first: what moves the pointer's label never waits for it.
class PullPreview : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  /// A drag begins.
  void begin();
  /// Draws as soon as what is being drawn is done; of several wishes the last one. Does nothing before begin().
  void show(const scene::Scene& scene, const std::vector<session::Pulled>& pulled, glm::ivec2 size);
  /// What is being drawn is given up; the last picture stays until clear().
  void end();
  void clear();

  /// Empty while there is none.
  const QImage& image() const { return mImage; }
  bool isOn() const { return mIsOn; }
  /// Pictures that have come; for tests and measurements.
  int drawnCount() const { return mDrawnCount; }

 signals:
  /// Another image.
  void drawn();

 private:
  struct Wish {
    scene::Scene scene;
    std::vector<session::Pulled> pulled;
    glm::ivec2 size{0};
  };
  void start();
  void finish(const session::PulledPicture& picture);

  bool mIsOn = false;
  std::optional<Wish> mWish;
  std::unique_ptr<Job> mJob;
  QImage mImage;
  int mDrawnCount = 0;
};

}  // namespace velum::gui
