#pragma once
#include "core/Error.h"

namespace velum::gpu {

/// No usable driver, a shader that does not compile, memory that the card does not have.
class GpuError : public Error {
 public:
  explicit GpuError(const std::string& message) : Error(ExitCode::Gpu, message) {}
};

}  // namespace velum::gpu
