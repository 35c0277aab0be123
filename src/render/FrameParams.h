#pragma once
#include "render/FrameSetup.h"
#include "render/upload/TransferTable.h"
#include "shared/frame.h"

namespace velum::render {

/// The FrameParams of a frame, except what changes from sample to sample.
/// @param unit  length of the frame's and the grid's unit, in the unit of the world in which the labels lie
shared::FrameParams makeFrameParams(const Frame& frame, const FrameGrid& grid, const TransferTable& table, double unit);

}  // namespace velum::render
