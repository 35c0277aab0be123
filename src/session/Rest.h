#pragma once
#include <functional>

#include "session/Worker.h"

namespace velum::session {

/// Lets a worker do all its work in the calling thread: for callers that wait for the results, such as a command line.
/// @param complete  called when the worker has something to write into the scene; may let the worker follow another
/// scene
/// @throw Cancelled, and what the work throws; the worker can then be asked again
void bringToRest(Worker& worker, const std::function<void()>& complete, Progress& progress);
/// The same for a mover, which is also advanced until nothing of it moves, and goes on in a new context where the
/// driver loses one that is no window's. GL thread.
void bringToRest(Mover& mover, const std::function<void()>& complete, Progress& progress);

}  // namespace velum::session
