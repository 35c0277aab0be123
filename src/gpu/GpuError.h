#pragma once
#include "core/Error.h"

namespace velum::gpu {

/// Thrown when there is no usable driver, a shader does not compile, or the card has not enough memory.
class GpuError : public Error {
 public:
  explicit GpuError(const std::string& message) : Error(ExitCode::Gpu, message) {}
};

/// Thrown where the driver has no memory for a texture or a buffer. Smaller ones, or the same ones later, may find
/// room.
class NoMemory : public GpuError {
 public:
  using GpuError::GpuError;
};

}  // namespace velum::gpu
