#pragma once
#include <glm/glm.hpp>
#include <string_view>

#include "scene/Camera.h"
#include "scene/SceneFwd.h"
#include "scene/Sections.h"

/// The arguments of commands of the view: camera, crosshair, layout.
namespace velum::session {

struct LookFrom {
  static constexpr std::string_view kName = "view.from";
  scene::StandardView side = scene::StandardView::Anterior;
  double aspect = 16.0 / 9.0;
  static void fields(auto& o, auto& visit) {
    visit("side", o.side, FieldInfo{"", {}, "From which of the patient's sides."});
    visit("aspect", o.aspect, FieldInfo{"", {0.01, 100}, "Width by height of the picture that is to hold all."});
  }
};

struct LookFirst {
  static constexpr std::string_view kName = "view.first";
  double aspect = 16.0 / 9.0;
  static void fields(auto& o, auto& visit) {
    visit("aspect", o.aspect, FieldInfo{"", {0.01, 100}, "Width by height of the picture that is to hold all."});
  }
};

struct PlaceCrosshair {
  static constexpr std::string_view kName = "view.crosshair";
  glm::dvec3 place{0.0};
  static void fields(auto& o, auto& visit) { visit("place", o.place, FieldInfo{kLength, {}, "World."}); }
};

struct ChooseLayout {
  static constexpr std::string_view kName = "view.layout";
  scene::Layout layout = scene::Layout::FourUp;
  static void fields(auto& o, auto& visit) { visit("layout", o.layout, FieldInfo{"", {}, "Which views there are."}); }
};

}  // namespace velum::session
