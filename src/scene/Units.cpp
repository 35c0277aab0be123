#include "scene/Units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/Assert.h"
#include "scene/SectionPlane.h"

namespace velum::scene {

namespace {

/// Walks over all fields and multiplies the lengths among them.
class Scaler {
 public:
  explicit Scaler(double factor) : mFactor(factor) {}

  template <class T>
  void operator()(std::string_view, T& value, const FieldInfo& info) const {
    visit(value, info.unit == kLength);
  }

 private:
  template <class T>
  void visit(std::vector<T>& values, bool isLength) const {
    for (auto& value : values) visit(value, isLength);
  }
  template <class T>
  void visit(std::optional<T>& value, bool isLength) const {
    if (value) visit(*value, isLength);
  }
  template <class T>
  void visit(T& value, bool isLength) const {
    if constexpr (std::is_same_v<T, double>) {
      if (isLength) value *= mFactor;
    } else if constexpr (std::is_same_v<T, glm::dvec2> || std::is_same_v<T, glm::dvec3>) {
      if (isLength) value *= mFactor;
    } else if constexpr (std::is_same_v<T, glm::vec3>) {
      if (isLength) value = glm::vec3(glm::dvec3(value) * mFactor);
    } else if constexpr (std::is_class_v<T> && requires { T::fields(value, *this); }) {
      T::fields(value, *this);
    } else {
      VELUM_ASSERT(!isLength, "lengths are doubles and vectors of them");
    }
  }

  double mFactor;
};

}  // namespace

void scaleLengths(Scene& scene, double factor) {
  Scaler scaler(factor);
  Scene::fields(scene, scaler);
  auto scaleGradients = [&](TransferFunction& transfer) {
    for (auto& point : transfer.gradientOpacities) point.value /= factor;
  };
  scaleGradients(scene.volume.transfer);
  for (auto& channel : scene.volume.channels) scaleGradients(channel.transfer);
  for (auto& cut : scene.cuts)
    if (cut.membrane)
      for (auto& point : cut.membrane->field.byGradient) point.value /= factor;
}

LengthFormat lengthFormat(const Scene& scene) {
  bool isEmpty = !scene.volume.data && !scene.labels.data;
  double voxel = isEmpty ? 1.0 : std::clamp(finestStep(scene), 1e-9, 1e9);
  LengthFormat format{scene.unit, symbolOf(scene.unit), 1.0, 1};
  // Below that a millimetre is many voxels wide, and numbers would be mostly noughts.
  constexpr double kFinest = 0.02;
  if (scene.unit == LengthUnit::Millimetre && voxel < kFinest) {
    bool isMicro = voxel >= kFinest * 1e-3;
    format.symbol = isMicro ? "\xc2\xb5m" : "nm";
    format.toldPerLength = isMicro ? 1e3 : 1e6;
  }
  voxel *= format.toldPerLength;
  format.decimals = std::clamp(int(std::floor(1.5 - std::log10(voxel))), voxel < 100.0 ? 1 : 0, 9);
  return format;
}

std::string lengthNumber(const LengthFormat& format, double length, bool isSigned) {
  length *= format.toldPerLength;
  if (std::abs(length) < 0.5 * std::pow(10.0, -format.decimals)) length = 0.0;
  return isSigned ? fmt::format("{:+.{}f}", length, format.decimals) : fmt::format("{:.{}f}", length, format.decimals);
}

std::string lengthText(const LengthFormat& format, double length, bool isSigned) {
  return fmt::format("{} {}", lengthNumber(format, length, isSigned), format.symbol);
}

std::string roundLengthText(double length, LengthUnit unit) {
  constexpr std::pair<double, const char*> kUnits[] = {{1e6, "km"},       {1e3, "m"},   {1.0, "mm"},
                                                       {1e-3, "\u00b5m"}, {1e-6, "nm"}, {1e-7, "\u00c5"}};
  double mm = length * millimetresPer(unit);
  // The unit that people use for so much of it: mm from a half to ten metres.
  constexpr double kLeast[] = {1e6, 1e4, 0.5, 0.5e-3, 1e-6 * (1.0 - 1e-9), 0.0};
  std::size_t i = 0;
  while (mm < kLeast[i]) ++i;
  return fmt::format("{:.6g} {}", mm / kUnits[i].first, kUnits[i].second);
}

}  // namespace velum::scene
