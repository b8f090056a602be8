// What several of the verbs need; only for the .cpp files.
#pragma once

#include <Bnd_Box.hxx>
#include <Message_Report.hxx>
#include <TopAbs_ShapeEnum.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Ax2.hxx>
#include <gp_Pnt.hxx>
#include <gp_Trsf.hxx>

#include <array>
#include <string>

#include "assemcad-kernel/src/ffi.rs.h"
#include "shim.h"

namespace assemcad {

inline gp_Pnt pnt(const std::array<double, 3>& p) { return gp_Pnt(p[0], p[1], p[2]); }
inline gp_Dir dir(const std::array<double, 3>& d) { return gp_Dir(d[0], d[1], d[2]); }

template <typename T>
std::array<double, 3> xyz(const T& v) {
  // Adding 0.0 turns -0.0 into 0.0, which would otherwise print differently.
  return {v.X() + 0.0, v.Y() + 0.0, v.Z() + 0.0};
}

gp_Ax2 axes(const At& at);
gp_Trsf trsf(const Pose& pose);

// A handle of its own, or Refused where there is no shape.
SolidPtr wrap(const TopoDS_Shape& shape);
const TopoDS_Shape& shape_of(const Solid& solid);
// The same shape at another place, nothing copied.
TopoDS_Shape moved(const Solid& solid, const Pose& pose);

// A copy of the shape with triangles on its faces.
TopoDS_Shape meshed(const Solid& solid, double deflection, double angle);

// The tight box, without triangulation and without tolerances.
Bnd_Box tight_box(const TopoDS_Shape& shape);
BoundsRaw raw_bounds(const Bnd_Box& box);

// How the faces of an edge that is no point meet: 0 convex, 1 concave, 2 smooth, 3 seam or no two faces.
std::uint8_t turn_of(const TopoDS_Edge& edge, const TopTools_ListOfShape& faces);

std::uint32_t count(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind);

// "BRepCheck_NotClosed" or "BOPAlgo_AlertTooSmallEdge" as words: "not closed", "too small edge".
std::string words(std::string identifier);
// What BRepCheck has against a shape, at most eight reasons; empty when it is valid.
rust::Vec<rust::String> reasons(const TopoDS_Shape& shape);
std::string joined(const rust::Vec<rust::String>& list);
// The alerts of one gravity, as words.
rust::Vec<rust::String> alerts(const Handle(Message_Report)& report, Message_Gravity gravity);

}  // namespace assemcad
