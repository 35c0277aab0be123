#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/Task.h"
#include "scene/Source.h"

/// A pyramid beside a large file: the same voxels with coarser levels, which opens at once, whatever its size.
namespace velum::session {

/// What making one takes.
struct PyramidBeside {
  std::filesystem::path path;  ///< NAME.ome.zarr, in the folder of the file
  double sampleBytes = 0;      ///< of the file's voxels
  double diskBytes = 0;        ///< that the pyramid takes at most, if nothing can be packed
  double freeBytes = 0;        ///< of that disk
  double seconds = 0;          ///< about, as long as nothing else keeps the machine busy
  bool fitsMemory = true;      ///< the file can be read whole, too
  bool isBegun = false;        ///< a writer was stopped; another one goes on where it was
  bool isThere = false;        ///< it is whole already
  std::string obstacle;        ///< one line: why it cannot be written; empty: nothing is in its way
};

/// What a pyramid beside a source's file takes. Headers are read, and no voxel. Any thread.
/// @return nothing for files that need none, as they have levels, hold labels or are read whole in a moment, and for
/// files that cannot be read piece by piece
/// @param isAsked  true: also of files that are read whole in a moment
std::optional<PyramidBeside> pyramidBeside(const scene::Source& source, bool isAsked = false);

/// True for a file that can be read piece by piece, has no coarser levels, and takes more memory than is taken unasked:
/// an eighth of the machine's. Headers are read. Any thread.
bool isTooLarge(const scene::Source& source);

/// Writes it, or goes on with one that was left; what velum-batch convert does. Any thread.
/// @param to  PyramidBeside::path  @throw InputError, also when the disk refuses; Cancelled: what is there stays
void makePyramidBeside(const scene::Source& source, const std::filesystem::path& to, Progress& progress);

/// The levels of detail of a source's file, the finest first, as lines for people: "1000 x 1000 x 500, 0.9 GiB"; empty
/// where there is but one. Headers are read. @throw InputError
std::vector<std::string> levelLines(const scene::Source& source);

/// The source that has the pyramid in the place of the file; a voxel size that was given by hand stays.
scene::Source withPyramid(const scene::Source& source, const std::filesystem::path& pyramid);

}  // namespace velum::session
