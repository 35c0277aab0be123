#pragma once
#include "core/Log.h"

/// log::setVerbose(), log::warning(): messages that are not results, on standard error.
