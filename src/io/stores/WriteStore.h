#pragma once
#include <cstddef>
#include <string_view>
#include <vector>

#include "core/LabelVolume.h"
#include "core/VoxelSource.h"
#include "io/stores/OmeDescription.h"

/// Writes OME-Zarr: a pyramid of levels, in chunks that are packed by zstd.
namespace velum::io {

/// How a store is written.
struct StoreOptions {
  OmeVersion version = OmeVersion::V05;
  int level = 0;                                   ///< of the source, that becomes the finest
  bool isLabels = false;                           ///< samples are ids: coarser levels take the most frequent one
  bool carriesIds = false;                         ///< of labels: samples are ids of 64 bits (StoreSource::carryIds)
  std::vector<LabelInfo> structures;               ///< of labels; LabelInfo::fileId, where there is one, is the id
  std::size_t slabBytes = std::size_t(512) << 20;  ///< of the finest level, that are in memory at once
  int zstdLevel = 1;
};

/// Writes a source as a folder, or as an archive where the path ends with .ozx. Neither the source nor any level needs
/// to fit into memory: in it are a slab of the source, and a shard a core. What is whole on the disk stays there when
/// the writer is stopped, in the folder, of an archive in one beside it, `unfinishedFolder()`; reading that is refused,
/// and the same call goes on with it. Every level is made of the one before as it was written, so that each brick but
/// those of the last level is read back.
/// @return what the format could not hold, one line each, for people
/// @throw InputError when something else is there, the source cannot be read, or the disk refuses; Cancelled
std::vector<std::string> writeStore(const VoxelSource& source, const Path& path, const StoreOptions& options,
                                    Progress& progress);

/// Whether a path's ending is that of a store that can be written.
bool isStoreFormat(const Path& path);
/// Checks, before the work begins, that a store can be written there. @throw InputError
void expectStoreWritable(const Path& path);

/// A file in a folder that is not whole.
inline constexpr std::string_view kUnfinishedName = "velum-unfinished.json";
/// True for a folder in which a store is being written, or was when the writer was stopped.
bool isUnfinished(const Path& folder);
/// Where a store is written that is to become this file or folder.
Path unfinishedFolder(const Path& path);

}  // namespace velum::io
