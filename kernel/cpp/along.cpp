#include <BRepAdaptor_CompCurve.hxx>
#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <ShapeAnalysis.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <gp_Circ.hxx>

#include "brep_common.h"

namespace assemcad {

namespace {

Handle(Adaptor3d_Curve) curve_of_edge(const TopoDS_Shape& shape) {
  const TopoDS_Edge& edge = TopoDS::Edge(shape);
  if (BRep_Tool::Degenerated(edge)) {
    throw Refused("the edge has shrunk to a point");
  }
  return new BRepAdaptor_Curve(edge);
}

// The parameter at a share of the length.
double parameter(const Handle(Adaptor3d_Curve)& curve, double share) {
  const double length = GCPnts_AbscissaPoint::Length(*curve);
  const GCPnts_AbscissaPoint at(*curve, length * share, curve->FirstParameter());
  if (!at.IsDone()) {
    throw Invalid("the curve could not be measured");
  }
  return at.Parameter();
}

void only_curves(const TopoDS_Shape& shape) {
  if (shape.ShapeType() != TopAbs_EDGE && shape.ShapeType() != TopAbs_WIRE) {
    throw Refused("it is no edge and no wire");
  }
}

}  // namespace

Handle(Adaptor3d_Curve) curve_along(const TopoDS_Shape& shape) {
  only_curves(shape);
  if (shape.ShapeType() == TopAbs_EDGE) {
    return curve_of_edge(shape);
  }
  const std::vector<TopoDS_Shape> edges = direct(shape);
  if (edges.empty()) {
    throw Refused("the wire has no edges");
  }
  if (edges.size() == 1) {
    // The wire of one edge is that edge's own curve, whichever way the edge lies in it.
    return curve_of_edge(edges.front());
  }
  return new BRepAdaptor_CompCurve(TopoDS::Wire(shape));
}

gp_Pnt end_of(const TopoDS_Shape& shape, bool last) {
  only_curves(shape);
  TopoDS_Vertex first_vertex;
  TopoDS_Vertex last_vertex;
  ShapeAnalysis::FindBounds(shape, first_vertex, last_vertex);
  const TopoDS_Vertex& wanted = last ? last_vertex : first_vertex;
  if (wanted.IsNull()) {
    throw Refused("the curve has no ends");
  }
  return BRep_Tool::Pnt(wanted);
}

Vector curve_tangent(const Solid& curve, double share) {
  const Handle(Adaptor3d_Curve) along = curve_along(shape_of(curve));
  gp_Pnt point;
  gp_Vec tangent;
  along->D1(parameter(along, share), point, tangent);
  if (!(tangent.Magnitude() > gp::Resolution())) {
    throw Refused("the curve stands still there");
  }
  return xyz(gp_Dir(tangent));
}

Vector curve_position(const Solid& curve, double share) {
  const Handle(Adaptor3d_Curve) along = curve_along(shape_of(curve));
  return xyz(along->Value(parameter(along, share)));
}

Vector curve_end(const Solid& curve, bool last) { return xyz(end_of(shape_of(curve), last)); }

bool curve_closed(const Solid& curve) {
  const TopoDS_Shape& shape = shape_of(curve);
  only_curves(shape);
  return BRep_Tool::IsClosed(shape);
}

double curve_radius(const Solid& curve) {
  const TopoDS_Shape& shape = shape_of(curve);
  only_curves(shape);
  // Of a wire, the first edge of its curve counts.
  const std::vector<TopoDS_Shape> edges = distinct(shape, TopAbs_EDGE);
  if (edges.empty()) {
    throw Refused("the wire has no edges");
  }
  const Handle(Adaptor3d_Curve) first = curve_of_edge(edges.front());
  if (first->GetType() != GeomAbs_Circle) {
    throw Refused("the curve is no circle");
  }
  return first->Circle().Radius();
}

}  // namespace assemcad
