#pragma once
#include "core/Task.h"

/// Progress: how long work tells how far it is, and is told to stop.
