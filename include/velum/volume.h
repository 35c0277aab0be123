#pragma once
#include "core/Volume.h"
#include "io/volumes/Formats.h"
#include "io/volumes/ReadVolume.h"
#include "io/volumes/WriteVolume.h"
#include "scene/Source.h"

/// Volume: voxels, and where in the world they lie. Also reads and writes files of volumes.
namespace velum {

using io::formats;
using io::listSeries;
using io::readVolume;
using io::SeriesInfo;
using io::writeVolume;
using scene::RawLayout;
using scene::Source;

}  // namespace velum
