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
// Sums that must come out alike wherever they are written: shaders must say so (C++ is built with -ffp-contract=off).
#define SHARED_EXACT
// The rows of all sheets: C++ is handed them as a last parameter; shaders have them as a buffer texture, which software
// drivers fetch from far faster than from a storage block, or, where they write them, as a block.
#define SHARED_SHEETS , const velum::shared::SheetRows& sheets
#define SHARED_PASS_SHEETS , sheets
#define SHARED_HAS_SHEETS 1
#define SHARED_SHEET_BLOCK(unit)
#define SHARED_SHEET_ROW(i) sheets.rows[i]
// Shaders that are compiled for planes alone leave out the other shapes.
#define SHARED_SHAPE(kind) (kind)
namespace velum::shared {
using glm::ivec2, glm::ivec3, glm::ivec4, glm::mat4, glm::uvec4, glm::vec2, glm::vec3, glm::vec4;
using glm::abs, glm::ceil, glm::clamp, glm::cross, glm::dot, glm::floor, glm::length, glm::max, glm::min, glm::mix;
using glm::normalize, glm::pow, glm::smoothstep, glm::sqrt;
using uint = std::uint32_t;
struct SheetRows {
  const vec4* rows = nullptr;
};
}
#else
#define SHARED_BEGIN
#define SHARED_END
#define SHARED_CONST const
#define SHARED_FN
#define SHARED_EXACT precise
#define SHARED_SHEETS
#define SHARED_PASS_SHEETS
#ifdef PLANES
#define SHARED_SHAPE(kind) kCutPlane
#else
#define SHARED_SHAPE(kind) (kind)
#endif
#ifdef WRITES_SHEET
#define SHARED_SHEET_BLOCK(unit) layout(std430, binding = kSheetBinding) buffer SheetBlock { vec4 sheetRows[]; };
#define SHARED_SHEET_ROW(i) sheetRows[i]
#else
#define SHARED_SHEET_BLOCK(unit) layout(binding = unit) uniform samplerBuffer sheetRows;
#define SHARED_SHEET_ROW(i) texelFetch(sheetRows, i)
#endif
#ifdef MEMBRANES
#define SHARED_HAS_SHEETS 1
#else
#define SHARED_HAS_SHEETS 0
#endif
#endif
#endif
