// What is shown of a live sheet, and what is kept of it where it rests.
#include "gpu/Allocation.h"
#include "gpu/GpuError.h"
#include "gpu/Program.h"
#include "membrane/sheet/SheetIndex.h"
#include "session/membrane/LiveSheet.h"

namespace velum::session {

/// Where the sheet is seen. Asks the GPU where it moves, once for each place: what is held can be exported from a menu,
/// where no context is current.
const SheetPlace& LiveSheet::seenPlace() const {
  if (!mMotion.isInSight()) return mPlace;
  if (mShown.readAt == mShown.count) return mShown.read;
  if (mMotion.isInterrupted()) return mPlace;  // until it is resumed
  mShown.read = mMotion.place();
  mShown.readAt = mShown.count;
  return mShown.read;
}

render::FrameSheet LiveSheet::frameSheet() {
  try {
    return upload();
  } catch (const gpu::GpuError&) {
    mShown.sheet.reset();  // half of it may be of another place
    throw;
  }
}

render::FrameSheet LiveSheet::upload() {
  bool isLive = mMotion.isInSight() && haveSameFrame(mMotion.cut(), mCut);
  auto& sheet = mShown.sheet;
  if (mShown.uploaded != mShown.count || !sheet) {
    glm::ivec2 flat = glm::max(mCut.membrane->cloth.particles, glm::ivec2(3));
    glm::ivec2 count = isLive ? mMotion.simulation().particles() : glm::ivec2(0);
    auto fits = [&] { return isLive && sheet->particles() == count && sheet->size() == mCut.size; };
    bool isMade = !sheet || !fits();
    if (!sheet)
      sheet = std::make_shared<membrane::Sheet>(shape(), flat, mCut.size);
    else if (!fits())
      sheet->setShape(shape(), flat, mCut.size);
    if (fits()) {
      // From the solver to the picture without a detour.
      mMotion.simulation().places().copyTo(sheet->rows(), 0);
      gpu::barrier();
      sheet->index();
    }
    bool hasGrown = mMotion.isAtRest() && sheet->grow();
    if (isMade || hasGrown) gpu::throwIfExhausted();
    mShown.uploaded = mShown.count;
  }
  return {sheet, sheet->revision()};
}

void LiveSheet::makeIndex() {
  glm::ivec2 flat = glm::max(mCut.membrane->cloth.particles, glm::ivec2(3));
  mShown.index = std::make_shared<const membrane::SheetIndex>(membrane::makeSheetIndex(shape(), flat, mCut.size));
  mShown.indexed = mShown.count;
}

bool LiveSheet::hasRest() const {
  if (!isActive() || !mCut.enabled || mAsked.isDue || isMoving() || mPlace.isFlat()) return false;
  return haveSameFrame(mPlace.cut, mCut) && mPlace.shape != mWritten;
}

std::optional<scene::SheetShape> LiveSheet::takeRest() {
  if (!hasRest()) return std::nullopt;
  mWritten = mPlace.shape;
  return mWritten;
}

}  // namespace velum::session
