#pragma once
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/Fields.h"
#include "core/Shared.h"
#include "core/Units.h"

namespace velum {

enum class SampleType { UInt8, Int8, UInt16, Int16, UInt32, Int32, Float32, Float64 };
template <>
struct EnumNames<SampleType> {
  static constexpr std::string_view kNames[] = {"uint8",  "int8",  "uint16",  "int16",
                                                "uint32", "int32", "float32", "float64"};
};

/// Bytes of one sample.
std::size_t sampleSize(SampleType type);

/// The kind of device that made the volume, as far as the file says; the default preset is chosen by it.
enum class Modality { Unknown, CT, MR, Angiography, Ultrasound, Microscopy, Seismic, PET };
template <>
struct EnumNames<Modality> {
  static constexpr std::string_view kNames[] = {"unknown",    "CT",         "MR",      "angiography",
                                                "ultrasound", "microscopy", "seismic", "PET"};
};

/// An allocator that leaves new bytes unset, so that a gigabyte is not written twice.
template <class T>
struct UnsetAllocator : std::allocator<T> {
  template <class U>
  struct rebind {
    using other = UnsetAllocator<U>;
  };
  template <class U>
  void construct(U* p) noexcept {
    ::new (static_cast<void*>(p)) U;
  }
  template <class U, class... Args>
  void construct(U* p, Args&&... args) {
    ::new (static_cast<void*>(p)) U(std::forward<Args>(args)...);
  }
};

/// Bytes that belong to somebody else, who keeps them unchanged for as long as the owner lives.
struct LentBytes {
  std::shared_ptr<const void> owner;
  std::byte* data = nullptr;
  std::size_t size = 0;
  bool isTaken = false;
};
/// Leaves new bytes unset. The first block of a vector can be bytes that were lent; its copies have memory of their
/// own.
class BytesAllocator : public UnsetAllocator<std::byte> {
 public:
  using value_type = std::byte;
  using is_always_equal = std::false_type;
  using propagate_on_container_move_assignment = std::true_type;
  using propagate_on_container_swap = std::true_type;
  template <class U>
  struct rebind {
    using other = BytesAllocator;
  };
  BytesAllocator() = default;
  explicit BytesAllocator(LentBytes lent) : mLent(std::make_shared<LentBytes>(std::move(lent))) {}

  std::byte* allocate(std::size_t size) {
    bool isLent = mLent && !mLent->isTaken && size == mLent->size;
    if (!isLent) return std::allocator<std::byte>().allocate(size);
    mLent->isTaken = true;
    return mLent->data;
  }
  void deallocate(std::byte* data, std::size_t size) noexcept {
    if (!mLent || data != mLent->data) std::allocator<std::byte>().deallocate(data, size);
  }
  BytesAllocator select_on_container_copy_construction() const { return {}; }
  friend bool operator==(const BytesAllocator& a, const BytesAllocator& b) { return a.mLent == b.mLent; }

 private:
  std::shared_ptr<LentBytes> mLent;
};
using Bytes = std::vector<std::byte, BytesAllocator>;
/// Lent bytes, where they are. They must not be changed through the result.
inline Bytes bytesOver(LentBytes lent) { return Bytes(lent.size, BytesAllocator(lent)); }

struct FinerLevels;

/// A regular grid of samples with its place in the patient (or specimen, or earth).
///
/// World: in `lengthUnit`, DICOM patient axes (x to the Left, y to the Posterior, z to the Superior). Voxel centres are
/// at integer indices. `value = raw * scale + offset`, in `unit`. Written once by a reader, then held as
/// `Shared<Volume>` and never changed.
struct Volume {
  glm::ivec3 dims{0};                   ///< Voxels along x (fastest), y, z.
  SampleType type = SampleType::UInt8;  ///< Type of one raw sample, machine byte order.
  int channels = 1;                     ///< Samples per voxel, interleaved.
  int timeSteps = 1;                    ///< Time steps, slowest axis.
  bool isColor = false;                 ///< The channels are RGB or RGBA.
  Bytes voxels;                         ///< Raw samples, shape [timeSteps][z][y][x][channels].
  glm::dmat4 worldFromVoxel{1.0};       ///< in lengthUnit; rigid or not, left-handed allowed, never singular.
  LengthUnit lengthUnit = LengthUnit::Millimetre;
  double scale = 1.0;  ///< See `value` above.
  double offset = 0.0;
  glm::dvec2 range{0.0, 0.0};  ///< Smallest and largest finite value, over all time steps and channels.
  std::string unit;            ///< "HU", "m/s", empty when unknown.
  Modality modality = Modality::Unknown;
  bool isSpacingKnown = true;              ///< False: the file gave no spacing, and 1 was taken.
  bool isOrientationKnown = true;          ///< False: patient letters must not be shown.
  double timeStepSeconds = 0.0;            ///< Time from one time step to the next; 0 when unknown.
  std::string name;                        ///< For people: series description or file name.
  std::vector<std::string> channelNames;   ///< Empty, or one per channel.
  std::vector<glm::vec3> channelColors;    ///< As the file gives them, sRGB: empty, or one per channel.
  std::vector<glm::dvec2> channelWindows;  ///< Samples between which the file shows each channel: empty, or one each.
  std::vector<glm::ivec2> gaps;  ///< Planes along z for which the file has no slice, {first, count}; their values are
                                 ///< interpolated linearly.
  std::vector<std::string> warnings;         ///< What the reader had to assume or mend, one line each.
  std::shared_ptr<const FinerLevels> finer;  ///< Where the volume is a coarse level of a larger one
                                             ///< (core/BrickCache.h); else nullptr.
};

std::size_t voxelCount(const Volume& volume);     ///< dims.x * dims.y * dims.z
std::size_t timeStepBytes(const Volume& volume);  ///< Bytes of one time step.
glm::dvec3 spacingOf(const Volume& volume);       ///< Lengths of the columns of worldFromVoxel.
/// worldFromVoxel in another unit.
glm::dmat4 worldFromVoxelIn(LengthUnit unit, const Volume& volume);
/// The same volume with its world in another unit.
void setLengthUnit(Volume& volume, LengthUnit unit);
glm::dmat3 direction(const Volume& volume);  ///< Unit columns of worldFromVoxel.

/// One sample as a value (scale and offset applied). Any thread.
/// @param voxel  indices inside dims; not checked
double valueAt(const Volume& volume, glm::ivec3 voxel, int channel = 0, int timeStep = 0);

/// Fills `range` from the voxels; NaN and infinities are left out; {0, 0} when nothing finite is there.
/// O(samples), all cores.
void computeRange(Volume& volume);

/// Calls a generic body with a pointer to the volume's samples in their own type: `visitSamples(v, [&](auto* p) { ...
/// })`; p points at time step 0.
template <class Body>
decltype(auto) visitSamples(const Volume& volume, Body&& body) {
  const void* p = volume.voxels.data();
  switch (volume.type) {
    case SampleType::UInt8:
      return body(static_cast<const std::uint8_t*>(p));
    case SampleType::Int8:
      return body(static_cast<const std::int8_t*>(p));
    case SampleType::UInt16:
      return body(static_cast<const std::uint16_t*>(p));
    case SampleType::Int16:
      return body(static_cast<const std::int16_t*>(p));
    case SampleType::UInt32:
      return body(static_cast<const std::uint32_t*>(p));
    case SampleType::Int32:
      return body(static_cast<const std::int32_t*>(p));
    case SampleType::Float32:
      return body(static_cast<const float*>(p));
    case SampleType::Float64:
      break;
  }
  return body(static_cast<const double*>(p));
}

/// How many finite values of one channel at one time step lie in each of some bins. quantile() gives the value at or
/// below which `fraction` (0..1) of them lie, to the precision of a bin.
struct Histogram {
  std::vector<std::uint64_t> counts;  ///< Bins of equal width over `range`.
  glm::dvec2 range{0.0};
};
Histogram computeHistogram(const Volume& volume, int bins = 4096, int channel = 0, int timeStep = 0);
double quantile(const Histogram& histogram, double fraction);

/// From 0..1 along each axis over the box that holds all voxels: in voxel space the box from -0.5 to dims - 0.5. Where
/// the volume is a coarse level, the box of the finest one.
glm::dmat4 worldFromBox(const Volume& volume);
/// The same of any grid of voxels.
glm::dmat4 worldFromBox(glm::ivec3 dims, const glm::dmat4& worldFromVoxel);
/// Centre and radius, in the world, of the sphere around that box.
glm::dvec3 centreOf(const Volume& volume);
double radiusOf(const Volume& volume);

}  // namespace velum
