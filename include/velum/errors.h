#pragma once
#include "core/Error.h"
#include "gpu/GpuError.h"

/// What the library throws: Error, or one of the classes derived from Error: ArgumentError, InputError, GpuError and
/// Cancelled. An error's text says in one line what is wrong and with what.
namespace velum {

using gpu::GpuError;

}  // namespace velum
