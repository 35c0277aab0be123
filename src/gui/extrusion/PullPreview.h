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

/// A picture of what is found while the user pulls, shown over the view's picture, which stands still meanwhile. It is
/// drawn in a thread of its own, one picture at a time, the newest request first: the window's thread, which moves the
/// pointer's label, never waits for it.
class PullPreview : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  /// A drag begins.
  void begin();
  /// Draws as soon as the picture that is being drawn is done; of several requests only the last one. Does nothing
  /// before begin().
  void show(const scene::Scene& scene, const std::vector<session::Pulled>& pulled, glm::ivec2 size);
  /// A drag ends: the picture that is being drawn is given up; the last complete one stays until clear().
  void end();
  void clear();

  /// The last picture that was drawn; null while there is none.
  const QImage& image() const { return mImage; }
  bool isOn() const { return mIsOn; }
  /// How many pictures have been drawn; for tests and measurements.
  int drawnCount() const { return mDrawnCount; }

 signals:
  /// image() has changed.
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
