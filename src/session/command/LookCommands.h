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
  static void fields(auto& o, auto& visit) { visit("name", o.name, FieldInfo{"", {}, "plate, ink, ..., none"}); }
};

struct ChooseModelLook {
  static constexpr std::string_view kName = "look.model";
  std::string name;
  static void fields(auto& o, auto& visit) { visit("name", o.name, FieldInfo{"", {}, "painted, soft or technical."}); }
};

struct ChooseWindow {
  static constexpr std::string_view kName = "look.window";
  static constexpr std::size_t kTakesRest = 1;
  std::string window;
  static void fields(auto& o, auto& visit) {
    visit("window", o.window,
          FieldInfo{"", {}, "Width and level in the values' unit, 400 50, or a name: bone, lung, whole."});
  }
};

struct ShowThis {
  static constexpr std::string_view kName = "look.showThis";
  glm::dvec3 place{0.0};
  bool hidden = false, added = false;
  static void fields(auto& o, auto& visit) {
    visit("place", o.place, FieldInfo{kLength, {}, "In the material that is meant, world."});
    visit("hidden", o.hidden, FieldInfo{"", {}, "On: the material is hidden instead."});
    visit("added", o.added, FieldInfo{"", {}, "On: all else stays as it is."});
  }
};

struct ShowChannelAlone {
  static constexpr std::string_view kName = "look.channelAlone";
  int channel = 0;
  static void fields(auto& o, auto& visit) {
    visit("channel", o.channel, FieldInfo{"", {0, 1e9}, "From 0; of the one that is alone already: all are shown."});
  }
};

struct ColorChannel {
  static constexpr std::string_view kName = "look.channelColor";
  int channel = 0;
  glm::vec3 color{1.0f};
  static void fields(auto& o, auto& visit) {
    visit("channel", o.channel, FieldInfo{"", {0, 1e9}, "From 0."});
    visit("color", o.color, FieldInfo{"", {0, 1}, "sRGB."});
  }
};

struct ChooseLitSphere {
  static constexpr std::string_view kName = "look.litSphere";
  static constexpr std::size_t kTakesRest = 1;
  std::string sphere;
  static void fields(auto& o, auto& visit) {
    visit("sphere", o.sphere, FieldInfo{"", {}, "A name, or the file of a painted sphere of one's own."});
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
