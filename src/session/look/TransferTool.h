#pragma once
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "scene/TransferFunction.h"

namespace velum::session {

/// The stretch of the value axis that an editor shows; low < high.
struct AxisView {
  double low = 0, high = 1;
  bool operator==(const AxisView&) const = default;
};
/// A view nearer by a factor < 1 (farther: > 1), about a value that stays at its place. Never wider than `whole`, never
/// narrower than a hundred-thousandth of it.
AxisView zoomAxis(AxisView view, double about, double factor, AxisView whole);
/// The view moved by a length of the axis, as far as `whole` goes.
AxisView panAxis(AxisView view, double by, AxisView whole);
/// Round values on the axis, at most `most` (at least 2), ascending.
std::vector<double> axisTicks(AxisView view, int most);
/// A value with the digits that an axis of this width needs: "-250", "0.0125".
std::string axisNumber(double value, AxisView view);

using Curve = std::vector<scene::OpacityPoint>;
using Stops = std::vector<scene::ColorPoint>;

/// Adds a point at its place in the order of the values. @return its index
int addPoint(Curve& curve, double value, double opacity);
/// Moves a point as far as its neighbours let it (two may share a value: a step), opacity kept in 0..1.
void movePoint(Curve& curve, int index, double value, double opacity);
/// @return false for the last point, which stays: a curve without points would hide everything
bool removePoint(Curve& curve, int index);

/// The same for stops of colour. A new stop has the colour that is already there, so that adding it changes no picture.
int addStop(Stops& stops, double value);
void moveStop(Stops& stops, int index, double value);
bool removeStop(Stops& stops, int index);

/// Moves opacities and colours along the value axis together.
void shiftTransfer(scene::TransferFunction& transfer, double by);
/// Spreads opacities and colours about a value by a factor > 0.
void stretchTransfer(scene::TransferFunction& transfer, double about, double factor);
/// Multiplies all opacities by a factor; they end at 1.
void scaleOpacity(scene::TransferFunction& transfer, double factor);
/// The middle of the values between which the opacities change.
double middleOf(const scene::TransferFunction& transfer);

/// Where a curve is drawn: pixels, y down. Heights are the opacity to a power, so that the faint opacities of which
/// most pictures are made have room.
struct CurveFrame {
  glm::dvec2 topLeft{0.0}, size{1.0};
  AxisView view;
  double power = 0.5;
};
double xOf(const CurveFrame& frame, double value);
double valueAtX(const CurveFrame& frame, double x);
double yOf(const CurveFrame& frame, double opacity);
double opacityAtY(const CurveFrame& frame, double y);

/// The part of a curve under the pointer: a point, the line itself, the area below it, or nothing.
struct CurveHit {
  enum class Part { Nothing, Point, Line, Area };
  Part part = Part::Nothing;
  int index = -1;  ///< of the point
};
/// @param reach  pixels
CurveHit hitCurve(const CurveFrame& frame, const Curve& curve, glm::dvec2 pixel, double reach);
/// The index of the nearest stop within reach of x, pixels; -1: none.
int hitStop(const CurveFrame& frame, const Stops& stops, double x, double reach);

/// The curve in pixels from one end of the frame to the other, bent as the heights are by CurveFrame::power.
std::vector<glm::dvec2> outlineOf(const CurveFrame& frame, const Curve& curve);

}  // namespace velum::session
