#include "io/stores/ZarrSource.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "io/read/Placement.h"
#include "io/stores/AxisUnits.h"
#include "io/stores/CopySamples.h"
#include "io/stores/OmeGroup.h"
#include "io/stores/OwnAttributes.h"
#include "io/stores/PyramidPlan.h"

namespace velum::io {

namespace {

using Role = OmeAxis::Role;

/// The axis that has a part; none where the image has no such axis.
std::optional<std::size_t> axisOf(const OmeImage& image, Role role) {
  for (std::size_t i = 0; i < image.axes.size(); ++i)
    if (image.axes[i].role == role) return i;
  return std::nullopt;
}

constexpr Role kSpace[] = {Role::X, Role::Y, Role::Z};

int sizeAlong(const std::vector<std::uint64_t>& sizes, std::optional<std::size_t> axis) {
  return axis ? int(std::min<std::uint64_t>(sizes[*axis], std::numeric_limits<int>::max())) : 1;
}

}  // namespace

ZarrSource::ZarrSource(std::shared_ptr<const Store> store, OmeImage image, std::vector<std::string> notes)
    : mStore(std::move(store)), mImage(std::move(image)) {
  mHead.warnings = std::move(notes);
  for (const OmeLevel& level : mImage.levels) openLevel(level);
  describeHead();
  placeLevels();
  takeOwnAttributes();
  describeFacts();
}

void ZarrSource::openLevel(const OmeLevel& level) {
  auto array = readZarrArray(*mStore, level.key);
  Path path = mStore->pathOf(level.key);
  if (!array) refuse(path, "the array of a level is missing");
  if (array->shape.size() != mImage.axes.size())
    refuse(path, fmt::format("it has {} axes, where its image has {}", array->shape.size(), mImage.axes.size()));
  for (std::uint64_t size : array->shape)
    if (size > std::uint64_t(std::numeric_limits<int>::max()))
      refuse(path, fmt::format("a shape of {} makes no sense", fmt::join(array->shape, " x ")));
  VoxelLevel made;
  for (int i = 0; i < 3; ++i) {
    auto axis = axisOf(mImage, kSpace[i]);
    made.dims[i] = sizeAlong(array->shape, axis);
    made.brickSize[i] = std::min(sizeAlong(array->brick, axis), made.dims[i]);
  }
  auto channel = axisOf(mImage, Role::Channel), time = axisOf(mImage, Role::Time);
  made.brickChannels = std::min(sizeAlong(array->brick, channel), sizeAlong(array->shape, channel));
  made.brickTimeSteps = std::min(sizeAlong(array->brick, time), sizeAlong(array->shape, time));
  int channels = sizeAlong(array->shape, channel), timeSteps = sizeAlong(array->shape, time);
  SampleType type = sampleTypeOf(array->type);
  if (mLevels.empty()) {
    mHead.channels = channels;
    mHead.timeSteps = timeSteps;
    mHead.type = type;
  }
  if (mHead.channels != channels || mHead.timeSteps != timeSteps || mHead.type != type)
    refuse(path, "it has another type, or other channels or time steps, than the finest level");
  mLevels.push_back(made);
  mArrays.push_back(std::make_unique<ZarrBricks>(mStore, std::move(*array)));
}

void ZarrSource::describeHead() {
  mHead.dims = mLevels.front().dims;
  mHead.name = mImage.name;
  mHead.isOrientationKnown = false;
  if (auto time = axisOf(mImage, Role::Time)) {
    double seconds = mImage.levels.front().scale[*time] * secondsPer(mImage.axes[*time].unit).value_or(0.0);
    if (seconds > 0) mHead.timeStepSeconds = seconds;
  }
  const auto& channels = mImage.channels;
  if (channels.size() != std::size_t(mHead.channels)) return;
  auto all = [&](auto has) { return std::all_of(channels.begin(), channels.end(), has); };
  for (std::size_t i = 0; i < channels.size(); ++i)
    mHead.channelNames.push_back(channels[i].label.empty() ? fmt::format("Channel {}", i) : channels[i].label);
  if (all([](const OmeChannel& channel) { return channel.color.has_value(); }))
    for (const OmeChannel& channel : channels) mHead.channelColors.push_back(*channel.color);
  if (all([](const OmeChannel& channel) { return channel.window.has_value(); }))
    for (const OmeChannel& channel : channels) mChannelWindows.push_back(*channel.window);
}

/// Scales that the file does not give follow from the shapes.
void ZarrSource::fillScales() {
  for (std::size_t i = 1; i < mLevels.size(); ++i)
    for (Role role : kSpace)
      if (auto axis = axisOf(mImage, role)) {
        double finest = double(stored(0).shape[*axis]), size = double(stored(int(i)).shape[*axis]);
        mImage.levels[i].scale[*axis] = mImage.levels.front().scale[*axis] * blockFactor(finest, size);
      }
}

bool ZarrSource::holdsMeansOfBlocks() const {
  for (std::size_t i = 1; i < mLevels.size(); ++i)
    for (Role role : kSpace)
      if (auto axis = axisOf(mImage, role)) {
        double ratio = mImage.levels[i].scale[*axis] / mImage.levels.front().scale[*axis];
        double exact = double(stored(0).shape[*axis]) / ratio, size = double(stored(int(i)).shape[*axis]);
        if (!(ratio >= 1.0) || size < std::floor(exact) || size > std::ceil(exact)) return false;
      }
  return true;
}

void ZarrSource::placeLevels() {
  auto& levels = mImage.levels;
  bool hasScales = false, hasUnits = false, hasTranslations = false;
  double smallest = 1.0;
  mHead.lengthUnit = LengthUnit::Millimetre;
  for (const OmeLevel& level : levels) {
    hasTranslations = hasTranslations || level.hasTranslation;
    for (double scale : level.scale) hasScales = hasScales || scale != 1.0;
  }
  for (Role role : kSpace)
    if (auto axis = axisOf(mImage, role)) {
      if (isAngstrom(mImage.axes[*axis].unit)) mHead.lengthUnit = LengthUnit::Angstrom;
      if (auto mm = millimetresOf(mImage.axes[*axis].unit)) hasUnits = true, smallest = std::min(smallest, *mm);
    }
  if (!hasScales) fillScales();
  mHead.isSpacingKnown = hasUnits || levels.front().scale != std::vector<double>(mImage.axes.size(), 1.0);
  if (mHead.isSpacingKnown && !hasUnits)
    mHead.warnings.push_back("the file gives no unit of lengths; millimetres were taken");
  if (hasUnits && smallest <= 1e-3) mHead.modality = Modality::Microscopy;
  mFacts.isAlignedByBorders = levels.size() > 1 && !hasTranslations && holdsMeansOfBlocks();

  double perMm = unitsPer(LengthUnit::Millimetre, mHead.lengthUnit);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    glm::dvec3 spacing(0.0), origin(0.0);
    for (int a = 0; a < 3; ++a)
      if (auto axis = axisOf(mImage, kSpace[a])) {
        double unit = millimetresOf(mImage.axes[*axis].unit).value_or(1.0) * perMm;
        double shift = mFacts.isAlignedByBorders ? (levels[i].scale[*axis] - levels.front().scale[*axis]) / 2 : 0.0;
        spacing[a] = levels[i].scale[*axis] * unit;
        origin[a] = (levels[i].translation[*axis] + shift) * unit;
      }
    if (!axisOf(mImage, Role::Y)) spacing.y = spacing.x;
    if (!axisOf(mImage, Role::Z)) spacing.z = spacing.x;
    Volume placed;
    placed.lengthUnit = mHead.lengthUnit;
    placeInWorld(placed, glm::dmat3(gridMatrix(spacing)), origin, spacing);
    mLevels[i].worldFromVoxel = placed.worldFromVoxel;
    if (i > 0) continue;
    mHead.isSpacingKnown = mHead.isSpacingKnown && placed.isSpacingKnown;
    mHead.warnings.insert(mHead.warnings.end(), placed.warnings.begin(), placed.warnings.end());
  }
  mHead.worldFromVoxel = mLevels.front().worldFromVoxel;
}

/// Of a store that we wrote. It turns all levels as it turns the finest.
void ZarrSource::takeOwnAttributes() {
  if (mImage.isBare) return;
  Json attributes = attributesOf(*mStore, mImage.key);
  glm::dmat4 placed = mHead.worldFromVoxel;
  applyOwn(memberOf(attributes, "velum"), mHead);
  if (mHead.worldFromVoxel == placed) return;
  glm::dmat4 turned = mHead.worldFromVoxel * glm::inverse(placed);
  for (VoxelLevel& level : mLevels) level.worldFromVoxel = turned * level.worldFromVoxel;
  mLevels.front().worldFromVoxel = mHead.worldFromVoxel;
}

void ZarrSource::describeFacts() {
  for (const OmeAxis& axis : mImage.axes) {
    mFacts.axes += (mFacts.axes.empty() ? "" : " ") + axis.name;
    if (mFacts.unit.empty() && axis.role >= Role::Z) mFacts.unit = axis.unit;
  }
  mFacts.isLabels = mImage.isLabels;
  mFacts.structures = mImage.structures;
  for (const auto& bricks : mArrays) {
    const ZarrArray& array = bricks->array();
    mFacts.levels.push_back({array.key, array.type, array.brick, {}, array.packing});
    if (array.shard) mFacts.levels.back().shard = array.chunk;
  }
}

std::vector<std::uint64_t> ZarrSource::indexOf(const BrickAddress& address) const {
  std::vector<std::uint64_t> index(mImage.axes.size(), 0);
  auto put = [&](Role role, int place) {
    if (auto axis = axisOf(mImage, role)) index[*axis] = std::uint64_t(place);
  };
  for (int i = 0; i < 3; ++i) put(kSpace[i], address.brick[i]);
  put(Role::Channel, address.channel);
  put(Role::Time, address.timeStep);
  return index;
}

std::optional<glm::dvec2> ZarrSource::range(const BrickAddress& address) const {
  const ZarrBricks& bricks = *mArrays[std::size_t(address.level)];
  const auto& fill = bricks.array().fill;
  bool isZero = std::all_of(fill.begin(), fill.end(), [](std::byte byte) { return byte == std::byte(0); });
  if (!isZero || bricks.has(indexOf(address))) return std::nullopt;
  return glm::dvec2(0.0);
}

void ZarrSource::read(const BrickAddress& address, const SampleTarget& target) const {
  const ZarrBricks& bricks = *mArrays[std::size_t(address.level)];
  const ZarrArray& array = bricks.array();
  auto bytes = bricks.read(indexOf(address));
  // See how its samples lie; of a missing one, all in one place.
  std::vector<std::ptrdiff_t> steps(array.shape.size(), 0);
  std::ptrdiff_t step = array.type.bytes;
  for (std::size_t i = array.order.size(); i-- > 0 && bytes;) {
    steps[array.order[i]] = step;
    step *= std::ptrdiff_t(array.brick[array.order[i]]);
  }
  auto stepAlong = [&](Role role) {
    auto axis = axisOf(mImage, role);
    return axis ? steps[*axis] : 0;
  };
  SampleSteps from{stepAlong(Role::X), stepAlong(Role::Y), stepAlong(Role::Z), stepAlong(Role::Channel),
                   stepAlong(Role::Time)};
  // Copy them, row by row.
  const std::byte* first = bytes ? bytes->data() : array.fill.data();
  if (!copySamples(givenType(array.type), first, from, boxOf(*this, address), target))
    refuseWideNumbers(array.type, mStore->pathOf(array.key).string());
}

}  // namespace velum::io
