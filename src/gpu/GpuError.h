#pragma once
#include <string>

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

/// Thrown when a driver offers less than is needed. The message says which one, and what: "softpipe offers OpenGL 3.3".
class TooOld : public GpuError {
 public:
  explicit TooOld(const std::string& message) : GpuError(message) {}
};

/// Thrown when the driver has lost the context, as after a reset of the card: all objects in it are gone, and what was
/// drawn last may be wrong. See Loss.h.
class ContextLost : public GpuError {
 public:
  explicit ContextLost(const std::string& message) : GpuError(message) {}
};

}  // namespace velum::gpu
