#include "app/Inputs.h"
#include "scene/Scene.h"

namespace velum::app {

void addDrawn(CLI::App& verb, DrawnOptions& drawn) {
  session::PictureOptions& picture = drawn.picture;
  verb.add_option("--size", drawn.size, "WIDTHxHEIGHT in pixels, or with a unit: 12x8cm, 120x80mm, 5x3in")
      ->capture_default_str();
  verb.add_option("--dpi", picture.dpi,
                  "pixels an inch in print: for sizes with a unit (else 300), and told in the file")
      ->check(CLI::Range(1.0, 10000.0));
  verb.add_option("--bits", picture.bits, "levels of colour: 8 bits, or 16, also in .exr")
      ->check(CLI::IsMember({8, 16}));
  verb.add_option("--section", drawn.section, "a section view instead of the 3D picture: axial, coronal, sagittal");
  verb.add_option("--samples", picture.samples, "pictures that are averaged, 1 to 256; default: as the scene says")
      ->check(CLI::Range(1, 256));
}

session::PictureOptions pictureOf(const DrawnOptions& drawn) {
  session::PictureOptions picture = drawn.picture;
  picture.size = session::parsePictureSize(drawn.size, picture.dpi);
  return picture;
}

std::optional<scene::SectionKind> sectionOf(const DrawnOptions& drawn) {
  if (drawn.section.empty()) return std::nullopt;
  auto section = named<scene::SectionKind>("--section", drawn.section);
  if (drawn.picture.layers) throw ArgumentError("--layers: a section has none; leave it out with --section");
  return section;
}

}  // namespace velum::app
