#include "io/looks/SlicerProperty.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/Error.h"
#include "core/Text.h"
#include "io/read/Losses.h"
#include "io/read/Refuse.h"

namespace velum::io {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostPoints = 4096;   // more than anybody has set by hand
constexpr std::size_t kLongestLine = 1023;  // that Slicer reads of a .vp
constexpr double kLargestValue = 1e300;     // beyond, differences overflow
constexpr const char* kLightIsLeftOut = "the file's light is left out";

// ---- text

/// The next number of a line, which loses it; nothing at its end. @throw InputError for what is none
bool takeNext(std::string_view& line, double& number, int lineNumber) {
  std::size_t start = line.find_first_not_of(" \t\r");
  if (start == std::string_view::npos) return false;
  line.remove_prefix(start);
  std::string_view word = line.substr(0, line.find_first_of(" \t\r"));
  // Slicer itself steps to the next double above zero, which is too small to be read as one: that is 0.
  number = numberIn(word).value_or(std::nan(""));
  if (!(std::abs(number) <= kLargestValue))
    throw InputError(fmt::format("line {}: '{}' is not a number", lineNumber, word.substr(0, 40)));
  line.remove_prefix(word.size());
  return true;
}

/// A list led by how many numbers it has.
std::vector<double> numbersOf(std::string_view line, int perPoint, int lineNumber) {
  double count = 0;
  if (!takeNext(line, count, lineNumber)) return {};
  if (count < 0 || count != std::floor(count) || std::fmod(count, perPoint) != 0 ||
      count > double(kMostPoints) * perPoint)
    throw InputError(fmt::format("line {}: {} is no count of points of {} numbers", lineNumber, count, perPoint));
  std::vector<double> numbers;
  double number = 0;
  while (double(numbers.size()) < count && takeNext(line, number, lineNumber)) numbers.push_back(number);
  if (double(numbers.size()) < count)
    throw InputError(
        fmt::format("line {}: {} numbers are announced and {} are there", lineNumber, count, numbers.size()));
  return numbers;
}

std::vector<scene::OpacityPoint> pairsOf(std::string_view line, int lineNumber) {
  std::vector<scene::OpacityPoint> points;
  auto numbers = numbersOf(line, 2, lineNumber);
  for (std::size_t i = 0; i < numbers.size(); i += 2) points.push_back({numbers[i], numbers[i + 1]});
  return points;
}

/// A number with all its digits, and with the six that Slicer itself writes.
struct Digits {
  std::string all, six;
  explicit Digits(double number) : all(fmt::format("{}", number)), six(fmt::format("{:.6g}", number)) {}
  explicit Digits(float number) : all(fmt::format("{}", number)), six(fmt::format("{:.6g}", number)) {}
};

/// A list led by its length; with six digits where the line would be too long for Slicer with all.
std::string listText(const std::vector<Digits>& numbers, const char* what, Losses& losses) {
  std::string line = fmt::format("{}", numbers.size()), shorter = line;
  bool isRounded = false;
  for (const Digits& number : numbers) {
    line += " " + number.all;
    shorter += " " + number.six;
    isRounded = isRounded || numberIn(number.all) != numberIn(number.six);
  }
  if (shorter.size() > kLongestLine)
    throw InputError(fmt::format("{} has too many points: Slicer reads {} characters of a line; write .vp.json instead",
                                 what, kLongestLine));
  if (line.size() <= kLongestLine) return line + "\n";
  losses.say(isRounded, "numbers of {} are rounded to six digits: Slicer reads {} characters of a line", what,
             kLongestLine);
  return shorter + "\n";
}

std::vector<Digits> flat(const std::vector<scene::OpacityPoint>& points) {
  std::vector<Digits> numbers;
  for (const auto& point : points) {
    numbers.emplace_back(point.value);
    numbers.emplace_back(point.opacity);
  }
  return numbers;
}

/// The curve for another thickness of material.
double opacityForUnit(double opacity, double unitMm) {
  return unitMm == 1.0 ? opacity : 1.0 - std::pow(1.0 - std::clamp(opacity, 0.0, 1.0), 1.0 / unitMm);
}

// ---- JSON

double numberAt(const Json& object, const char* name, double fallback) {
  auto it = object.find(name);
  if (it == object.end()) return fallback;
  if (!it->is_number() || !(std::abs(it->get<double>()) <= kLargestValue))
    throw InputError(fmt::format("\"{}\" is not a number", name));
  return it->get<double>();
}

const Json& listAt(const Json& object, const char* name) {
  auto it = object.find(name);
  if (it == object.end() || !it->is_array()) throw InputError(fmt::format("there is no list \"{}\"", name));
  if (it->size() > kMostPoints)
    throw InputError(fmt::format("\"{}\" has {} items; {} is the most", name, it->size(), kMostPoints));
  return *it;
}

struct Bend {
  double midpoint = 0.5, sharpness = 0.0;
  bool isStraight() const { return midpoint == 0.5 && sharpness < 0.01; }
};
Bend bendOf(const Json& point) {
  return {std::clamp(numberAt(point, "midpoint", 0.5), 1e-5, 1.0 - 1e-5),
          std::clamp(numberAt(point, "sharpness", 0.0), 0.0, 1.0)};
}

/// How far along from one height to the next a bent segment is, as VTK's piecewise functions define it: the midpoint
/// is where half is reached; sharpness goes from a line over a Hermite curve to a step.
double bent(Bend bend, double s) {
  s = s < bend.midpoint ? 0.5 * s / bend.midpoint : 0.5 + 0.5 * (s - bend.midpoint) / (1.0 - bend.midpoint);
  if (bend.sharpness > 0.99) return s < 0.5 ? 0.0 : 1.0;
  if (bend.sharpness < 0.01) return s;
  double power = 1.0 + 10.0 * bend.sharpness;
  s = s < 0.5 ? 0.5 * std::pow(s * 2.0, power) : 1.0 - 0.5 * std::pow((1.0 - s) * 2.0, power);
  double ss = s * s, sss = ss * s, tangent = 1.0 - bend.sharpness;
  return std::clamp(-2.0 * sss + 3.0 * ss + tangent * (2.0 * sss - 3.0 * ss + s), 0.0, 1.0);
}

/// Puts points between two where the segment is bent. `mix(a, b, t, value)` makes one.
template <class Point, class Mix>
std::vector<Point> straightened(const std::vector<std::pair<Point, Bend>>& points, Mix mix) {
  constexpr int kPieces = 12;
  std::vector<Point> out;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& [point, bend] = points[i];
    out.push_back(point);
    if (i + 1 == points.size() || bend.isStraight()) continue;
    const Point& next = points[i + 1].first;
    for (int piece = 1; piece < kPieces; ++piece) {
      double s = double(piece) / kPieces;
      out.push_back(mix(point, next, bent(bend, s), glm::mix(point.value, next.value, s)));
    }
  }
  return out;
}

template <class Point>
int bentCount(const std::vector<std::pair<Point, Bend>>& points) {
  return int(std::count_if(points.begin(), points.end(), [](const auto& p) { return !p.second.isStraight(); }));
}

template <class Point>
void sortByValue(std::vector<std::pair<Point, Bend>>& points) {
  std::stable_sort(points.begin(), points.end(),
                   [](const auto& a, const auto& b) { return a.first.value < b.first.value; });
}

std::vector<scene::OpacityPoint> curveAt(const Json& component, const char* name, int& bends) {
  auto it = component.find(name);
  if (it == component.end()) return {};
  std::vector<std::pair<scene::OpacityPoint, Bend>> points;
  for (const Json& point : listAt(*it, "points"))
    points.push_back({{numberAt(point, "x", 0.0), numberAt(point, "y", 0.0)}, bendOf(point)});
  sortByValue(points);
  bends += bentCount(points);
  return straightened(points, [](const auto& a, const auto& b, double t, double value) {
    return scene::OpacityPoint{value, glm::mix(a.opacity, b.opacity, t)};
  });
}

std::vector<scene::ColorPoint> colorsAt(const Json& component, const char* name, int& bends) {
  auto it = component.find(name);
  if (it == component.end()) return {};
  std::vector<std::pair<scene::ColorPoint, Bend>> stops;
  for (const Json& point : listAt(*it, "points")) {
    const Json& color = listAt(point, "color");
    if (color.size() != 3 || !std::all_of(color.begin(), color.end(), [](const Json& c) { return c.is_number(); }))
      throw InputError("\"color\" is not three numbers");
    glm::vec3 rgb(color[0].get<float>(), color[1].get<float>(), color[2].get<float>());
    for (int c = 0; c < 3; ++c) rgb[c] = std::isfinite(rgb[c]) ? rgb[c] : 0.0f;
    stops.push_back({{numberAt(point, "x", 0.0), rgb}, bendOf(point)});
  }
  sortByValue(stops);
  bends += bentCount(stops);
  return straightened(stops, [](const auto& a, const auto& b, double t, double value) {
    return scene::ColorPoint{value, glm::mix(a.color, b.color, float(t))};
  });
}

Json pointsJson(const std::vector<scene::OpacityPoint>& points) {
  Json list = Json::array();
  for (const auto& p : points)
    list.push_back({{"x", p.value}, {"y", p.opacity}, {"midpoint", 0.5}, {"sharpness", 0.0}});
  return {{"type", "piecewiseLinearFunction"}, {"points", list}};
}

Json stopsJson(const std::vector<scene::ColorPoint>& stops) {
  Json list = Json::array();
  for (const auto& p : stops)
    list.push_back(
        {{"x", p.value}, {"color", {p.color.r, p.color.g, p.color.b}}, {"midpoint", 0.5}, {"sharpness", 0.0}});
  return {{"type", "colorTransferFunction"}, {"points", list}};
}

std::vector<scene::OpacityPoint> orOne(const std::vector<scene::OpacityPoint>& gradient) {
  return gradient.empty() ? std::vector<scene::OpacityPoint>{{0.0, 1.0}, {255.0, 1.0}} : gradient;
}
double share(double value) { return std::clamp(value, 0.0, 1.0); }

/// What no property of Slicer has.
Losses lossesOf(const scene::TransferFunction& transfer, const scene::Lighting& lighting) {
  Losses losses;
  losses.say(!transfer.preset.empty(), "the name of the preset, {}, is left out", inQuotes(transfer.preset));
  if (!lighting.shaded) return losses;
  for (auto [what, strength] :
       {std::pair("diffuse", lighting.diffuse), {"ambient", lighting.ambient}, {"specular", lighting.specular}})
    losses.say(strength > 1.0, "{} light of {} becomes 1, the most that Slicer has", what, strength);
  losses.say(lighting.shadow > 0 || lighting.occlusion > 0, "shadows and occlusion are left out: Slicer has none");
  losses.say(lighting.keyDirection != scene::Lighting().keyDirection,
             "the direction of the light is left out: Slicer's comes from the eye");
  return losses;
}

/// Brackets deeper than any property would make the parser recurse.
void checkDepth(std::string_view text) {
  int depth = 0;
  for (char c : text) {
    if ((c == '[' || c == '{') && ++depth > 64) throw InputError("brackets are nested too deep");
    if (c == ']' || c == '}') --depth;
  }
}

}  // namespace

TransferFile parseSlicerText(std::string_view text) {
  std::string_view lines[9];
  int count = 0;
  for (std::size_t at = 0; at < text.size() && count < 9; ++count) {
    std::size_t end = std::min(text.find('\n', at), text.size());
    lines[count] = text.substr(at, end - at);
    at = end + 1;
  }
  if (count < 9) throw InputError(fmt::format("a volume property of Slicer has 9 lines, this has {}", count));
  for (int i = 0; i < 6; ++i) {
    double ignored = 0;
    takeNext(lines[i], ignored, i + 1);
  }
  TransferFile file;
  file.isGradientPerVoxel = true;
  file.transfer.opacities = pairsOf(lines[6], 7);
  file.transfer.gradientOpacities = pairsOf(lines[7], 8);
  auto colors = numbersOf(lines[8], 4, 9);
  for (std::size_t i = 0; i < colors.size(); i += 4)
    file.transfer.colors.push_back({colors[i], glm::vec3(colors[i + 1], colors[i + 2], colors[i + 3])});
  file.warnings.push_back(kLightIsLeftOut);
  return file;
}

TransferFile parseSlicerJson(std::string_view text) {
  checkDepth(text);
  Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) throw InputError("the text is not a JSON object; the file is damaged or of another kind");
  const Json& properties = listAt(json, "volumeProperties");
  if (properties.empty() || !properties[0].is_object()) throw InputError("\"volumeProperties\" is empty");
  const Json& components = listAt(properties[0], "components");
  if (components.empty() || !components[0].is_object()) throw InputError("\"components\" is empty");
  const Json& component = components[0];
  TransferFile file;
  file.isGradientPerVoxel = true;
  int bends = 0;
  file.transfer.opacities = curveAt(component, "scalarOpacity", bends);
  file.transfer.colors = colorsAt(component, "rgbTransferFunction", bends);
  auto disabled = component.find("disableGradientOpacity");
  bool isOff = disabled != component.end() && disabled->is_boolean() && disabled->get<bool>();
  if (!isOff) file.transfer.gradientOpacities = curveAt(component, "gradientOpacity", bends);
  double unit = numberAt(component, "scalarOpacityUnitDistance", 1.0);
  file.transfer.unitDistance = unit > 0 ? std::clamp(unit, 1e-9, 1e9) : 1.0;
  Losses losses;
  losses.say(properties.size() > 1, "of {} properties the first was taken", properties.size());
  losses.say(components.size() > 1, "of {} components the first was taken", components.size());
  losses.say(bends > 0, "{} bent segments became short straight ones", bends);
  losses.say(component.contains("lighting"), "{}", kLightIsLeftOut);
  file.warnings = losses.take();
  return file;
}

TransferText slicerText(const scene::TransferFunction& transfer, const scene::Lighting& lighting) {
  scene::TransferFunction perLength = transfer;
  for (auto& point : perLength.opacities) point.opacity = opacityForUnit(point.opacity, transfer.unitDistance);
  std::vector<Digits> colors;
  for (const auto& stop : transfer.colors) {
    colors.emplace_back(stop.value);
    for (int c = 0; c < 3; ++c) colors.emplace_back(stop.color[c]);
  }
  Losses losses = lossesOf(transfer, lighting);
  losses.say(transfer.unitDistance != 1.0, "opacities are written for 1 mm of material instead of {}: .vp has no other",
             transfer.unitDistance);
  std::string text = fmt::format("1\n{}\n{}\n{}\n{}\n{}\n", lighting.shaded ? 1 : 0, share(lighting.diffuse),
                                 share(lighting.ambient), share(lighting.specular), lighting.shininess);
  text += listText(flat(perLength.opacities), "the opacity curve", losses);
  text += listText(flat(orOne(transfer.gradientOpacities)), "the gradient curve", losses);
  text += listText(colors, "the colour map", losses);
  return {text, losses.take()};
}

TransferText slicerJson(const scene::TransferFunction& transfer, const scene::Lighting& lighting) {
  const char* schema =
      "https://raw.githubusercontent.com/slicer/slicer/main/Modules/Loadable/VolumeRendering/Resources/Schema/"
      "volume-property-schema-v1.0.0.json#";
  Json component = {{"componentWeight", 1.0},
                    {"shade", lighting.shaded},
                    {"lighting",
                     {{"diffuse", share(lighting.diffuse)},
                      {"ambient", share(lighting.ambient)},
                      {"specular", share(lighting.specular)},
                      {"specularPower", lighting.shininess}}},
                    {"disableGradientOpacity", transfer.gradientOpacities.empty()},
                    {"scalarOpacityUnitDistance", transfer.unitDistance},
                    {"rgbTransferFunction", stopsJson(transfer.colors)},
                    {"scalarOpacity", pointsJson(transfer.opacities)},
                    {"gradientOpacity", pointsJson(orOne(transfer.gradientOpacities))}};
  double low = transfer.opacities.empty() ? 0.0 : transfer.opacities.front().value;
  double high = transfer.opacities.empty() ? 1.0 : transfer.opacities.back().value;
  Json property = {{"effectiveRange", {low, high}},
                   {"isoSurfaceValues", Json::array()},
                   {"independentComponents", true},
                   {"interpolationType", "linear"},
                   {"components", Json::array({component})}};
  Json out = {{"@schema", schema}, {"volumeProperties", Json::array({property})}};
  return {out.dump(2) + "\n", lossesOf(transfer, lighting).take()};
}

}  // namespace velum::io
