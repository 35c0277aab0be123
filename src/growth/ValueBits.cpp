#include "growth/ValueBits.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <type_traits>

namespace velum::growth {

namespace {

/// Raw samples as whole numbers in the same order, so that one search serves all types.
template <class T>
T sampleOfKey(std::int64_t key) {
  if constexpr (std::is_integral_v<T>) {
    return T(key);
  } else {
    using Bits = std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t>;
    Bits bits = key < 0 ? std::numeric_limits<Bits>::min() - Bits(key) - 1 : Bits(key);
    T sample;
    std::memcpy(&sample, &bits, sizeof(T));
    return sample;
  }
}

/// Keys of the smallest and the largest sample, infinities included.
template <class T>
struct Keys {
  std::int64_t least, most;
};
template <class T>
Keys<T> allKeys() {
  if constexpr (std::is_integral_v<T>) {
    return {std::int64_t(std::numeric_limits<T>::min()), std::int64_t(std::numeric_limits<T>::max())};
  } else {
    using Bits = std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t>;
    T infinity = std::numeric_limits<T>::infinity();
    Bits bits;
    std::memcpy(&bits, &infinity, sizeof(T));
    return {-std::int64_t(bits) - 1, std::int64_t(bits)};
  }
}

/// The first key for which `holds`, which goes from false to true once; one more than the last where it never does.
template <class T, class Holds>
std::int64_t firstKey(const Holds& holds) {
  auto [low, high] = allKeys<T>();
  ++high;
  while (low < high) {
    std::int64_t middle = low + std::int64_t((std::uint64_t(high) - std::uint64_t(low)) / 2);
    holds(sampleOfKey<T>(middle)) ? high = middle : low = middle + 1;
  }
  return low;
}

/// Raw samples that belong to a range of values, ends included.
template <class T>
struct RawRange {
  T low = 1, high = 0;  ///< none
};

template <class T>
RawRange<T> rawRange(const Volume& volume, double low, double high) {
  auto valueOf = [&](T sample) { return double(sample) * volume.scale + volume.offset; };
  bool rises = volume.scale >= 0.0;
  if (volume.scale == 0.0) {
    Keys<T> all = allKeys<T>();
    bool isIn = volume.offset >= low && volume.offset <= high;
    return isIn ? RawRange<T>{sampleOfKey<T>(all.least), sampleOfKey<T>(all.most)} : RawRange<T>{};
  }
  std::int64_t first = firstKey<T>([&](T s) { return rises ? valueOf(s) >= low : valueOf(s) <= high; });
  std::int64_t end = firstKey<T>([&](T s) { return rises ? !(valueOf(s) <= high) : !(valueOf(s) >= low); });
  if (first >= end) return {};
  return {sampleOfKey<T>(first), sampleOfKey<T>(end - 1)};
}

/// 1 where a sample is in the range. Written so that compilers make vectors of it.
template <class T>
void compare(const T* samples, RawRange<T> range, int count, std::uint8_t* isIn) {
  if constexpr (std::is_integral_v<T>) {
    using Unsigned = std::make_unsigned_t<T>;
    auto low = Unsigned(range.low), width = Unsigned(Unsigned(range.high) - low);
    for (int i = 0; i < count; ++i) isIn[i] = Unsigned(Unsigned(samples[i]) - low) <= width;
  } else {
    for (int i = 0; i < count; ++i) isIn[i] = (samples[i] >= range.low) & (samples[i] <= range.high);
  }
}

template <class T>
class KernelOf final : public ValueBits::Kernel {
 public:
  explicit KernelOf(RawRange<T> range) : mRange(range) {}

  void of(const SampleRun& run, int width, Word* bits) const override {
    const T* samples = static_cast<const T*>(run.samples) + run.first;
    auto stride = std::size_t(run.stride);
    alignas(16) std::uint8_t isIn[kWordBits];
    for (int x = 0; x < width; x += kWordBits, ++bits) {
      int count = std::min(width - x, kWordBits);
      if (mRange.low > mRange.high) {
        *bits = 0;
        continue;
      }
      if (stride == 1 && count == kWordBits) {
        compare(samples + x, mRange, kWordBits, isIn);
      } else {
        T some[kWordBits] = {};
        for (int i = 0; i < count; ++i) some[i] = samples[std::size_t(x + i) * stride];
        compare(some, mRange, kWordBits, isIn);
        std::memset(isIn + count, 0, std::size_t(kWordBits - count));
      }
      *bits = packBytes(isIn);
    }
  }

 private:
  RawRange<T> mRange;
};

}  // namespace

ValueBits::ValueBits(const Volume& volume, double low, double high, int channel, int timeStep)
    : mChannel(channel), mTimeStep(timeStep) {
  visitSamples(volume, [&](auto* p) {
    using T = std::remove_const_t<std::remove_pointer_t<decltype(p)>>;
    mKernel = std::make_unique<KernelOf<T>>(rawRange<T>(volume, low, high));
  });
}

void ValueBits::of(const FinestVoxels& voxels, int y, int z, WordSpan words, Word* bits) const {
  int end = std::min(words.end * kWordBits, voxels.grid().dims.x);
  for (int x = words.first * kWordBits; x < end;) {
    SampleRun run = voxels.run({x, y, z}, mChannel, mTimeStep);
    int place = x % kWordBits, count = std::min(run.count, end - x);
    if (x + count < end) count -= (x + count) % kWordBits;
    if (place == 0 && count > 0) {
      mKernel->of(run, count, bits + (x / kWordBits - words.first));
    } else {
      // A word of several bricks.
      count = std::min({run.count, end - x, kWordBits - place});
      Word part;
      mKernel->of(run, count, &part);
      Word& word = bits[x / kWordBits - words.first];
      word = (place == 0 ? 0 : word) | part << place;
    }
    x += count;
  }
}

}  // namespace velum::growth
