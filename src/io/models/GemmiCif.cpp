#include "io/models/GemmiCif.h"

#include <gemmi/cif.hpp>

namespace velum::io {

namespace cif = gemmi::cif;

void parseCif(const char* text, std::size_t size, CifListener& listener) {
  cif::Document document = cif::read_memory(text, size, "line");
  for (cif::Block& block : document.blocks) {
    listener.beginBlock(block.name);
    for (cif::Item& item : block.items) {
      if (item.type == cif::ItemType::Pair) listener.takePair(item.pair[0], item.pair[1]);
      if (item.type == cif::ItemType::Loop && item.loop.width() > 0 && item.loop.values.size() % item.loop.width() == 0)
        listener.takeLoop(item.loop.tags, item.loop.values);
    }
  }
}

bool isNullInCif(const std::string& value) { return cif::is_null(value); }
std::string textInCif(const std::string& value) { return cif::as_string(value); }

}  // namespace velum::io
