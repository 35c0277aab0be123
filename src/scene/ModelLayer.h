#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/Fields.h"
#include "core/Levels.h"
#include "core/Model.h"
#include "core/Shared.h"
#include "scene/Source.h"

namespace velum::scene {

/// By what the instances of a model are coloured.
enum class Palette { Type, Compartment, Function, Element, Chain };

/// How instances that cuts have removed still show.
enum class Ghosts { None, Filled, Contour };

/// How the instances of one type are shown, where it differs from the rest of the layer. An entry for a compartment has
/// nothing but a name.
struct TypeLook {
  static constexpr std::string_view kKey = "type";  ///< that a bare value stands for on the command line

  std::string type;  ///< its path: "root.capsid.surface.CA"
  std::string name;  ///< what the author calls it; empty: as in the file
  bool visible = true;
  std::optional<glm::vec3> color;  ///< sRGB; none: the palette's
  std::string litSphere;           ///< of a finished picture; empty: as Finish::sphere says
  std::optional<Ghosts> ghosts;    ///< of its instances; none: as the layer says
  bool operator==(const TypeLook&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("type", o.type, FieldInfo{"", {}, "Path of the type, its compartments with dots between them."});
    visit("name", o.name, FieldInfo{"", {}, "What it is called; empty: as in the file. Of a compartment, too.", true});
    visit("visible", o.visible, FieldInfo{"", {}, "Off: its instances are not drawn."});
    visit("color", o.color, FieldInfo{"", {0, 1}, "sRGB colour; null: the palette's.", true});
    visit("litSphere", o.litSphere,
          FieldInfo{"", {}, "Lit sphere of a finished picture; empty: that of the finish.", true});
    visit("ghosts", o.ghosts, FieldInfo{"", {}, "How removed instances show; null: as the layer says.", true});
  }
};

/// How many instances of a type a hand has asked for. Cuts say what is drawn: solvers set their shares to reach these
/// numbers when they are asked to, and numbers of a compartment leave what is within it and has one of its own.
struct TypeTarget {
  static constexpr std::string_view kKey = "type";  ///< that a bare value stands for on the command line

  std::string type;                ///< path of a type, or of a compartment for all types below it
  std::optional<double> rendered;  ///< wanted number that no cut removes
  std::optional<double> visible;   ///< wanted number that show in the picture
  bool operator==(const TypeTarget&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("type", o.type, FieldInfo{"", {}, "Path of a type, or of a compartment for all types below it."});
    visit("rendered", o.rendered,
          FieldInfo{"", {0, 1e9}, "Instances that no cut is to remove; null: any number.", true});
    visit("visible", o.visible,
          FieldInfo{"", {0, 1e9}, "Instances that are to show in the picture; null: any number.", true});
  }
};

/// Most copies of a model side by side.
constexpr int kMostCopies = 1'000'000;

/// A model of molecules and how it is shown.
struct ModelLayer {
  Source source;
  Shared<Model> data;       ///< not saved: read from `source`
  Shared<LevelSet> levels;  ///< not saved: made from `data`; the renderer makes them where they are empty
  bool visible = true;
  bool completes = true;            ///< lipids and strands that the file leaves out are made
  int copies = 1;                   ///< of the whole model, side by side in a block, 1..kMostCopies
  double enlargement = 1.0;         ///< of the whole model about its file's origin, beside data of another scale
  glm::dvec3 offset{0.0};           ///< where its file's origin lies, scene units
  std::string look;                 ///< by name (ModelLooks.h), that was given to it last; empty: none
  Palette palette = Palette::Type;  ///< by which instances have their colours
  double nearColors = 0.0;  ///< how far chains and elements show near by as shades of the instance's colour, 0..1
  double detail = 1.0;      ///< how much of a pixel drawn shapes may be off by, 0.1..16; smaller is finer, and slower
  Ghosts ghosts = Ghosts::None;     ///< of instances that cuts have removed
  double ghostOpacity = 0.25;       ///< 0..1
  std::vector<TypeLook> types;      ///< types that are shown differently, once each
  std::vector<TypeTarget> targets;  ///< how many instances of types are wanted
  bool operator==(const ModelLayer&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("source", o.source, FieldInfo{"", {}, "Where the model comes from."});
    visit("visible", o.visible, FieldInfo{"", {}, "Off: the model is not drawn."});
    visit("completes", o.completes, FieldInfo{"", {}, "Lipids and strands that the file leaves out are made."});
    visit("copies", o.copies, FieldInfo{"", {1, kMostCopies}, "Copies of the whole model, side by side in a block."});
    visit("enlargement", o.enlargement,
          FieldInfo{"", {1e-12, 1e12}, "Of the whole model, beside data of another scale.", true});
    visit("offset", o.offset, FieldInfo{kLength, {}, "Where the origin of its file lies.", true});
    visit("look", o.look, FieldInfo{"", {}, "Look that was chosen last: that of the picture without a finish.", true});
    visit("palette", o.palette, FieldInfo{"", {}, "What instances have their colours by."});
    visit("nearColors", o.nearColors,
          FieldInfo{"", {0, 1}, "How far chains and elements show as shades of it where one is close."});
    visit("detail", o.detail,
          FieldInfo{"pixel",
                    {0.1, 16},
                    "How much drawn shapes may be off at one sample a pixel, less the more there are; smaller is "
                    "finer, and slower."});
    visit("ghosts", o.ghosts, FieldInfo{"", {}, "How instances that cuts have removed still show.", true});
    visit("ghostOpacity", o.ghostOpacity, FieldInfo{"", {0, 1}, "Opacity of these.", true});
    visit("types", o.types, FieldInfo{"", {}, "Types that are shown otherwise."});
    visit(
        "targets", o.targets,
        FieldInfo{"",
                  {},
                  "Numbers of instances that were set by hand: held when a group's is set, met when that is asked for.",
                  true});
  }
};

/// The colour of each type of a layer's model: the user's colour for it, else the palette's. With palettes that colour
/// parts of a molecule differently it is the colour of which the parts show shades. sRGB, in the order of Model::types.
std::vector<glm::vec3> typeColors(const ModelLayer& layer);

/// Why a layer's palette tells nothing apart, and what to choose; empty: it does.
std::string whyOneColor(const ModelLayer& layer);

/// How the removed instances of a type show. @param look  of the type, see typeLook()
inline Ghosts ghostsOf(const ModelLayer& layer, const TypeLook& look) { return look.ghosts.value_or(layer.ghosts); }
/// Whether removed instances of any type show.
bool hasGhosts(const ModelLayer& layer);

/// How one type is shown: its entry in the layer, or a default TypeLook where it has none.
TypeLook typeLook(const ModelLayer& layer, std::string_view path);

/// What the author calls a type or compartment (TypeLook::name); empty: as in the file.
std::string ownName(const ModelLayer& layer, std::string_view path);

/// Takes away what the author calls types, and entries that say nothing else.
void dropNames(ModelLayer& layer);

/// The name of a type or compartment as people read it: ownName(), else the file's with links as
/// their words and spaces for underscores.
/// @param path  of the type or compartment  @param inFile  its name in the file
std::string shownName(const ModelLayer& layer, std::string_view path, std::string_view inFile);

/// How the copies of a model (ModelLayer::copies) stand: how many there are along each axis, and the step from one to
/// the next, in the model's own unit (angstrom).
struct CopyGrid {
  glm::ivec3 counts{1};
  glm::dvec3 step{0.0};
};
CopyGrid copyGrid(const ModelLayer& layer);

/// How a scene's model lies in the world: its places, angstrom, times `length`, from `offset` on; scene units.
struct ModelFrame {
  double length = 1.0;
  glm::dvec3 offset{0.0};
  glm::dvec3 worldOf(glm::dvec3 place) const { return place * length + offset; }
  bool operator==(const ModelFrame&) const = default;
};

/// A box around the spheres of all instances of all copies, the model's unit.
struct ModelBox {
  glm::dvec3 low{0.0}, high{0.0};
};
ModelBox modelBox(const ModelLayer& layer);

}  // namespace velum::scene

template <>
struct velum::EnumNames<velum::scene::Palette> {
  static constexpr std::string_view kNames[] = {"type", "compartment", "function", "element", "chain"};
};
template <>
struct velum::EnumNames<velum::scene::Ghosts> {
  static constexpr std::string_view kNames[] = {"none", "filled", "contour"};
};
