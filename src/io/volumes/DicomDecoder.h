#pragma once
#include <span>
#include <vector>

#include "core/Task.h"
#include "core/Volume.h"
#include "io/volumes/DicomFile.h"
#include "io/volumes/DicomStack.h"

namespace velum::io {

/// Decodes the frames of a series into the slots of its stack. Fills dims (with the stack's planes), type, channels,
/// time steps, scale, offset and voxels of @p v.
///
/// Values become int16 where that is exact (CT as a rule); else raw samples are kept where one scale and one type serve
/// all slices; else, and where a table gives the meaning of samples, values become floats, or doubles where floats have
/// too few digits.
/// @param frames  frames of equal orientation, each with the index of its file in @p files
/// @throw InputError, Cancelled
void decodeDicom(std::span<const DicomFile> files, const std::vector<DicomFrame>& frames, const DicomStack& stack,
                 Volume& v, Progress& progress);

}  // namespace velum::io
