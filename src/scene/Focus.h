#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/Fields.h"
#include "scene/Camera.h"

namespace velum::scene {

/// A type, or a compartment with all types below it, that a cut keeps in view.
struct FocusType {
  static constexpr std::string_view kKey = "type";  ///< the field that a bare value on the command line stands for

  std::string type;  ///< its path
  bool operator==(const FocusType&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("type", o.type, FieldInfo{"", {}, "Path of a type, or of a compartment for all types below it."});
  }
};

/// The view for which a focus is cleared, also while the camera goes elsewhere.
struct ViewLock {
  Camera camera;
  double aspect = 1.0;  ///< width / height of the picture
  bool operator==(const ViewLock&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("camera", o.camera, FieldInfo{"", {}, "From where."});
    visit("aspect", o.aspect, FieldInfo{"", {0.01, 100}, "Width of the picture by its height."});
  }
};

/// What a cut keeps in view: instances in the cut's region that hide one of these types are removed, except the share
/// that TypeSpare::viewShare leaves ([VE] 6).
struct Focus {
  std::vector<FocusType> types;  ///< types kept in view; without any the cut clears nothing
  /// What stands about the focus stays, so that one sees how deep it lies ([VE] 8.2): only what is before the nearest
  /// of its spheres goes, else all before the end of the farthest
  bool guidesDepth = false;
  std::optional<ViewLock> lock;  ///< none: as seen from the camera
  bool operator==(const Focus&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("types", o.types, FieldInfo{"", {}, "Types that are kept in view."});
    visit("guidesDepth", o.guidesDepth,
          FieldInfo{"", {}, "What stands about the focus stays, so that one sees how deep it lies.", true});
    visit("lock", o.lock, FieldInfo{"", {}, "The view that it is cleared for; null: the picture's.", true});
  }
};

}  // namespace velum::scene
