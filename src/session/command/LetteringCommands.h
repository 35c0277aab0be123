#pragma once
#include "scene/Caption.h"
#include "session/command/ModelCommands.h"
#include "session/command/StructureCommands.h"

/// The arguments of commands of what is called how, and of what is written over pictures.
namespace velum::session {

struct RenameType {
  static constexpr std::string_view kName = "model.rename";
  static constexpr std::size_t kTakesRest = 2;
  std::string type, name;
  static void fields(auto& o, auto& visit) {
    visit("type", o.type, FieldInfo{"", {}, "Path of a type or compartment."});
    visit("name", o.name, FieldInfo{"", {}, "What it is called from now on; nothing: as in the file."});
  }
};

struct ListInLegend {
  static constexpr std::string_view kName = "model.listInLegend";
  std::vector<std::string> types;
  bool listed = true;
  static void fields(auto& o, auto& visit) {
    visit("types", o.types, kTypesInfo);
    visit("listed", o.listed, FieldInfo{"", {}, "Off: they are taken out of the legend's list."});
  }
};

struct ListStructuresInLegend {
  static constexpr std::string_view kName = "structure.listInLegend";
  std::vector<std::string> structures;
  bool listed = true;
  static void fields(auto& o, auto& visit) {
    visit("structures", o.structures, kStructuresInfo);
    visit("listed", o.listed, FieldInfo{"", {}, "Off: they are taken out of the legend's list."});
  }
};

struct AddCaption {
  static constexpr std::string_view kName = "caption.add";
  static constexpr std::size_t kTakesRest = 1;
  std::string text;
  scene::CaptionPlace place = scene::Caption().place;
  double size = scene::Caption().size;
  static void fields(auto& o, auto& visit) {
    visit("text", o.text, FieldInfo{"", {}, "The words."});
    visit("place", o.place,
          FieldInfo{"", {}, "Where the caption stands; captions at one place stand below each other."});
    visit("size", o.size, FieldInfo{"", {0.2, 20}, "Size of its letters, in that of other lettering."});
  }
};

struct RemoveCaption {
  static constexpr std::string_view kName = "caption.remove";
  std::string caption;
  static void fields(auto& o, auto& visit) { visit("caption", o.caption, FieldInfo{"", {}, "Its id: 2 or #2."}); }
};

}  // namespace velum::session
