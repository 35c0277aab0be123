#include "core/BorderValues.h"

#include <algorithm>
#include <limits>

#include "core/Error.h"
#include "core/FinestVoxels.h"

namespace velum {

float BorderValues::at(const ValueBorder& border, glm::ivec3 voxel) {
  if (!border.volume->finer) return float(valueAt(*border.volume, voxel, border.channel, border.timeStep));
  const Volume& part = partOf(border);
  return part.voxels.empty() ? std::numeric_limits<float>::quiet_NaN() : float(valueAt(part, voxel - mFirst));
}

const Volume& BorderValues::partOf(const ValueBorder& border) {
  for (const Part& part : mParts)
    if (part.border->volume == border.volume && part.border->channel == border.channel &&
        part.border->timeStep == border.timeStep)
      return part.values;
  Part part{&border, {}};
  try {
    part.values = FinestVoxels(*border.volume).read(mFirst, mEnd - mFirst, border.channel, border.timeStep);
  } catch (const InputError&) {  // stays empty
  }
  return mParts.emplace_back(std::move(part)).values;
}

}  // namespace velum
