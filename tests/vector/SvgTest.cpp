#include "vector/WriteSvg.h"

#include <algorithm>
#include <cstdlib>
#include <random>

#include "Programs.h"
#include "vector/Paint.h"

namespace velum::vector {
namespace {

std::size_t countOf(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) ++count;
  return count;
}

TEST(Svg, ThePageHasItsSizeInMillimetres) {
  std::string svg = svgOf(plate());
  EXPECT_NE(svg.find("width=\"33.8667mm\" height=\"25.4mm\" viewBox=\"0 0 400 300\""), std::string::npos);
  EXPECT_EQ(svg, svgOf(plate())) << "the same drawing has the same bytes";
}

TEST(Svg, PlacesOfLongPathsAreWhereTheyWereSinceErrorsDoNotAddUp) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> step(-3.0, 3.1);
  Outline outline{{0.123, 4.567}, {}, false};
  for (glm::dvec2 at = outline.start; outline.curves.size() < 3000; at = outline.curves.back().end) {
    auto near = [&] { return at + glm::dvec2(step(random), step(random)); };
    outline.curves.push_back({near(), near(), near()});
  }
  std::string svg = svgOf({{100, 100}, 300.0, "", {{"lines", {stroked({outline}, Pen{})}}}});
  std::size_t begin = svg.find("d=\"M") + 4;
  std::string path = svg.substr(begin, svg.find('"', begin) - begin);
  EXPECT_EQ(path.find_first_of("CLl"), path.npos);
  // As readers of SVG have it: a number ends where it cannot go on.
  std::vector<double> numbers;
  for (const char* c = path.c_str(); *c;) {
    if (*c == ' ' || *c == 'c') {
      ++c;
      continue;
    }
    char* end = nullptr;
    numbers.push_back(std::strtod(c, &end));
    c = end;
  }
  ASSERT_EQ(numbers.size(), 2 + 6 * outline.curves.size());
  glm::dvec2 at(numbers[0], numbers[1]);
  double worst = 0.0;
  for (std::size_t i = 0; i < outline.curves.size(); ++i) {
    auto place = [&](std::size_t k) { return at + glm::dvec2(numbers[2 + 6 * i + 2 * k], numbers[3 + 6 * i + 2 * k]); };
    const Curve& curve = outline.curves[i];
    for (auto [k, wanted] : {std::pair(0u, curve.control1), {1u, curve.control2}, {2u, curve.end}})
      worst = std::max({worst, std::abs(place(k).x - wanted.x), std::abs(place(k).y - wanted.y)});
    at = place(2);
  }
  EXPECT_LT(worst, 0.00501);
  EXPECT_LT(double(path.size()) / double(outline.curves.size()), 36.0) << "bytes a curve";
}

TEST(Svg, LinesAreShortAndExact) {
  Drawing drawing{
      {100, 100}, 300.0, "", {{"a", {stroked({outlineThrough({{0, -0.001}, {10.126, 5}, {3, 7}}, true)}, Pen{})}}}};
  std::string svg = svgOf(drawing);
  EXPECT_NE(svg.find("d=\"M0 0l10.13 5-7.13 2Z\""), std::string::npos) << svg;
  drawing.layers[0].items = {
      stroked({Outline{{1, 2}, {straight({1, 2}, {5, 6}), straight({5, 6}, {9, 2})}, true}}, Pen{})};
  EXPECT_NE(svgOf(drawing).find("d=\"M1 2l4 4 4-4Z\""), std::string::npos) << svgOf(drawing);
  drawing.layers[0].items = {stroked({Outline{{1, 2}, {{{-3, 4}, {5, -6.5}, {7, 8}}}, false}}, Pen{})};
  EXPECT_NE(svgOf(drawing).find("d=\"M1 2c-4 2 4-8.5 6 6\""), std::string::npos) << svgOf(drawing);
}

TEST(Svg, NamesAreIdsOnceEach) {
  Shape one = filled({circle({5, 5}, 2)});
  one.name = "Lung";
  Drawing drawing{{10, 10}, 300.0, "", {{"Lung", {one, one, Words{"Lung", {0, 5}}}}, {"Lung", {one}}}};
  std::string svg = svgOf(drawing);
  for (const char* id :
       {"id=\"Lung\"", "id=\"Lung-2\"", "id=\"Lung-3\"", "id=\"Lung-4\"", "id=\"layer-Lung\"", "id=\"layer-Lung-2\""})
    EXPECT_EQ(countOf(svg, id), 1u) << id;
  EXPECT_EQ(countOf(svg, "inkscape:groupmode=\"layer\" inkscape:label=\"Lung\""), 2u);
  EXPECT_EQ(countOf(svg, "<title>Lung</title>"), 3u);
}

TEST(Svg, ShapesOfAGroupAreOneElementAndHiddenLayersAreOff) {
  Shape one = filled({circle({5, 5}, 2)}), other = one, alone = one;
  one.group = other.group = "capsid / surface";
  Drawing drawing{{10, 10}, 300.0, "", {{"contours", {one, other, alone}, true}}};
  std::string svg = svgOf(drawing);
  EXPECT_NE(svg.find("inkscape:label=\"contours\" style=\"display:none\">"), std::string::npos) << svg;
  EXPECT_EQ(countOf(svg, "<g id=\"capsid-surface\" inkscape:label=\"capsid / surface\">"), 1u) << svg;
  EXPECT_EQ(countOf(svg, "<g "), countOf(svg, "</g>"));
  std::size_t group = svg.find("capsid-surface"), end = svg.find("</g>", group);
  EXPECT_EQ(countOf(svg.substr(group, end - group), "<path"), 2u) << "and the third stands behind it";
}

TEST(Svg, WhatCannotBeDrawnIsLeftOut) {
  std::string svg = svgOf({{10, 10}, 300.0, "", {{"a", undrawable()}}});
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf\""), std::string::npos);
  EXPECT_EQ(svg.find("<path"), std::string::npos);
}

TEST(Svg, LinesAndLabelsAreSmall) {
  Drawing drawing{{4000, 3000}, 300.0, "", {{"contours", {}}, {"labels", {}}}};
  for (int i = 0; i < 100; ++i) drawing.layers[0].items.push_back(stroked({wave(i)}, Pen{}));
  for (int i = 0; i < 40; ++i)
    drawing.layers[1].items.push_back(
        Words{"Musculus longus", {50, 60.0 * i}, 40.0, Font::Sans, kBlack, 1.0, Pen{kWhite, 9.0}});
  EXPECT_LT(svgOf(drawing).size(), 2'000'000u);
}

class SvgPrograms : public Programs {};

TEST_F(SvgPrograms, RsvgDrawsGroupsAndNoHiddenLayers) {
  if (!has("rsvg-convert")) GTEST_SKIP() << "rsvg-convert is not there: install Debian's librsvg2-bin";
  Shape shown = filled({circle({50, 50}, 20)}), hidden = filled({circle({150, 50}, 20)});
  shown.group = hidden.group = "a & b";
  Drawing drawing{{200, 100}, 300.0, "", {{"on", {shown}}, {"off", {hidden}, true}}};
  writeSvg(drawing, mFolder / "hidden.svg");
  run("rsvg-convert -w 200 -h 100 -b white -o hidden.png hidden.svg");
  Image image = plainImage(200, 100);
  paint(drawing.layers, image);
  EXPECT_NEAR(coverOf(image), 3.1416 * 400, 10.0);
  EXPECT_LT(differenceOf(readPng("hidden.png"), image).far, 0.001);
}

TEST_F(SvgPrograms, RsvgDrawsWhatIsPainted) {
  if (!has("rsvg-convert")) GTEST_SKIP() << "rsvg-convert is not there: install Debian's librsvg2-bin";
  Drawing drawing = plate();
  writeSvg(drawing, mFolder / "plate.svg");
  run("rsvg-convert -w 400 -h 300 -o plate.png plate.svg");
  Image image = plainImage(400, 300);
  paint(drawing.layers, image);
  Difference difference = differenceOf(readPng("plate.png"), image);
  EXPECT_LT(difference.mean, 0.4 / 255.0);
  EXPECT_LT(difference.far, 0.002) << "letters are fitted to pixels there";
}

TEST_F(SvgPrograms, AnyTextIsXml) {
  if (!has("xmllint")) GTEST_SKIP() << "xmllint is not there: install Debian's libxml2-utils";
  Shape shape = filled({circle({5, 5}, 2)});
  shape.name = kHostileText;
  Drawing drawing{{10, 10}, 300.0, kHostileText, {{kHostileText, {shape, Words{kHostileText, {0, 5}}}}}};
  writeSvg(drawing, mFolder / "plate.svg");
  // What it reads is what was written: the text of <text>, in UTF-8.
  EXPECT_EQ(run("xmllint --xpath 'string(//*[local-name()=\"text\"])' plate.svg"),
            "<\"&'>]]>--> \xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd (\\)%s{}\xe6\xbc\xa2\xf0\x9f\x98\x80\n");
  writeSvg(plate(), mFolder / "whole.svg");
  EXPECT_EQ(run("xmllint --noout whole.svg && echo fine"), "fine\n");
}

TEST_F(SvgPrograms, InkscapeFindsLayersAndText) {
  if (!has("inkscape")) GTEST_SKIP() << "inkscape is not there";
  writeSvg(plate(), mFolder / "plate.svg");
  std::string all = run("inkscape --query-all plate.svg");
  for (const char* id :
       {"layer-picture,", "layer-contours,", "layer-labels,", "Lung-left,", "Pulmo-sinister,", "Hepar,"})
    EXPECT_NE(all.find(id), std::string::npos) << id << "\n" << all;
  run("inkscape --export-type=png --export-width=400 --export-filename=plate.png plate.svg");
  Image image = plainImage(400, 300);
  paint(plate().layers, image);
  EXPECT_LT(differenceOf(readPng("plate.png"), image).mean, 1.0 / 255.0);
  EXPECT_LT(differenceOf(readPng("plate.png"), image).far, 0.004);
}

}  // namespace
}  // namespace velum::vector
