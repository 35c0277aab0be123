#include "core/BrickCache.h"
#include "core/Error.h"
#include "core/Parallel.h"
#include "gui/view/SectionView.h"

namespace velum::gui {

/// Of a streamed volume: what the section lacks is read beside the window, some at a time, and drawn as it comes.
void SectionView::fetchBricks() {
  constexpr std::size_t kAtATime = 48;
  std::vector<BrickAddress> missing = mImage.missing;
  // What could not be read the last time is not asked for for ever.
  if (missing.empty() || missing == mAskedBricks) return;
  mAskedBricks = missing;
  if (missing.size() > kAtATime) missing.resize(kAtATime);
  auto bricks = mWanted.volume.data->finer->bricks;
  mBricks.want(
      [bricks, missing] {
        return [bricks, missing](Progress& progress) {
          parallelFor(std::size_t(0), missing.size(), [&](std::size_t i) {
            if (progress.isCancelled()) return;
            try {
              bricks->brick(missing[i]);
            } catch (const InputError&) {  // it stays coarse, and the picture says so
            }
          });
        };
      },
      [this] {
        mStale = true;
        update();
      });
}

}  // namespace velum::gui
