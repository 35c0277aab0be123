#pragma once
#include <string>
#include <string_view>

#include "core/Fields.h"
#include "scene/Source.h"
#include "session/picture/Picture.h"

/// The arguments of commands of the session: files, history, fields.
namespace velum::session {

class WorkFile;

/// Sets a field, see setFields().
struct SetField {
  static constexpr std::string_view kName = "set";
  static constexpr std::size_t kTakesRest = 2;
  std::string path, value;
  static void fields(auto& o, auto& visit) {
    visit("path", o.path, FieldInfo{"", {}, "The field: rayCast.mode, cuts.0.centre, labels.structures[aorta].color."});
    visit("value", o.value, FieldInfo{"", {}, "What it is to be: a word, numbers with commas between them, or JSON."});
  }
};

/// Tells what a field is.
struct GetField {
  static constexpr std::string_view kName = "get";
  static constexpr std::size_t kTakesRest = 1;
  std::string path;
  static void fields(auto& o, auto& visit) {
    visit("path", o.path, FieldInfo{"", {}, "The field, or a part with all of its fields; nothing: the whole scene."});
  }
};

/// Opens a file or folder in the place of what is open.
struct OpenFile {
  static constexpr std::string_view kName = "open";
  static constexpr std::size_t kTakesRest = 1;
  std::string path, series;
  scene::RawLayout raw;
  glm::dvec3 spacing{0.0};
  int level = scene::kFittingLevel;
  bool operator==(const OpenFile&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("path", o.path, FieldInfo{"", {}, "File or folder: a scene, a picture of ours, a volume, labels, a model."});
    visit("series", o.series,
          FieldInfo{"", {}, "DICOM series UID, when the folder holds several; of a store: path of an image in it."});
    visit("level", o.level,
          FieldInfo{"", {scene::kFittingLevel, 62}, "Level of a pyramid, 0 the finest; -1: as its size asks."});
    visit("raw", o.raw, FieldInfo{"", {}, "How to read a file without a header."});
    visit("spacing", o.spacing,
          FieldInfo{"mm", {0, scene::kMostSpacing}, "Voxel spacing over the file's own; 0: that."});
  }
};

/// Adds a file beside what is open.
struct AddFile {
  static constexpr std::string_view kName = "add";
  static constexpr std::size_t kTakesRest = 1;
  std::string path;
  bool asLabels = false;
  std::string series;
  static void fields(auto& o, auto& visit) {
    visit("path", o.path, FieldInfo{"", {}, "Labels, a surface, a model, or a volume where there is none."});
    visit("series", o.series, FieldInfo{"", {}, "Of a store: path of an image or labels in it."});
    visit("asLabels", o.asLabels, FieldInfo{"", {}, "It is read as labels, whatever it looks like."});
  }
};

/// Takes the scene and its film over to other data: retargeted().
struct CarryScene {
  static constexpr std::string_view kName = "scene.carry";
  std::string volume, labels, structure;
  static void fields(auto& o, auto& visit) {
    visit("volume", o.volume, FieldInfo{"", {}, "File or folder of the other volume."});
    visit("labels", o.labels, FieldInfo{"", {}, "File of its labels; nothing: there are none."});
    visit("structure", o.structure,
          FieldInfo{"", {}, "Structure of both labels by which places are found again; nothing: by the data's boxes."});
  }
};

/// Writes the scene.
struct SaveScene {
  static constexpr std::string_view kName = "save";
  static constexpr std::size_t kTakesRest = 1;
  std::string path;
  static void fields(auto& o, auto& visit) {
    visit("path", o.path,
          FieldInfo{"", {}, "The file, .json; nothing: where it was saved last, else beside the data by its name."});
  }
};
/// Where a scene is to be saved, a whole path. @throw ArgumentError where nothing has a name; InputError where somebody
/// would lose a file that he has not named
std::string pathToSave(const WorkFile& file, const SaveScene& asked);

/// Makes a picture of the scene.
struct MakePicture {
  static constexpr std::string_view kName = "picture";
  static constexpr std::size_t kTakesRest = 2;
  std::string size = "1280x720", path;
  int samples = 0;
  bool transparent = false, layers = false;
  double dpi = 0.0;
  std::string part;
  static void fields(auto& o, auto& visit) {
    visit("size", o.size, FieldInfo{"", {}, "WIDTHxHEIGHT in pixels, or with a unit: 12x8cm."});
    visit("path", o.path, FieldInfo{"", {}, "The file: .png, .tif, .exr, .svg, .pdf."});
    visit("samples", o.samples, FieldInfo{"", {0, 256}, "Pictures that are averaged; 0: as the scene says."});
    visit("transparent", o.transparent, FieldInfo{"", {}, "No background, with alpha."});
    visit("layers", o.layers, FieldInfo{"", {}, "Also depth, normal, structure id and others."});
    visit("dpi", o.dpi, FieldInfo{"", {0, 10000}, "Pixels an inch in print; 0: nothing is said."});
    visit("part", o.part, FieldInfo{"", {}, "K/N: the K-th of N bands of rows, for several machines."});
  }
};

/// The options of the picture for which a command asks. @throw ArgumentError for a size that is none
PictureOptions optionsOf(const MakePicture& arguments);

/// The commands without arguments.
struct Undo {
  static constexpr std::string_view kName = "undo";
  static void fields(auto&, auto&) {}
};
struct Redo {
  static constexpr std::string_view kName = "redo";
  static void fields(auto&, auto&) {}
};
struct Settle {
  static constexpr std::string_view kName = "settle";
  static void fields(auto&, auto&) {}
};
struct ListCommands {
  static constexpr std::string_view kName = "commands";
  static void fields(auto&, auto&) {}
};

}  // namespace velum::session
