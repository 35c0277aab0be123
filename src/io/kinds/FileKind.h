#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "scene/Source.h"

namespace velum::io {

/// What a file or folder holds.
enum class FileKind {
  Scene,    ///< a scene of ours, as JSON
  Picture,  ///< a picture; opening it opens the scene that it carries
  Look,     ///< a transfer function
  Model,    ///< molecules and where their instances stand
  Surface,
  Labels,
  Volume,  ///< a volume, or any other file: the reader of volumes says what is wrong with such a file
};

/// The kind of a file or folder, by its contents where these tell the kind, else by its name, whatever the case of its
/// letters. A file that does not exist is judged by its name alone. A TIFF is a picture when it carries a scene of
/// ours. Reads the head of the file. Any thread.
FileKind kindOf(const std::filesystem::path& path);
/// The kind of a source; a file whose layout of samples the source gives (Source::raw) is a volume.
FileKind kindOf(const scene::Source& source);

/// True for the endings of drawings, of lines and letters: .svg, .pdf. They are pictures.
bool isDrawing(const std::filesystem::path& path);

/// True when files of this kind carry a scene, which replaces the open one when the file is opened.
inline bool holdsScene(FileKind kind) { return kind == FileKind::Scene || kind == FileKind::Picture; }

/// A format in which data of some kind is written.
struct WrittenFormat {
  std::string name;                  ///< "NIfTI"
  std::vector<std::string> endings;  ///< ".nii.gz", ".nii"; the usual one first
};

/// All formats in which data of a kind is written, the usual one first: for dialogs, help, messages.
std::vector<WrittenFormat> writable(FileKind kind);

/// The endings of writable(kind), joined: ".nii.gz, .nii, .nrrd, .vti, .vdb".
std::string endingsOf(FileKind kind);

}  // namespace velum::io
