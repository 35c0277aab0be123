#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "scene/Lighting.h"
#include "scene/TransferFunction.h"

namespace velum::io {

/// Files that hold a transfer function: ours, and the volume properties of 3D Slicer in the old and the new form.
enum class TransferKind { Velum, SlicerText, SlicerJson };

/// A transfer function as its file has it.
struct TransferFile {
  scene::TransferFunction transfer;
  /// Slicer's gradients are values per voxel (of mean edge), ours per mm.
  bool isGradientPerVoxel = false;
  /// What the file has that a transfer function does not, one line each.
  std::vector<std::string> warnings;
};

/// True for names that end in .velum-transfer.json, .vp.json or .vp, whatever their case.
bool isTransferFile(const std::filesystem::path& path);

/// Reads a file by its name. Points come out ascending, opacities and colours in 0..1. Of a Slicer property with
/// several components the first is taken; its light is left out.
/// @throw InputError for a file that is missing, damaged, too large (1 MiB) or of another kind
TransferFile readTransferFile(const std::filesystem::path& path);

/// The same from text. @throw InputError
TransferFile parseTransfer(std::string_view text, TransferKind kind);

/// A file's text, and what it could not hold, one line each, for people.
struct TransferText {
  std::string text;
  std::vector<std::string> losses;
};

/// What is written. .vp has no unit of opacity: there it becomes that of 1 mm.
/// @param lighting  Slicer's files name a light; 0..1 of it fits
/// @param voxel  mean edge of a voxel, mm, for Slicer's gradients; not used where the function has no gradient part
TransferText transferText(const scene::TransferFunction& transfer, TransferKind kind, const scene::Lighting& lighting,
                          double voxel);

/// Writes by name; to a temporary beside it, then renamed.
/// @return what the kind could not hold, one line each, for people
/// @throw InputError when the name is none of these, the kind cannot hold the function, or the disk refuses
std::vector<std::string> writeTransferFile(const scene::TransferFunction& transfer, const scene::Lighting& lighting,
                                           double voxel, const std::filesystem::path& path);

}  // namespace velum::io
