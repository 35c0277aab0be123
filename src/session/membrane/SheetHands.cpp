#include "session/membrane/SheetHands.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/Scene.h"
#include "session/cut/CutEdit.h"
#include "session/cut/SectionMembrane.h"

namespace velum::session {

namespace {

constexpr double kNearPixels = 12.0;
constexpr double kLeastRadius = 0.1;
constexpr int kRingCorners = 48;

glm::dmat4 localFromWorld(const scene::Cut& cut) { return glm::inverse(scene::worldFromCut(cut)); }

SheetPoint worldPoint(const scene::Cut& cut, const membrane::SheetTouch& touch) {
  return {glm::dvec3(scene::worldFromCut(cut) * glm::dvec4(touch.place, 1.0)), touch.share};
}

/// Where a ray meets the plane through a point that faces the eye.
glm::dvec3 facing(const scene::Camera& camera, glm::dvec2 size, glm::dvec3 point, glm::dvec2 pixel) {
  auto ray = scene::rayFromPixel(camera, size, pixel);
  glm::dvec3 forward = scene::cameraBasis(camera).forward;
  return ray.origin + ray.direction * (glm::dot(point - ray.origin, forward) / glm::dot(ray.direction, forward));
}

glm::dvec3* placeOf(scene::Membrane& membrane, Hand hand) {
  if (!holds(membrane, hand)) return nullptr;
  auto index = std::size_t(hand.index);
  return hand.kind == HandKind::Pin ? &membrane.pins[index].place : &membrane.field.kernels[index].centre;
}

/// The nearest of several within reach.
class Nearest {
 public:
  explicit Nearest(double reach) : mLeast(reach) {}
  void offer(Hand hand, double distance) {
    if (distance > mLeast) return;
    mLeast = distance;
    mHand = hand;
  }
  Hand hand() const { return mHand; }

 private:
  double mLeast;
  Hand mHand;
};

}  // namespace

bool holds(const scene::Membrane& membrane, Hand hand) {
  if (hand.kind == HandKind::None || hand.index < 0) return false;
  return hand.index < int(hand.kind == HandKind::Pin ? membrane.pins.size() : membrane.field.kernels.size());
}

std::optional<SheetPoint> sheetOnRay(const scene::Cut& cut, const membrane::SheetIndex& sheet,
                                     const scene::PictureRay& ray) {
  glm::dmat4 local = localFromWorld(cut);
  auto touch = membrane::touchSheet(sheet, glm::dvec3(local * glm::dvec4(ray.origin, 1.0)),
                                    glm::dvec3(local * glm::dvec4(ray.direction, 0.0)));
  if (!touch) return std::nullopt;
  return worldPoint(cut, *touch);
}

std::optional<SheetPoint> sheetOnSection(const scene::Cut& cut, const membrane::SheetIndex& sheet,
                                         const scene::SectionPlane& plane, glm::dvec2 pixel, double reach) {
  std::optional<glm::dvec2> found;
  double nearest = reach;
  for (const auto& curve : sheetCurves(plane, cut, shapeOf(sheet)))
    for (std::size_t i = 1; i < curve.size(); ++i) {
      glm::dvec2 way = curve[i] - curve[i - 1];
      double t = std::clamp(glm::dot(pixel - curve[i - 1], way) / std::max(glm::dot(way, way), 1e-12), 0.0, 1.0);
      glm::dvec2 place = curve[i - 1] + way * t;
      if (glm::length(place - pixel) > nearest) continue;
      nearest = glm::length(place - pixel);
      found = place;
    }
  if (!found) return std::nullopt;
  glm::dvec3 world = scene::worldFromSectionPixel(plane, *found);
  glm::dvec3 local(localFromWorld(cut) * glm::dvec4(world, 1.0));
  // A line across the sheet right there says which part of it this is.
  double back = 1e-3 * glm::length(sheet.size);
  auto touch = membrane::touchSheet(sheet, local + glm::dvec3(0, 0, back), {0, 0, -1});
  glm::dvec2 share = touch ? touch->share : glm::dvec2(local) / glm::dvec2(sheet.size) + 0.5;
  return SheetPoint{world, share};
}

scene::SheetShape shapeOf(const membrane::SheetIndex& sheet) {
  scene::SheetShape shape;
  shape.particles = sheet.particles;
  auto count = std::ptrdiff_t(sheet.particles.x) * sheet.particles.y;
  shape.places.assign(sheet.rows.begin(), sheet.rows.begin() + count);
  return shape;
}

std::optional<scene::Pin> pinOver(const scene::Cut& cut, glm::dvec3 place) {
  glm::dvec3 local(localFromWorld(cut) * glm::dvec4(place, 1.0));
  glm::dvec2 share = glm::dvec2(local) / glm::dvec2(cut.size) + 0.5;
  if (!(std::min(share.x, share.y) >= 0.0 && std::max(share.x, share.y) <= 1.0)) return std::nullopt;
  return scene::Pin{share, place};
}

Hand addPin(scene::Membrane& membrane, const SheetPoint& point) {
  membrane.pins.push_back({glm::clamp(point.sheet, 0.0, 1.0), point.place});
  return {HandKind::Pin, int(membrane.pins.size()) - 1};
}

Hand addKernel(scene::Membrane& membrane, glm::dvec3 centre, double radius, double strength) {
  membrane.field.kernels.push_back({centre, std::max(radius, kLeastRadius), strength});
  return {HandKind::Kernel, int(membrane.field.kernels.size()) - 1};
}

void removeHand(scene::Membrane& membrane, Hand hand) {
  if (!holds(membrane, hand)) return;
  if (hand.kind == HandKind::Pin)
    membrane.pins.erase(membrane.pins.begin() + hand.index);
  else
    membrane.field.kernels.erase(membrane.field.kernels.begin() + hand.index);
}

void turnKernel(scene::Membrane& membrane, Hand hand) {
  if (hand.kind == HandKind::Pin || !holds(membrane, hand)) return;
  double& strength = membrane.field.kernels[std::size_t(hand.index)].strength;
  strength = -strength;
}

double pinHeight(const scene::Cut& cut, Hand hand) {
  if (hand.kind != HandKind::Pin || !holds(*cut.membrane, hand)) return 0.0;
  return glm::dot(cut.membrane->pins[std::size_t(hand.index)].place - cut.centre, cutFrame(cut)[2]);
}

void setPinHeight(scene::Cut& cut, Hand hand, double length) {
  if (hand.kind != HandKind::Pin || !holds(*cut.membrane, hand)) return;
  cut.membrane->pins[std::size_t(hand.index)].place += cutFrame(cut)[2] * (length - pinHeight(cut, hand));
}

double defaultRadius(const scene::Cut& cut) { return std::sqrt(cut.size.x * cut.size.y) / 12.0; }

Hand handAt(const scene::Membrane& membrane, const scene::Camera& camera, glm::dvec2 size, glm::dvec2 pixel,
            double reach) {
  auto away = [&](glm::dvec3 world) {
    auto place = scene::pixelFromWorld(camera, size, world);
    return place ? glm::length(*place - pixel) : 1e30;
  };
  Nearest pins(reach), middles(reach), rims(0.6 * reach);
  for (std::size_t i = 0; i < membrane.pins.size(); ++i)
    pins.offer({HandKind::Pin, int(i)}, away(membrane.pins[i].place));
  for (std::size_t i = 0; i < membrane.field.kernels.size(); ++i) {
    const auto& kernel = membrane.field.kernels[i];
    middles.offer({HandKind::Kernel, int(i)}, away(kernel.centre));
    // Its outline is the ring that faces the eye.
    double radius = kernel.radius / scene::lengthPerPixel(camera, size, kernel.centre);
    rims.offer({HandKind::Rim, int(i)}, std::abs(away(kernel.centre) - radius));
  }
  for (Hand hand : {pins.hand(), middles.hand()})
    if (hand.kind != HandKind::None) return hand;
  return rims.hand();
}

Hand handAt(const scene::Membrane& membrane, const scene::SectionPlane& plane, glm::dvec2 pixel, double reach) {
  Nearest pins(reach), middles(reach), rims(0.6 * reach);
  for (std::size_t i = 0; i < membrane.pins.size(); ++i)
    if (glm::dvec3 place = membrane.pins[i].place; nearnessToSection(plane, place) > 0.0)
      pins.offer({HandKind::Pin, int(i)}, glm::length(scene::sectionPixelFromWorld(plane, place) - pixel));
  for (std::size_t i = 0; i < membrane.field.kernels.size(); ++i) {
    auto circle = circleOnSection(plane, membrane.field.kernels[i]);
    if (!circle) continue;
    double distance = glm::length(circle->middle - pixel);
    middles.offer({HandKind::Kernel, int(i)}, distance);
    rims.offer({HandKind::Rim, int(i)}, std::abs(distance - circle->radius));
  }
  for (Hand hand : {pins.hand(), middles.hand()})
    if (hand.kind != HandKind::None) return hand;
  return rims.hand();
}

scene::Membrane dragHand(const scene::Membrane& start, Hand hand, const scene::Camera& camera, glm::dvec2 size,
                         glm::dvec2 from, glm::dvec2 to, std::optional<glm::dvec3> along) {
  scene::Membrane now = start;
  glm::dvec3* place = placeOf(now, hand);
  if (!place || from == to) return now;
  glm::dvec3 a = facing(camera, size, *place, from), b = facing(camera, size, *place, to);
  if (hand.kind == HandKind::Rim) {
    auto& kernel = now.field.kernels[std::size_t(hand.index)];
    double grows = glm::length(b - *place) - glm::length(a - *place);
    kernel.radius = std::max(kernel.radius + grows, kLeastRadius);
  } else if (along) {
    // As far along the direction as the pointer goes along it on the screen.
    glm::dvec3 forward = scene::cameraBasis(camera).forward, seen = *along - forward * glm::dot(*along, forward);
    double slant = glm::dot(seen, seen);
    if (slant > 1e-2) *place += *along * (glm::dot(b - a, seen) / slant);
  } else {
    *place += b - a;
  }
  return now;
}

scene::Membrane dragHand(const scene::Membrane& start, Hand hand, const scene::SectionPlane& plane, glm::dvec2 from,
                         glm::dvec2 to) {
  scene::Membrane now = start;
  glm::dvec3* place = placeOf(now, hand);
  if (!place || from == to) return now;
  if (hand.kind != HandKind::Rim) {
    *place += scene::worldFromSectionPixel(plane, to) - scene::worldFromSectionPixel(plane, from);
    return now;
  }
  auto& kernel = now.field.kernels[std::size_t(hand.index)];
  auto circle = circleOnSection(plane, kernel);
  if (!circle) return now;
  double grows = glm::length(to - circle->middle) - glm::length(from - circle->middle);
  double radius = std::max(circle->radius + grows, 0.0) * plane.lengthPerPixel;
  kernel.radius = std::max(std::hypot(radius, scene::heightOverSection(plane, kernel.centre)), kLeastRadius);
  return now;
}

double radiusOfDrag(const scene::SectionPlane& plane, glm::dvec2 from, glm::dvec2 to) {
  return std::max(glm::length(to - from) * plane.lengthPerPixel, kLeastRadius);
}

double radiusOfDrag(const scene::Camera& camera, glm::dvec2 size, glm::dvec3 centre, glm::dvec2 to) {
  return std::max(glm::length(facing(camera, size, centre, to) - centre), kLeastRadius);
}

std::optional<ViewCircle> circleOnSection(const scene::SectionPlane& plane, const scene::UserKernel& kernel) {
  return ViewSpace(plane).circleOfBall(kernel.centre, kernel.radius);
}

double nearnessToSection(const scene::SectionPlane& plane, glm::dvec3 place) {
  double pixels = std::abs(scene::heightOverSection(plane, place)) / plane.lengthPerPixel;
  return std::clamp(1.0 - pixels / kNearPixels, 0.0, 1.0);
}

std::vector<std::vector<glm::dvec3>> kernelRings(const scene::UserKernel& kernel, const glm::dmat3& axes) {
  std::vector<std::vector<glm::dvec3>> rings(3);
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i < kRingCorners; ++i) {
      double a = 2.0 * std::numbers::pi * i / kRingCorners;
      glm::dvec3 out = axes[(axis + 1) % 3] * std::cos(a) + axes[(axis + 2) % 3] * std::sin(a);
      rings[std::size_t(axis)].push_back(kernel.centre + out * kernel.radius);
    }
  return rings;
}

std::string whyNotHeld(const scene::LengthFormat& lengths, const scene::Cut& cut, Hand hand) {
  if (hand.kind != HandKind::Pin || !holds(*cut.membrane, hand)) return {};
  glm::dvec3 place = cut.membrane->pins[std::size_t(hand.index)].place - cut.centre;
  glm::dmat3 axes = cutFrame(cut);
  bool isBeside =
      std::abs(glm::dot(place, axes[0])) > 0.5 * cut.size.x || std::abs(glm::dot(place, axes[1])) > 0.5 * cut.size.y;
  if (isBeside) return "lies beside the frame: move it, or make the frame larger";
  double height = glm::dot(place, axes[2]), most = 0.5 * cut.size.z;
  if (std::abs(height) <= most) return {};
  return fmt::format("is {} from the rest plane, and the sheet goes {} to either side: deepen the reach to {}",
                     lengthText(lengths, std::abs(height)), lengthText(lengths, most),
                     lengthText(lengths, 2.0 * std::abs(height)));
}

std::string handText(const scene::LengthFormat& lengths, const scene::Cut& cut, Hand hand) {
  if (!holds(*cut.membrane, hand)) return {};
  if (hand.kind == HandKind::Rim)
    return "r " + lengthText(lengths, cut.membrane->field.kernels[std::size_t(hand.index)].radius);
  scene::Membrane membrane = *cut.membrane;
  glm::dvec3 local(localFromWorld(cut) * glm::dvec4(*placeOf(membrane, hand), 1.0));
  return lengthText(lengths, local.z, true);
}

// The same in whatever view.

std::optional<SheetPoint> sheetAt(const scene::Cut& cut, const membrane::SheetIndex& sheet, const ViewSpace& view,
                                  glm::dvec2 pixel, double reach) {
  if (const auto* section = view.section()) return sheetOnSection(cut, sheet, *section, pixel, reach);
  return sheetOnRay(cut, sheet, scene::rayFromPixel(view.camera(), view.size(), pixel));
}

Hand handAt(const scene::Membrane& membrane, const ViewSpace& view, glm::dvec2 pixel, double reach) {
  if (const auto* section = view.section()) return handAt(membrane, *section, pixel, reach);
  return handAt(membrane, view.camera(), view.size(), pixel, reach);
}

scene::Membrane dragHand(const scene::Membrane& start, Hand hand, const ViewSpace& view, glm::dvec2 from, glm::dvec2 to,
                         std::optional<glm::dvec3> along) {
  if (const auto* section = view.section()) return dragHand(start, hand, *section, from, to);
  return dragHand(start, hand, view.camera(), view.size(), from, to, along);
}

double radiusOfDrag(const ViewSpace& view, glm::dvec3 centre, glm::dvec2 from, glm::dvec2 to) {
  if (const auto* section = view.section()) return radiusOfDrag(*section, from, to);
  return radiusOfDrag(view.camera(), view.size(), centre, to);
}

const char* handLabel(Hand hand) {
  if (hand.kind == HandKind::Pin) return "Move pin";
  return hand.kind == HandKind::Rim ? "Resize force" : "Move force";
}

}  // namespace velum::session
