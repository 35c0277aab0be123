#pragma once
#include <cstddef>
#include <initializer_list>
#include <string_view>

#include "gpu/Buffer.h"
#include "gpu/Handle.h"

namespace velum::gpu {

void deleteVertexArray(unsigned id);

/// One input of a vertex shader, from a buffer that must outlive the vertex array.
struct Attribute {
  enum class Type { Float, Uint };
  unsigned location = 0;
  const Buffer* buffer = nullptr;
  int components = 4;  ///< 1..4, four bytes each
  Type type = Type::Float;
  std::size_t offset = 0;    ///< Bytes from the buffer's beginning to the first vertex's value.
  std::size_t stride = 0;    ///< Bytes from one vertex to the next; 0: tightly packed.
  bool perInstance = false;  ///< One value for each instance, from the draw's first instance on. In OpenGL 4.5 this is
                             ///< how instances of an indirect draw know their numbers.
};

/// The attributes and indices that draws read. GL thread.
class VertexArray : public Handle<deleteVertexArray> {
 public:
  VertexArray() = default;
  /// @param indices  32-bit indices for indexed draws, must outlive this; nullptr: none
  VertexArray(std::string_view label, std::initializer_list<Attribute> attributes, const Buffer* indices = nullptr);
};

}  // namespace velum::gpu
