#pragma once
#include <glm/glm.hpp>
#include <span>
#include <string_view>

#include "core/Image.h"

namespace velum::scene {

/// Edge of the pictures of lit spheres as the renderer uses them, pixels.
constexpr int kLitSphereSize = 128;

/// A lit sphere of ours.
struct LitSphereName {
  std::string_view name;   ///< "porcelain"
  std::string_view title;  ///< "Porcelain"
};

/// Every lit sphere of ours, in the order of the window.
std::span<const LitSphereName> litSpheres();

/// The colour of a lit sphere of ours where its normal points, sRGB.
/// @param n  unit: x to the right, y up, z to the eye
/// @throw ArgumentError for an unknown name, listing the known ones
glm::vec3 litSphereColor(std::string_view name, glm::vec3 n);

/// The picture of a lit sphere of ours: R, G, B; the sphere fills the square to its edges, and the corners have the
/// colours of its rim.
/// @throw ArgumentError as above
Image makeLitSphere(std::string_view name, int size = kLitSphereSize);

/// A user's picture as the renderer needs it: R, G, B, kLitSphereSize pixels square, made from the largest square in
/// the middle of the picture.
Image fitLitSphere(const Image& picture);

}  // namespace velum::scene
