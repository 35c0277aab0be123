#pragma once
#include <cstddef>

#include "core/Volume.h"

namespace velum::io {

/// Bytes to be filled. Where this thread has given some back their memory is used again: the system takes as long to
/// hand out new memory as many a codec to fill it.
Bytes takeBytes(std::size_t size);

/// Keeps the memory of bytes for this thread's next takeBytes(): of two pieces at most, of 8 MiB each.
void giveBytes(Bytes&& bytes);

}  // namespace velum::io
