#pragma once
#include "core/Error.h"

namespace velum::gpu {

/// Thrown when there is no usable driver, a shader does not compile, or the card has not enough memory.
class GpuError : public Error {
 public:
  explicit GpuError(const std::string& message) : Error(ExitCode::Gpu, message) {}
};

}  // namespace velum::gpu
