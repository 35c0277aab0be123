#pragma once
#include "render/FrameSetup.h"
#include "render/upload/TransferTable.h"
#include "shared/frame.h"

namespace velum::render {

/// Everything of FrameParams that does not change from sample to sample.
/// @param unit  of the frame's and the grid's lengths, in that of the world that labels lie in
shared::FrameParams makeFrameParams(const Frame& frame, const FrameGrid& grid, const TransferTable& table, double unit);

}  // namespace velum::render
