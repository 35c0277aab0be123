#include "gui/extrusion/PullPreview.h"

#include <utility>

#include "scene/Scene.h"

namespace velum::gui {

void PullPreview::begin() {
  clear();
  mIsOn = true;
}

void PullPreview::show(const scene::Scene& scene, const std::vector<session::Pulled>& pulled, glm::ivec2 size) {
  if (!mIsOn) return;
  mWish = Wish{scene, pulled, size};
  if (!mJob) start();
}

void PullPreview::start() {
  auto result = std::make_shared<session::PulledPicture>();
  mJob = std::make_unique<Job>(
      [wish = *std::exchange(mWish, std::nullopt), result](Progress& progress) {
        *result = session::drawPulled(wish.scene, wish.pulled, wish.size, progress);
      },
      nullptr, session::Urgency::Hand);
  connect(mJob.get(), &Job::finished, this, [this, result](bool done, const QString&) {
    mJob.release()->deleteLater();
    if (done) finish(*result);
    if (mWish) start();
  });
  mJob->start();
}

void PullPreview::finish(const session::PulledPicture& picture) {
  mImage = QImage(reinterpret_cast<const uchar*>(picture.pixels.data()), picture.width, picture.height,
                  QImage::Format_ARGB32_Premultiplied)
               .copy();
  ++mDrawnCount;
  emit drawn();
}

void PullPreview::end() {
  mJob.reset();  // cancels and waits
  mWish.reset();
  mIsOn = false;
}

void PullPreview::clear() {
  end();
  mImage = {};
}

}  // namespace velum::gui
