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

// sweeps.cpp
SolidPtr extrude(const Solid& profile, const Vector& vector);
SolidPtr extrude_tapered(const Solid& face, double slant, double taper);
SolidPtr extrude_until(const Solid& basis, const Solid& face, const Bundle& up_to, double taper,
                       bool additive);
BundlePtr faces_on_line(const Solid& shape, const Vector& point, const Vector& direction,
                        std::uint8_t side, double tolerance);
SolidPtr extrude_twisted(const Solid& face, const Vector& center, const Vector& vector,
                         double radians);
SolidPtr turn_about(const Solid& profile, const Vector& from, const Vector& direction,
                    double radians);
SolidPtr sweep(const Solid& profile, const Solid& path, const Bundle& guide, Reals normal,
               bool frenet, bool solid, std::uint8_t transition);
SolidPtr sweep_multi(const Bundle& sections, const Solid& path, const Bundle& guide, Reals normal,
                     bool frenet, bool solid);
SolidPtr loft(const Bundle& wires, bool ruled, bool solid);

// solids.cpp
SolidPtr fillet_edges(const Solid& solid, const Bundle& edges, double radius);
SolidPtr chamfer_edges(const Solid& solid, const Bundle& edges, double first, double second);
SolidPtr hollow(const Solid& solid, const Bundle& open, double thickness, std::uint8_t corner,
                double tolerance);
SolidPtr solid_wedge(const At& at, double dx, double dy, double dz, double xmin, double zmin,
                     double xmax, double zmax);
SolidPtr solid_torus(const At& at, double major, double minor);
SolidPtr solid_sphere(const At& at, double radius, double low, double high, double turn);
SolidPtr solid_cylinder(const At& at, double radius, double height, double turn);
SolidPtr solid_cone(const At& at, double base, double top, double height, double turn);

// combine.cpp
SolidPtr fuse_all(const Solid& shape, const Bundle& others, bool glue, double tolerance);
SolidPtr cut_all(const Solid& shape, const Bundle& tools, double tolerance);
SolidPtr common_all(const Solid& shape, const Bundle& others, double tolerance);
SolidPtr split_all(const Solid& shape, const Bundle& tools);
SolidPtr cleaned(const Solid& shape);

}  // namespace assemcad
