#include "session/lettering/Letters.h"

#include <freetype/freetype.h>
#include <freetype/ftoutln.h>

#include <cmath>
#include <cstdint>

#include "core/Assert.h"

namespace velum::session {

struct Letters::Face {
  FT_Library library = nullptr;
  FT_Face face = nullptr;
  explicit Face(std::span<const unsigned char> file) {
    bool isRead = FT_Init_FreeType(&library) == 0 &&
                  FT_New_Memory_Face(library, file.data(), FT_Long(file.size()), 0, &face) == 0;
    VELUM_ASSERT(isRead, "the font is part of the program");
  }
  ~Face() {
    FT_Done_Face(face);
    FT_Done_FreeType(library);
  }
  Face(const Face&) = delete;
  Face& operator=(const Face&) = delete;
};

Letters::Letters(double em)
    : vector::Letters(vector::Font::Sans, em), mFace(std::make_unique<Face>(vector::fontFile(vector::Font::Sans))) {
  FT_Set_Char_Size(mFace->face, 0, FT_F26Dot6(std::lround(em * 64.0)), 72, 72);
}

Letters::~Letters() = default;

void Letters::draw(std::string_view text, glm::dvec2 start, Mark& mark) const {
  FT_Bitmap bitmap{};
  bitmap.rows = unsigned(mark.size.y);
  bitmap.width = unsigned(mark.size.x);
  bitmap.pitch = mark.size.x;
  bitmap.buffer = mark.covers.data();
  bitmap.num_grays = 256;
  bitmap.pixel_mode = FT_PIXEL_MODE_GRAY;
  start -= glm::dvec2(mark.corner);
  for (const vector::Glyph& glyph : glyphs(text)) {
    if (FT_Load_Glyph(mFace->face, glyph.index, FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP) != 0) continue;
    FT_Outline& outline = mFace->face->glyph->outline;
    FT_Outline_Translate(&outline, FT_Pos(std::lround((start.x + glyph.x) * 64.0)),
                         FT_Pos(std::lround((mark.size.y - start.y) * 64.0)));
    FT_Outline_Get_Bitmap(mFace->library, &outline, &bitmap);
  }
}

}  // namespace velum::session
