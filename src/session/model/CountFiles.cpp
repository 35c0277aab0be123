#include "session/model/CountFiles.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "core/Text.h"
#include "session/model/ModelEdit.h"

namespace velum::session {

namespace {

/// The text as a field of CSV: in quotes where it holds a comma, a quote or a line end.
std::string csvField(const std::string& text) {
  return text.find_first_of(",\"\n\r") == std::string::npos ? text : csvQuoted(text);
}

std::string xmlText(std::string_view text) {
  std::string out;
  for (char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (static_cast<unsigned char>(c) >= 0x20)
      out += c;
  }
  return out;
}

/// The text, not longer than so many letters; an ellipsis stands for letters that are left out.
std::string shortened(const std::string& text, std::size_t most) {
  std::size_t letters = 0, at = 0;
  for (; at < text.size(); ++at)
    if ((static_cast<unsigned char>(text[at]) & 0xc0u) != 0x80u && ++letters > most) break;
  return at == text.size() ? text : text.substr(0, at) + "…";
}

// Lengths of the drawing, pixels.
constexpr double kEdge = 16, kRow = 20, kBarHeight = 14, kNameWidth = 250, kBarWidth = 420, kTotalWidth = 74;
constexpr double kHead = 58, kIndent = 12, kLetter = 6.4, kFont = 11;

void addText(std::string& svg, double x, double y, const char* anchor, std::string_view fill, std::string_view text,
             bool isBold = false) {
  svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" fill=\"{}\"{}>{}</text>\n", x, y, anchor, fill,
                     isBold ? " font-weight=\"bold\"" : "", xmlText(text));
}

void addBar(std::string& svg, const CountRow& row, double y) {
  double x = kEdge + kNameWidth, total = double(row.count.total());
  for (std::size_t i = 0; i < kCountKinds.size(); ++i) {
    const CountKind& kind = kCountKinds[i];
    std::uint64_t count = row.count.parts[i];
    if (count == 0) continue;
    double width = kBarWidth * double(count) / total;
    std::string number = countText(count);
    svg += fmt::format(
        "<rect x=\"{:.2f}\" y=\"{:.1f}\" width=\"{:.2f}\" height=\"{:.0f}\" fill=\"{}\"><title>{}: {} {}"
        "</title></rect>\n",
        x, y, width, kBarHeight, kind.fill, xmlText(row.path), number, kind.adjective);
    if (width > kLetter * double(number.size()) + 6)
      addText(svg, x + width / 2, y + kBarHeight - 3.5, "middle", kind.letter, number);
    x += width;
  }
}

}  // namespace

std::vector<CountRow> countRows(const scene::ModelLayer& layer, const std::vector<Counts>& types) {
  const Model& model = *layer.data;
  auto named = [&](CountRow row) {
    if (std::string own = scene::ownName(layer, row.path); !own.empty()) row.name = own;
    return row;
  };
  std::vector<Counts> compartments = render::countCompartments(model, types);
  std::vector<CountRow> rows;
  std::function<void(std::uint32_t, int)> add = [&](std::uint32_t compartment, int depth) {
    rows.push_back(named({compartmentPath(model, compartment), model.compartments[compartment].name, true, depth,
                          compartments[compartment]}));
    for (std::uint32_t t = 0; t < model.types.size(); ++t)
      if (model.types[t].compartment == compartment)
        rows.push_back(named({pathOf(model, model.types[t]), model.types[t].name, false, depth + 1, types[t]}));
    for (std::uint32_t c = compartment + 1; c < model.compartments.size(); ++c)
      if (model.compartments[c].parent == std::int32_t(compartment)) add(c, depth + 1);
  };
  for (std::uint32_t c = 0; c < model.compartments.size(); ++c)
    if (model.compartments[c].parent < 0) add(c, 0);
  return rows;
}

std::string countsCsv(const std::vector<CountRow>& rows) {
  std::string csv = "kind,path,name," + countColumns() + "\n";
  for (const CountRow& row : rows)
    csv += fmt::format("{},{},{},{}\n", row.isCompartment ? "compartment" : "type", csvField(row.path),
                       csvField(row.name), countFields(row.count));
  return csv;
}

std::string instancesCsv(const Model& model, const render::InstanceBits& bits) {
  std::vector<std::string> paths;
  for (const MoleculeType& type : model.types) paths.push_back(csvField(pathOf(model, type)));
  std::string csv = "instance,type,state\n";
  for (std::uint64_t i = 0; i < bits.count; ++i) {
    const Instance& instance = model.instances[i % model.instances.size()];
    csv += fmt::format("{},{},{}\n", i, paths[model.molecules[instance.molecule].type],
                       kCountKinds[std::size_t(bits.kindOf(i))].name);
  }
  return csv;
}

std::string countsSvg(const std::vector<CountRow>& rows, const std::string& title) {
  double width = 2 * kEdge + kNameWidth + kBarWidth + kTotalWidth, height = kHead + kRow * double(rows.size()) + kEdge;
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{:.0f}\" height=\"{:.0f}\" viewBox=\"0 0 "
      "{:.0f} {:.0f}\" font-family=\"sans-serif\" font-size=\"{:.0f}\">\n",
      width, height, width, height, kFont);
  svg += fmt::format("<rect width=\"{:.0f}\" height=\"{:.0f}\" fill=\"#ffffff\"/>\n", width, height);
  addText(svg, kEdge, 24, "start", "#202020", shortened(title, 100), true);
  double x = kEdge + kNameWidth;
  for (const CountKind& kind : kCountKinds) {
    svg += fmt::format("<rect x=\"{:.1f}\" y=\"36\" width=\"12\" height=\"12\" fill=\"{}\"/>\n", x, kind.fill);
    addText(svg, x + 17, 46, "start", "#202020", kind.adjective);
    x += 90;
  }
  addText(svg, width - kEdge, 46, "end", "#202020", "total");
  double y = kHead;
  for (const CountRow& row : rows) {
    double indent = kIndent * row.depth;
    auto letters = std::size_t(std::max(4.0, (kNameWidth - indent - 8) / kLetter));
    addText(svg, kEdge + indent, y + kBarHeight - 3, "start", "#202020", shortened(row.name, letters),
            row.isCompartment);
    addBar(svg, row, y);
    addText(svg, width - kEdge, y + kBarHeight - 3, "end", "#202020", countText(row.count.total()), row.isCompartment);
    y += kRow;
  }
  return svg + "</svg>\n";
}

}  // namespace velum::session
