#include "core/LabelCover.h"

#include <algorithm>
#include <array>
#include <limits>

#include "core/BorderValues.h"
#include "shared/structure.h"

namespace velum {

namespace {

constexpr int kSize = LabelVolume::kBrickSize, kHalo = LabelCover::kHalo, kWide = kSize + 2 * kHalo;
constexpr float kSharpen = 2.65f;

std::size_t inWide(glm::ivec3 at) {
  return (std::size_t(at.z) * kWide + std::size_t(at.y)) * kWide + std::size_t(at.x);
}
std::size_t inBrick(glm::ivec3 at) {
  return (std::size_t(at.z) * kSize + std::size_t(at.y)) * kSize + std::size_t(at.x);
}

/// A box of floats whose rows lie one after the other; blurred in place, it shrinks by two voxels at each end of an
/// axis.
struct Field {
  glm::ivec3 low{0}, size{0};  ///< in the wide brick
  std::vector<float> values;
  std::size_t at(glm::ivec3 p) const {
    p -= low;
    return (std::size_t(p.z) * std::size_t(size.y) + std::size_t(p.y)) * std::size_t(size.x) + std::size_t(p.x);
  }
};

/// 1 4 6 4 1 along one axis.
Field blurredAlong(const Field& from, int axis) {
  Field to;
  to.low = from.low, to.size = from.size;
  to.low[axis] += 2, to.size[axis] -= 4;
  to.values.resize(std::size_t(to.size.x) * std::size_t(to.size.y) * std::size_t(to.size.z));
  std::size_t step = axis == 0   ? 1
                     : axis == 1 ? std::size_t(from.size.x)
                                 : std::size_t(from.size.x) * std::size_t(from.size.y);
  for (int z = 0; z < to.size.z; ++z)
    for (int y = 0; y < to.size.y; ++y) {
      glm::ivec3 start = to.low + glm::ivec3(0, y, z);
      const float* in = &from.values[from.at(start)];
      float* out = &to.values[to.at(start)];
      const float *a = in - 2 * step, *b = in - step, *c = in + step, *d = in + 2 * step;
      for (int x = 0; x < to.size.x; ++x) out[x] = (a[x] + d[x] + 4.0f * (b[x] + c[x]) + 6.0f * in[x]) * (1.0f / 16.0f);
    }
  return to;
}

Field blurred(const Field& from) { return blurredAlong(blurredAlong(blurredAlong(from, 2), 1), 0); }

std::uint8_t byteOf(float cover) { return std::uint8_t(std::clamp(int(cover * 255.0f + 0.5f), 1, 255)); }

/// How deep a value lies in a range: below 0 outside.
float depthIn(const ValueBorder& border, float value) {
  return float(std::min(double(value) - border.low, border.high - double(value)));
}

/// The cover of one brick.
class BrickWork {
 public:
  using BorderOf = std::function<const ValueBorder*(std::uint16_t)>;
  /// @param ids  of the brick with kHalo voxels around it
  BrickWork(const LabelVolume& labels, glm::ivec3 corner, std::vector<std::uint16_t> ids, BorderOf borderOf)
      : mBorderOf(std::move(borderOf)), mLabels(labels), mCorner(corner), mIds(std::move(ids)) {}

  LabelCover::Brick run() {
    findBorder();
    if (mBorder.empty()) return {255};
    LabelCover::Brick cover(std::size_t(kSize) * kSize * kSize, 255);
    for (glm::ivec3 at : mBorder) {
      Answer answer = byValues(at);
      if (answer.isKnown) cover[inBrick(at - kHalo)] = byteOf(answer.cover);
      if (answer.asksMask) groupOf(id(at)).add(at);
    }
    for (const Group& group : mGroups) {
      Field shares = membership(group);
      for (glm::ivec3 at : group.voxels) {
        std::uint8_t& here = cover[inBrick(at - kHalo)];
        here = std::min(here, byteOf(2.0f * shares.values[shares.at(at)] - 1.0f));
      }
    }
    return cover;
  }

 private:
  struct Answer {
    float cover = 1.0f;
    bool isKnown = false, asksMask = true;
  };
  /// Voxels of a structure whose cover is asked of its mask.
  struct Group {
    std::uint16_t id;
    std::vector<glm::ivec3> voxels;
    glm::ivec3 low{kWide}, high{0};
    void add(glm::ivec3 at) {
      voxels.push_back(at);
      low = glm::min(low, at), high = glm::max(high, at + 1);
    }
  };
  std::uint16_t id(glm::ivec3 at) const { return mIds[inWide(at)]; }
  Group& groupOf(std::uint16_t id) {
    auto found = std::find_if(mGroups.begin(), mGroups.end(), [id](const Group& group) { return group.id == id; });
    return found != mGroups.end() ? *found : mGroups.emplace_back(Group{id, {}});
  }

  /// The voxels of the brick, and of the grid, that have one of another structure around.
  void findBorder() {
    glm::ivec3 end = glm::min(mLabels.dims() - mCorner, glm::ivec3(kSize)) + kHalo;
    // The least and the largest id of three along x, then of three such along y, then along z.
    std::vector<std::uint16_t> least(mIds), largest(mIds);
    for (std::size_t step : {std::size_t(1), std::size_t(kWide), std::size_t(kWide) * kWide}) {
      std::vector<std::uint16_t> low(least), high(largest);
      for (std::size_t i = step; i + step < least.size(); ++i) {
        low[i] = std::min({least[i - step], least[i], least[i + step]});
        high[i] = std::max({largest[i - step], largest[i], largest[i + step]});
      }
      least.swap(low), largest.swap(high);
    }
    for (int z = kHalo; z < end.z; ++z)
      for (int y = kHalo; y < end.y; ++y)
        for (int x = kHalo; x < end.x; ++x)
          if (std::size_t i = inWide({x, y, z}); least[i] != largest[i]) mBorder.push_back({x, y, z});
  }

  float valueOf(const ValueBorder& border, glm::ivec3 at) const {
    return mValues.at(border, glm::clamp(mCorner + at - kHalo, glm::ivec3(0), mLabels.dims() - 1));
  }

  template <class Body>
  void forOthersAround(glm::ivec3 at, const Body& body) const {
    for (int n = 0; n < 27; ++n) {
      glm::ivec3 there = at + glm::ivec3(n % 3, n / 3 % 3, n / 9) - 1;
      if (id(there) != id(at) && !body(there)) return;
    }
  }

  /// What values say of a voxel next to a border, where some structure there is known by them.
  Answer byValues(glm::ivec3 at) const {
    const ValueBorder* own = mBorderOf(id(at));
    return own ? insideOf(*own, at) : besideOthers(at);
  }

  Answer insideOf(const ValueBorder& own, glm::ivec3 at) const {
    float value = valueOf(own, at);
    if (!(depthIn(own, value) >= 0.0f)) return {};  // it was closed, or filled
    // How far it is to the end of the range at which the values around leave it: to the other end it may be nearer.
    bool isByMask = false;
    float depth = std::numeric_limits<float>::infinity();
    forOthersAround(at, [&](glm::ivec3 there) {
      float other = valueOf(own, there);
      bool goesOn = depthIn(own, other) >= 0.0f;
      isByMask = goesOn && id(there) != own.within;
      if (!goesOn) depth = std::min(depth, other < float(own.low) ? value - float(own.low) : float(own.high) - value);
      return !isByMask;
    });
    if (isByMask) return {};
    return {std::min(depth / float(own.scale), 1.0f), true, false};
  }

  Answer besideOthers(glm::ivec3 at) const {
    Answer answer{1.0f, false, false};
    forOthersAround(at, [&](glm::ivec3 there) {
      const ValueBorder* other = mBorderOf(id(there));
      float depth = other ? depthIn(*other, valueOf(*other, at)) : 0.0f;
      bool goesOn = other && depth >= 0.0f && id(at) == other->within;
      // Where its values go on the structure does, up to the middle of this voxel.
      if (goesOn) {
        answer = {0.0f, true, false};
      } else if (other && depth < 0.0f && depthIn(*other, valueOf(*other, there)) >= 0.0f) {
        answer.cover = std::min(answer.cover, -depth / float(other->scale));
        answer.isKnown = true;
      } else {
        answer.asksMask = true;
      }
      return !goesOn;
    });
    return answer;
  }

  /// Shares of a structure in the voxels of a group.
  Field membership(const Group& group) const {
    Field field;
    field.low = group.low - kHalo, field.size = group.high - group.low + 2 * kHalo;
    field.values.resize(std::size_t(field.size.x) * std::size_t(field.size.y) * std::size_t(field.size.z));
    for (int z = 0; z < field.size.z; ++z)
      for (int y = 0; y < field.size.y; ++y) {
        glm::ivec3 start = field.low + glm::ivec3(0, y, z);
        const std::uint16_t* ids = &mIds[inWide(start)];
        float* out = &field.values[field.at(start)];
        for (int x = 0; x < field.size.x; ++x) out[x] = ids[x] == group.id ? 1.0f : 0.0f;
      }
    Field once = blurred(field), twice = blurred(once);
    for (int z = 0; z < twice.size.z; ++z)
      for (int y = 0; y < twice.size.y; ++y) {
        glm::ivec3 start = twice.low + glm::ivec3(0, y, z);
        const float* of = &once.values[once.at(start)];
        float* out = &twice.values[twice.at(start)];
        for (int x = 0; x < twice.size.x; ++x) out[x] = of[x] + kSharpen * (of[x] - out[x]);
      }
    return twice;
  }

  BorderOf mBorderOf;
  const LabelVolume& mLabels;
  glm::ivec3 mCorner;
  std::vector<std::uint16_t> mIds;
  std::vector<glm::ivec3> mBorder;  ///< in the wide brick
  std::vector<Group> mGroups;
  mutable BorderValues mValues{mCorner - kHalo, glm::min(mCorner - kHalo + kWide, mLabels.dims())};
};

std::vector<std::uint16_t> idsAround(const LabelVolume& labels, glm::ivec3 corner) {
  return readAround(labels, corner - kHalo, glm::ivec3(kWide));
}

}  // namespace

bool isUniformAround(const LabelVolume& labels, glm::ivec3 index) {
  const LabelVolume::Brick& own = labels.brick(index);
  glm::ivec3 low = glm::max(index - 1, glm::ivec3(0)), high = glm::min(index + 1, labels.brickGrid() - 1), at;
  for (at.z = low.z; at.z <= high.z; ++at.z)
    for (at.y = low.y; at.y <= high.y; ++at.y)
      for (at.x = low.x; at.x <= high.x; ++at.x)
        if (const auto& brick = labels.brick(at); brick.size() > 1 || brick[0] != own[0]) return false;
  return true;
}

std::vector<std::uint16_t> readAround(const LabelVolume& labels, glm::ivec3 origin, glm::ivec3 size) {
  glm::ivec3 low = glm::clamp(origin, glm::ivec3(0), labels.dims() - 1);
  glm::ivec3 high = glm::clamp(origin + size, glm::ivec3(1), labels.dims());
  glm::ivec3 held = high - low;
  std::vector<std::uint16_t> inGrid(std::size_t(held.x) * std::size_t(held.y) * std::size_t(held.z));
  labels.read(low, held, inGrid);
  if (held == size) return inGrid;
  std::vector<std::uint16_t> ids;
  ids.reserve(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z));
  for (int z = 0; z < size.z; ++z)
    for (int y = 0; y < size.y; ++y) {
      glm::ivec3 row = glm::clamp(origin + glm::ivec3(0, y, z), low, high - 1) - low;
      const auto* from = &inGrid[(std::size_t(row.z) * std::size_t(held.y) + std::size_t(row.y)) * std::size_t(held.x)];
      for (int x = 0; x < size.x; ++x) ids.push_back(from[std::clamp(origin.x + x - low.x, 0, held.x - 1)]);
    }
  return ids;
}

LabelCover::LabelCover(Shared<LabelVolume> labels, std::vector<ValueBorder> borders)
    : mLabels(std::move(labels)), mBorders(std::move(borders)) {
  std::sort(mBorders.begin(), mBorders.end(), [](const auto& a, const auto& b) { return a.structure < b.structure; });
}

const ValueBorder* LabelCover::borderOf(std::uint16_t structure) const {
  auto found = std::lower_bound(mBorders.begin(), mBorders.end(), structure,
                                [](const ValueBorder& border, std::uint16_t id) { return border.structure < id; });
  return found != mBorders.end() && found->structure == structure ? &*found : nullptr;
}

LabelCover::Brick LabelCover::brick(glm::ivec3 index) const {
  if (isUniformAround(*mLabels, index)) return {255};
  glm::ivec3 corner = index * kSize;
  return BrickWork(*mLabels, corner, idsAround(*mLabels, corner), [this](std::uint16_t id) { return borderOf(id); })
      .run();
}

LabelCover::Brick LabelCover::brickOfSet(glm::ivec3 index, const std::function<bool(std::uint16_t)>& isIn) const {
  if (isUniformAround(*mLabels, index)) return {255};
  glm::ivec3 corner = index * kSize;
  std::vector<std::uint16_t> ids = idsAround(*mLabels, corner);
  for (std::uint16_t& id : ids) id = isIn(id) ? 1 : 0;
  return BrickWork(*mLabels, corner, std::move(ids), [](std::uint16_t) { return nullptr; }).run();
}

}  // namespace velum
