#pragma once
#include "core/Log.h"

/// log::setVerbose(), log::warning(): what is told beside results, on the standard error.
