#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepLib.hxx>
#include <BRepLib_FindSurface.hxx>
#include <BRepOffsetAPI_MakeOffset.hxx>
#include <BRep_Tool.hxx>
#include <GCE2d_MakeSegment.hxx>
#include <Geom2d_Line.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <ShapeAnalysis_FreeBounds.hxx>
#include <TopTools_HSequenceOfShape.hxx>
#include <Precision.hxx>
#include <TopoDS.hxx>
#include <gp_Circ.hxx>

#include <cmath>

#include "brep_common.h"

namespace assemcad {

namespace {

void only_curves(const Bundle& shapes) {
  if (shapes.shapes.empty()) {
    throw Refused("there is nothing to make it of");
  }
  for (const TopoDS_Shape& shape : shapes.shapes) {
    if (shape.ShapeType() != TopAbs_EDGE && shape.ShapeType() != TopAbs_WIRE) {
      throw Refused("it takes edges and wires only");
    }
  }
}

}  // namespace

SolidPtr wire_of(const Bundle& edges) {
  only_curves(edges);
  // The builder takes edges only: of a wire its edges, in its order.
  std::vector<TopoDS_Shape> loose;
  for (const TopoDS_Shape& shape : edges.shapes) {
    const std::vector<TopoDS_Shape> own =
        shape.ShapeType() == TopAbs_WIRE ? direct(shape) : std::vector<TopoDS_Shape>{shape};
    loose.insert(loose.end(), own.begin(), own.end());
  }
  BRepBuilderAPI_MakeWire maker;
  maker.Add(list_of(loose));
  if (!maker.IsDone()) {
    throw Refused("its edges do not follow one another");
  }
  return wrap(maker.Wire());
}

BundlePtr wires_connected(const Bundle& curves, double tolerance) {
  only_curves(curves);
  Handle(TopTools_HSequenceOfShape) edges = new TopTools_HSequenceOfShape;
  for (const TopoDS_Shape& edge : distinct(compound_from(curves.shapes), TopAbs_EDGE)) {
    if (!BRep_Tool::Degenerated(TopoDS::Edge(edge))) {
      edges->Append(edge);
    }
  }
  Handle(TopTools_HSequenceOfShape) wires = new TopTools_HSequenceOfShape;
  ShapeAnalysis_FreeBounds::ConnectEdgesToWires(edges, tolerance, Standard_False, wires);
  BundlePtr out = bundle();
  for (const TopoDS_Shape& wire : *wires) {
    out->shapes.push_back(wire);
  }
  return out;
}

SolidPtr wire_polyline(Reals points, bool close) {
  BRepBuilderAPI_MakePolygon maker;
  for (std::size_t i = 0; i + 2 < points.size(); i += 3) {
    maker.Add(gp_Pnt(points[i], points[i + 1], points[i + 2]));
  }
  if (close) {
    maker.Close();
  }
  if (!maker.IsDone()) {
    throw Refused("two of its points are one");
  }
  return wrap(maker.Wire());
}

// On a cylinder where `half_angle` is 0, else on a cone that widens with it. A pitch below 0 turns
// backwards. `pitch` and `height` run along the surface, which on a cone is slanted.
TopoDS_Wire helix(double pitch, double height, double radius, const gp_Ax3& at, double half_angle,
                  bool left) {
  Handle(Geom_Surface) surface;
  if (half_angle == 0.0) {
    surface = new Geom_CylindricalSurface(at, radius);
  } else {
    surface = new Geom_ConicalSurface(at, half_angle, radius);
  }
  const double turn = 2.0 * M_PI;
  const Handle(Geom2d_Line) unrolled =
      new Geom2d_Line(gp_Pnt2d(0.0, 0.0), gp_Dir2d(left ? -turn : turn, pitch));
  const double far = height / pitch * std::sqrt(turn * turn + pitch * pitch);
  const GCE2d_MakeSegment segment(unrolled->Value(0.0), unrolled->Value(far));
  if (!segment.IsDone()) {
    throw Refused("it has no length");
  }
  BRepBuilderAPI_MakeEdge edge(segment.Value(), surface);
  if (!edge.IsDone()) {
    throw Invalid("it could not be laid on its surface");
  }
  BRepBuilderAPI_MakeWire wire(edge.Edge());
  const TopoDS_Wire out = wire.Wire();
  BRepLib::BuildCurves3d(out, 1e-6, GeomAbs_C1, 14, 2000);
  return out;
}

SolidPtr wire_helix(const At& at, double pitch, double height, double radius, double half_angle,
                    bool left) {
  return wrap(helix(pitch, height, radius, gp_Ax3(axes(at)), half_angle, left));
}

namespace {

// The circle that a wire is, if it is one.
bool whole_circle(const TopoDS_Wire& wire, gp_Circ& circle) {
  if (direct(wire).size() != 1 || !BRep_Tool::IsClosed(wire)) {
    return false;
  }
  const Handle(Adaptor3d_Curve) curve = curve_along(wire);
  if (curve->GetType() != GeomAbs_Circle) {
    return false;
  }
  circle = curve->Circle();
  return true;
}

}  // namespace

// Corners: 0 arcs, 1 lines prolonged, 2 tangent lines.
BundlePtr wire_offset(const Solid& wire, double distance, std::uint8_t corner) {
  const TopoDS_Wire spine = wire_in(shape_of(wire));
  gp_Circ circle;
  if (whole_circle(spine, circle)) {
    // Inwards of a circle by some distances is a segmentation fault: it needs no algorithm.
    BundlePtr out = bundle();
    const double radius = circle.Radius() + distance;
    if (radius > Precision::Confusion()) {
      circle.SetRadius(radius);
      out->shapes.push_back(wire_in(BRepBuilderAPI_MakeEdge(circle).Edge()));
    }
    return out;
  }
  // Without a plane the algorithm ends in a segmentation fault.
  if (!BRepLib_FindSurface(spine, -1.0, Standard_True).Found()) {
    throw Refused("the wire does not lie in one plane only");
  }
  BRepOffsetAPI_MakeOffset maker;
  maker.Init(corner == 0 ? GeomAbs_Arc : corner == 1 ? GeomAbs_Intersection : GeomAbs_Tangent);
  maker.AddWire(spine);
  maker.Perform(distance);
  if (!maker.IsDone()) {
    throw Invalid("nothing comes out at this distance");
  }
  const TopoDS_Shape made = maker.Shape();
  BundlePtr out = bundle();
  if (made.IsNull()) {
    return out;
  }
  if (made.ShapeType() == TopAbs_COMPOUND) {
    out->shapes = direct(made);
  } else {
    out->shapes.push_back(made);
  }
  return out;
}

}  // namespace assemcad
