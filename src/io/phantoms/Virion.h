#pragma once
#include "core/Model.h"
#include "core/Task.h"

namespace velum::io {

/// A virus in blood plasma: envelope of lipids with spikes, matrix, capsid, a strand of RNA, and proteins inside and
/// around it. Proteins consist of lobes filled with atoms; no two of them overlap. Deterministic.
/// @throw Cancelled
Model makeVirion(Progress& progress);

}  // namespace velum::io
