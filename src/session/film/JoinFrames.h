#pragma once
#include <filesystem>

#include "core/Task.h"
#include "io/video/VideoWriter.h"
#include "session/film/FrameFolder.h"

namespace velum::session {

/// Makes a video of frames that are drawn, by however many processes. @param names  of the frames, see namesInFolder()
/// @param options  with no frames a second, 0, it has as many as the frames were drawn for  @return how many frames it
/// has  @throw InputError that says which frames are missing or broken, and as io::VideoWriter; Cancelled, and then
/// there is no video
int joinFrames(const FrameNames& names, const std::filesystem::path& video, io::VideoOptions options,
               Progress& progress);

}  // namespace velum::session
