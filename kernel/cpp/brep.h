// The verbs on shapes of any kind: what the vocabulary of a workplane needs.
//
// Included by the generated header of `src/brep/ffi.rs`; OCCT's own headers stay out of here.
#pragma once

#include <vector>

#include "assemcad-kernel/src/ffi.rs.h"
#include "shim.h"

namespace assemcad {

// Several shapes in their order, on their way in or out.
struct Bundle {
  std::vector<TopoDS_Shape> shapes;

  void push(const Solid& shape);
  std::uint32_t size() const { return static_cast<std::uint32_t>(shapes.size()); }
  SolidPtr at(std::uint32_t index) const;
};
using BundlePtr = std::unique_ptr<Bundle>;
BundlePtr bundle();

// Shared with Rust; defined in the generated header.
struct CenterRaw;
struct MeasureRaw;
struct PlaneRaw;

using Flags = rust::Slice<const bool>;
using Vector = std::array<double, 3>;

// topology.cpp
std::uint8_t kind_of(const Solid& shape);
BundlePtr parts_of(const Solid& shape, std::uint8_t kind);
BundlePtr ancestors_of(const Solid& context, const Solid& of, std::uint8_t kind);
SolidPtr compound_of(const Bundle& shapes);
BundlePtr children_of(const Solid& shape);
bool same_shape(const Solid& a, const Solid& b);
SolidPtr another_handle(const Solid& shape);
SolidPtr shape_moved(const Solid& shape, const Pose& pose);
SolidPtr shape_mirrored(const Solid& shape, const Vector& point, const Vector& normal);
SolidPtr shape_baked(const Solid& shape);

// look.cpp
std::uint8_t form_of(const Solid& shape);
CenterRaw center_of(const Solid& shape);
MeasureRaw measure_of(const Solid& shape);
bool valid_shape(const Solid& shape);
PlaneRaw plane_of(const Solid& face);
Vector normal_of(const Solid& shape, Reals near);

// along.cpp
Vector curve_tangent(const Solid& curve, double share);
Vector curve_position(const Solid& curve, double share);
Vector curve_end(const Solid& curve, bool last);
bool curve_closed(const Solid& curve);
double curve_radius(const Solid& curve);

// curves.cpp
SolidPtr edge_line(const Vector& from, const Vector& to);
SolidPtr edge_arc(const Vector& from, const Vector& via, const Vector& to);
SolidPtr edge_tangent_arc(const Vector& from, const Vector& tangent, const Vector& to);
SolidPtr edge_circle(const At& at, double radius);
SolidPtr edge_circle_arc(const At& at, double radius, double from, double to);
SolidPtr edge_ellipse(const At& at, double x_radius, double y_radius, double rotation);
SolidPtr edge_ellipse_arc(const At& at, double x_radius, double y_radius, double from, double to,
                          bool forward);
SolidPtr edge_spline(Reals points, Reals tangents, Flags given, Reals parameters, bool periodic,
                     bool scale, double tolerance);
SolidPtr edge_spline_approx(Reals points, double tolerance, std::uint32_t min_degree,
                            std::uint32_t max_degree);
SolidPtr edge_bezier(Reals points);

// wires.cpp
SolidPtr wire_of(const Bundle& edges);
BundlePtr wires_connected(const Bundle& curves, double tolerance);
SolidPtr wire_polyline(Reals points, bool close);
SolidPtr wire_helix(const At& at, double pitch, double height, double radius, double half_angle,
                    bool left);
BundlePtr wire_offset(const Solid& wire, double distance, std::uint8_t corner);

// areas.cpp
SolidPtr face_of_wires(const Bundle& wires);
BundlePtr faces_of_wires(const Bundle& wires);
SolidPtr outer_wire_of(const Solid& face);
BundlePtr inner_wires_of(const Solid& face);

}  // namespace assemcad
