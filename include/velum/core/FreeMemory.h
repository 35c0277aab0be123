#pragma once

namespace velum {

/// Gives what was freed back to the system: to be called when something large has gone. The allocator keeps it else for
/// each thread that there was, and a long session seems to grow. Any thread; milliseconds.
void releaseFreeMemory();

}  // namespace velum
