#pragma once
#include <functional>

#include "session/Worker.h"

namespace velum::session {

/// Lets a worker do all that there is to do, in the thread that calls: for those who wait, as a command line does.
/// @param complete  called when the worker has something to write into the scene; may let the worker follow another one
/// @throw Cancelled, and what the work throws; the worker can then be asked again
void bringToRest(Worker& worker, const std::function<void()>& complete, Progress& progress);
/// The same of a mover. GL thread.
void bringToRest(Mover& mover, const std::function<void()>& complete, Progress& progress);

}  // namespace velum::session
