#pragma once
#include "core/Task.h"

/// Progress: by it long work tells how far it is, and the caller can tell the work to stop.
