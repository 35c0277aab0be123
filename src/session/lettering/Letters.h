#pragma once
#include <glm/glm.hpp>
#include <memory>
#include <string_view>

#include "session/lettering/Mark.h"
#include "vector/Letters.h"

namespace velum::session {

/// Letters of one size that are drawn into marks: the same text has the same pixels everywhere. One thread at a time.
class Letters : public vector::Letters {
 public:
  /// @param em  size of the letters, pixels, > 0
  explicit Letters(double em);
  ~Letters();

  /// Draws a text into a mark. @param start  of the base line, pixels of the picture
  void draw(std::string_view text, glm::dvec2 start, Mark& mark) const;

 private:
  struct Face;
  std::unique_ptr<Face> mFace;
};

}  // namespace velum::session
