#pragma once
#include <glm/glm.hpp>
#include <string>
#include <string_view>

#include "core/Fields.h"
#include "scene/RayCast.h"

/// The arguments of commands of how the data looks.
namespace velum::session {

struct ChoosePreset {
  static constexpr std::string_view kName = "look.preset";
  std::string name;
  static void fields(auto& o, auto& visit) { visit("name", o.name, FieldInfo{"", {}, "ct-bone, mr-brain, ..."}); }
};

struct ChooseFinish {
  static constexpr std::string_view kName = "look.finish";
  std::string name;
  static void fields(auto& o, auto& visit) { visit("name", o.name, FieldInfo{"", {}, "plate, clay, ..., none"}); }
};

struct ChooseModelLook {
  static constexpr std::string_view kName = "look.model";
  std::string name;
  static void fields(auto& o, auto& visit) { visit("name", o.name, FieldInfo{"", {}, "A look of models."}); }
};

struct ChooseWindow {
  static constexpr std::string_view kName = "look.window";
  static constexpr std::size_t kTakesRest = 1;
  std::string window;
  static void fields(auto& o, auto& visit) {
    visit("window", o.window, FieldInfo{"", {}, "Width and level in the values' unit, 400 50, or a name: bone, lung."});
  }
};

struct ChooseMode {
  static constexpr std::string_view kName = "look.mode";
  scene::RenderMode mode = scene::RenderMode::Volume;
  static void fields(auto& o, auto& visit) {
    visit("mode", o.mode, FieldInfo{"", {}, "A volume, a maximum, or a surface of one value."});
  }
};

struct MakeSurface {
  static constexpr std::string_view kName = "look.surface";
  static void fields(auto&, auto&) {}
};

struct ImportLook {
  static constexpr std::string_view kName = "look.import";
  static constexpr std::size_t kTakesRest = 1;
  std::string path;
  static void fields(auto& o, auto& visit) {
    visit("path", o.path, FieldInfo{"", {}, ".velum-transfer.json, or 3D Slicer's .vp.json and .vp."});
  }
};

struct SetBackground {
  static constexpr std::string_view kName = "look.background";
  glm::vec3 top{0.0f}, bottom{0.0f};
  static void fields(auto& o, auto& visit) {
    visit("top", o.top, FieldInfo{"", {0, 1}, "sRGB."});
    visit("bottom", o.bottom, FieldInfo{"", {0, 1}, "sRGB."});
  }
};

struct HideTable {
  static constexpr std::string_view kName = "volume.hideTable";
  bool hidden = true;
  static void fields(auto& o, auto& visit) {
    visit("hidden", o.hidden, FieldInfo{"", {}, "Off: what is not part of the body is shown again."});
  }
};

}  // namespace velum::session
