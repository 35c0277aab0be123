#pragma once
#include "core/Error.h"
#include "gpu/GpuError.h"

/// What the library throws: Error, and of its kinds ArgumentError, InputError, GpuError and Cancelled. Each says in one
/// line what is wrong and with what.
namespace velum {

using gpu::GpuError;

}  // namespace velum
