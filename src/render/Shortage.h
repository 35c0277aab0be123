#pragma once
#include <cstdint>
#include <optional>

#include "gpu/Context.h"
#include "gpu/GpuError.h"
#include "render/Frame.h"

namespace velum::render {

/// What is done where the driver has less memory than it seemed to have. First all that is left of earlier frames goes;
/// then the volume and the borders of streamed labels get half of the memory that they took, and half of that, until
/// the frame has room. So it stays as long as that volume is shown: another one is tried whole.
class Shortage {
 public:
  explicit Shortage(const gpu::Limits& driver) : mDriver(driver) {}

  /// Those of the driver, with the memory that data may take.
  gpu::Limits limits() const;
  /// Called before a frame is worked on. @return true when it is of other data, and limits() are the driver's again
  bool endsFor(const Frame& frame);
  /// Called where a frame has found no memory. @param framesBegun  since all was given up last
  /// @return false when there is nothing left to give up
  bool yield(const Frame& frame, int framesBegun, const gpu::NoMemory& refusal);
  /// What was refused at first, where limits() are less than the driver's; they are the driver's again.
  std::optional<gpu::NoMemory> takeRefusal();

 private:
  gpu::Limits mDriver;
  std::size_t mBytes = 0;     ///< 0: as many as the driver says
  std::uint64_t mVolume = 0;  ///< of the frame for which there are fewer
  std::optional<gpu::NoMemory> mRefusal;
};

}  // namespace velum::render
