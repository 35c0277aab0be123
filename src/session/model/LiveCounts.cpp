#include "session/model/LiveCounts.h"

#include <algorithm>
#include <cmath>

namespace velum::session {

void LiveCounts::take(const Shared<Model>& model, const render::InstanceBits& bits, bool isComplete) {
  if (model != mModel) {
    clear();
    mModel = model;
    mCoarse.assign(model->types.size(), 0);
    mFactors.assign(model->types.size(), 1.0);
  }
  mTypes = render::countTypes(*model, bits);
  mIsExact = isComplete;
  for (std::size_t t = 0; t < mTypes.size(); ++t) {
    Counts& count = mTypes[t];
    if (isComplete) {
      if (mCoarse[t] > 0) mFactors[t] = std::max(1.0, double(count.visible()) / double(mCoarse[t]));
      continue;
    }
    mCoarse[t] = count.visible();
    std::uint64_t left = count.left();
    count[CountOf::Visible] = std::min(left, std::uint64_t(std::llround(double(count.visible()) * mFactors[t])));
    count[CountOf::Hidden] += left - count.left();
  }
  mCompartments = render::countCompartments(*model, mTypes);
}

}  // namespace velum::session
