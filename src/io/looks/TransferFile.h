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

/// A transfer function as it stands in its file.
struct TransferFile {
  scene::TransferFunction transfer;
  /// The gradients are values per voxel (of mean edge), as Slicer has them; ours are values per mm.
  bool isGradientPerVoxel = false;
  /// What the file holds that a transfer function cannot, one line each.
  std::vector<std::string> warnings;
};

/// True for names that end in .velum-transfer.json, .vp.json or .vp, whatever their case.
bool isTransferFile(const std::filesystem::path& path);

/// Reads a file; its name says of which kind it is. Points come out ascending, opacities and colours in 0..1. Of a
/// Slicer property with several components the first is taken; its light is left out.
/// @throw InputError for a file that is missing, damaged, too large (1 MiB) or of another kind
TransferFile readTransferFile(const std::filesystem::path& path);

/// Reads a transfer function from the text of a file. @throw InputError
TransferFile parseTransfer(std::string_view text, TransferKind kind);

/// The text of a file to be written, and in `losses` what the file could not hold, one line each, for people.
struct TransferText {
  std::string text;
  std::vector<std::string> losses;
};

/// The text of a file for a transfer function. .vp has no unit distance of opacity: there the opacities become those of
/// 1 mm.
/// @param lighting  Slicer's files hold a light; its shares fit into the file only within 0..1
/// @param voxel  mean edge of a voxel, mm, for Slicer's gradients; not used where the function has no gradient part
TransferText transferText(const scene::TransferFunction& transfer, TransferKind kind, const scene::Lighting& lighting,
                          double voxel);

/// Writes a file of the kind that its name says; to a temporary beside it, then renamed.
/// @return what the kind could not hold, one line each, for people
/// @throw InputError when the name has none of the endings of isTransferFile(), the kind cannot hold the function, or
/// the disk refuses
std::vector<std::string> writeTransferFile(const scene::TransferFunction& transfer, const scene::Lighting& lighting,
                                           double voxel, const std::filesystem::path& path);

}  // namespace velum::io
