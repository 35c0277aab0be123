#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "scene/Source.h"

namespace velum::io {

/// What a file or folder holds.
enum class FileKind {
  Scene,    ///< a scene of ours, as JSON
  Picture,  ///< a picture; opened, it gives the scene that it carries
  Look,     ///< a transfer function
  Model,    ///< molecules and where their instances stand
  Surface,
  Labels,
  Volume,  ///< and whatever else there is: its reader says what is wrong with it
};

/// The kind of a file or folder, by its contents where these tell, else by its name, whatever the case of its letters;
/// of what is not there by its name alone. A TIFF is a picture when it carries a scene of ours. Reads the head of the
/// file. Any thread.
FileKind kindOf(const std::filesystem::path& path);
/// The same of a source: samples whose layout somebody has said are a volume.
FileKind kindOf(const scene::Source& source);

/// It carries a scene, which opens in the place of what is open.
inline bool holdsScene(FileKind kind) { return kind == FileKind::Scene || kind == FileKind::Picture; }

/// A format in which a kind is written.
struct WrittenFormat {
  std::string name;                  ///< "NIfTI"
  std::vector<std::string> endings;  ///< ".nii.gz", ".nii"; the usual one first
};

/// All formats in which a kind is written, the usual one first: for dialogs, help, messages.
std::vector<WrittenFormat> writable(FileKind kind);

/// Their endings: ".nii.gz, .nii, .nrrd, .vti, .vdb".
std::string endingsOf(FileKind kind);

}  // namespace velum::io
