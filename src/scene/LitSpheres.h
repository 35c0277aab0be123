#pragma once
#include <glm/glm.hpp>
#include <span>
#include <string_view>

#include "core/Image.h"

namespace velum::scene {

/// Edge of the pictures of lit spheres that are drawn with, pixels.
constexpr int kLitSphereSize = 128;

/// A lit sphere of ours.
struct LitSphereName {
  std::string_view name;   ///< "porcelain"
  std::string_view title;  ///< "Porcelain"
};

/// Every one, in the order of the window.
std::span<const LitSphereName> litSpheres();

/// The colour of a lit sphere of ours where its normal points, sRGB.
/// @param n  unit: x to the right, y up, z to the eye
/// @throw ArgumentError for an unknown name, listing the known ones
glm::vec3 litSphereColor(std::string_view name, glm::vec3 n);

/// Its picture: R, G, B; the sphere fills the square to its edges, corners go on as its rim.
/// @throw ArgumentError as above
Image makeLitSphere(std::string_view name, int size = kLitSphereSize);

/// A user's picture as one to draw with: R, G, B, square, of our size; the largest square in its middle.
Image fitLitSphere(const Image& picture);

}  // namespace velum::scene
