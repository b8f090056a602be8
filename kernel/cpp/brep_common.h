// What several of the verbs on shapes of any kind need; only for the .cpp files.
#pragma once

#include <Adaptor3d_Curve.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Ax3.hxx>

#include "assemcad-kernel/src/brep/ffi.rs.h"
#include "brep.h"
#include "common.h"

namespace assemcad {

// The kinds as Rust counts them are TopAbs_ShapeEnum's numbers: compound 0 to vertex 7.
TopAbs_ShapeEnum kind_named(std::uint8_t kind);

// The face, or Refused for any other kind of shape.
TopoDS_Face face_in(const TopoDS_Shape& shape);
// The wire, an edge made a wire, or Refused.
TopoDS_Wire wire_in(const TopoDS_Shape& shape);
// The distinct sub-shapes of one kind in the order of TopExp::MapShapes.
std::vector<TopoDS_Shape> distinct(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind);
// The direct children in their order.
std::vector<TopoDS_Shape> direct(const TopoDS_Shape& shape);
bool holds(const TopoDS_Shape& shape, const TopoDS_Shape& part);
TopTools_ListOfShape list_of(const std::vector<TopoDS_Shape>& shapes);
TopoDS_Shape compound_from(const std::vector<TopoDS_Shape>& shapes);
// The outer wire of a face and its other wires.
TopoDS_Wire outer_of(const TopoDS_Face& face);
std::vector<TopoDS_Shape> inner_of(const TopoDS_Face& face);

// The curve of an edge or along a wire; Refused for anything else and for edges without a curve.
Handle(Adaptor3d_Curve) curve_along(const TopoDS_Shape& shape);
// Where an edge or wire begins or ends.
gp_Pnt end_of(const TopoDS_Shape& shape, bool last);
// The same body, built anew in an order that its geometry alone decides.
SolidPtr canonical(const TopoDS_Shape& shape);
// A helix on a cylinder (half angle 0) or cone; a pitch below 0 turns backwards.
TopoDS_Wire helix(double pitch, double height, double radius, const gp_Ax3& at, double half_angle,
                  bool left);

}  // namespace assemcad
