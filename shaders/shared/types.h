// Types and words that mean the same thing to C++ and GLSL. The only file with host/device #ifdefs.
#ifndef VELUM_SHARED_TYPES_H
#define VELUM_SHARED_TYPES_H
#ifdef __cplusplus
#include <cstdint>
#include <glm/glm.hpp>
#define SHARED_BEGIN namespace velum::shared {
#define SHARED_END }
#define SHARED_CONST inline constexpr
#define SHARED_FN inline
namespace velum::shared {
using glm::ivec4, glm::mat4, glm::uvec4, glm::vec2, glm::vec3, glm::vec4, glm::ivec3;
using glm::abs, glm::clamp, glm::dot, glm::length, glm::max, glm::min, glm::mix, glm::normalize, glm::sqrt;
using uint = std::uint32_t;
}
#else
#define SHARED_BEGIN
#define SHARED_END
#define SHARED_CONST const
#define SHARED_FN
#endif
#endif
