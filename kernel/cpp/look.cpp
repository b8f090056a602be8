#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepGProp_Face.hxx>
#include <BRepLib_FindSurface.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <GProp_GProps.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <Geom_Plane.hxx>
#include <TopoDS.hxx>
#include <gp_Circ.hxx>
#include <gp_Elips.hxx>
#include <gp_Pln.hxx>

#include <cmath>

#include "brep_common.h"
#include "integrals.h"

namespace assemcad {

namespace {

// What a shape is weighed by; a compound by its first child that is none, as if all were alike.
TopAbs_ShapeEnum weighed_as(const TopoDS_Shape& shape) {
  TopoDS_Shape at = shape;
  while (at.ShapeType() == TopAbs_COMPOUND) {
    const std::vector<TopoDS_Shape> children = direct(at);
    if (children.empty()) {
      return TopAbs_SOLID;
    }
    at = children.front();
  }
  return at.ShapeType();
}

GProp_GProps line_props(const TopoDS_Shape& shape) {
  GProp_GProps props;
  BRepGProp::LinearProperties(shape, props);
  return props;
}

// The relative error of the default is 1e-4 for a plain ellipse.
constexpr double LENGTH_TOLERANCE = 1e-10;

double length_of(const TopoDS_Shape& shape) {
  double sum = 0.0;
  for (const TopoDS_Shape& part : distinct(shape, TopAbs_EDGE)) {
    const TopoDS_Edge& edge = TopoDS::Edge(part);
    if (!BRep_Tool::Degenerated(edge)) {
      sum += GCPnts_AbscissaPoint::Length(BRepAdaptor_Curve(edge), LENGTH_TOLERANCE);
    }
  }
  return sum;
}

Vector unit(const gp_Vec& v) {
  if (!(v.Magnitude() > gp::Resolution())) {
    throw Refused("there is no direction at this point");
  }
  return xyz(gp_Dir(v));
}

Vector face_normal(const TopoDS_Face& face, Reals near) {
  double u = 0.0;
  double v = 0.0;
  if (near.size() == 3) {
    const GeomAPI_ProjectPointOnSurf foot(gp_Pnt(near[0], near[1], near[2]),
                                          BRep_Tool::Surface(face));
    if (foot.NbPoints() == 0) {
      throw Refused("the point has no foot on the face's surface");
    }
    foot.LowerDistanceParameters(u, v);
  } else {
    double u0 = 0.0, u1 = 0.0, v0 = 0.0, v1 = 0.0;
    BRepTools::UVBounds(face, u0, u1, v0, v1);
    u = 0.5 * (u0 + u1);
    v = 0.5 * (v0 + v1);
  }
  gp_Pnt point;
  gp_Vec normal;
  BRepGProp_Face(face).Normal(u, v, point, normal);
  return unit(normal);
}

// The direction of a circle's or ellipse's axis, or of the plane that a curve lies in.
Vector curve_normal(const TopoDS_Shape& shape) {
  if (shape.ShapeType() == TopAbs_EDGE) {
    const Handle(Adaptor3d_Curve) curve = curve_along(shape);
    if (curve->GetType() == GeomAbs_Circle) {
      return xyz(curve->Circle().Axis().Direction());
    }
    if (curve->GetType() == GeomAbs_Ellipse) {
      return xyz(curve->Ellipse().Axis().Direction());
    }
  }
  const BRepLib_FindSurface found(shape, -1.0, Standard_True);
  const Handle(Geom_Plane) plane =
      found.Found() ? Handle(Geom_Plane)::DownCast(found.Surface()) : Handle(Geom_Plane)();
  if (plane.IsNull()) {
    throw Refused("the curve does not lie in one plane only");
  }
  return xyz(plane->Pln().Axis().Direction());
}

}  // namespace

// The order of `Form` in Rust: GeomAbs_SurfaceType (0 to 10), 20 + GeomAbs_CurveType, 40 + kind.
std::uint8_t form_of(const Solid& shape) {
  const TopoDS_Shape& s = shape_of(shape);
  switch (s.ShapeType()) {
    case TopAbs_FACE:
      return static_cast<std::uint8_t>(
          BRepAdaptor_Surface(TopoDS::Face(s), Standard_False).GetType());
    case TopAbs_EDGE:
      return static_cast<std::uint8_t>(20 + curve_along(s)->GetType());
    default:
      return static_cast<std::uint8_t>(40 + s.ShapeType());
  }
}

CenterRaw center_of(const Solid& shape) {
  const TopoDS_Shape& s = shape_of(shape);
  CenterRaw out{};
  if (s.ShapeType() == TopAbs_VERTEX) {
    out.center = xyz(BRep_Tool::Pnt(TopoDS::Vertex(s)));
    return out;
  }
  switch (weighed_as(s)) {
    case TopAbs_VERTEX:
      throw Refused("a group of points has no length, area or volume to weigh it by");
    case TopAbs_EDGE:
    case TopAbs_WIRE: {
      const GProp_GProps props = line_props(s);
      out.mass = props.Mass();
      out.center = xyz(props.CentreOfMass());
      return out;
    }
    case TopAbs_FACE:
    case TopAbs_SHELL: {
      const Integrals found = integrals(s);
      out.mass = found.area;
      out.center = xyz(found.area_center);
      return out;
    }
    default: {
      const Integrals found = integrals(s);
      out.mass = found.volume;
      out.center = xyz(found.center);
      return out;
    }
  }
}

MeasureRaw measure_of(const Solid& shape) {
  const TopoDS_Shape& s = shape_of(shape);
  MeasureRaw out{};
  if (count(s, TopAbs_FACE) == 0) {
    out.length = length_of(s);
    return out;
  }
  const Integrals found = integrals(s);
  // A face of a face may count backwards: an area is one all the same.
  out.area = std::abs(found.area);
  if (count(s, TopAbs_SOLID) > 0) {
    out.volume = found.volume;
  }
  return out;
}

bool valid_shape(const Solid& shape) {
  return BRepCheck_Analyzer(shape_of(shape)).IsValid();
}

PlaneRaw plane_of(const Solid& face) {
  const BRepAdaptor_Surface surface(face_in(shape_of(face)), Standard_False);
  if (surface.GetType() != GeomAbs_Plane) {
    throw Refused("the face is not flat");
  }
  const gp_Ax3 position = surface.Plane().Position();
  PlaneRaw out;
  out.origin = xyz(position.Location());
  out.x = xyz(position.XDirection());
  out.z = xyz(position.Direction());
  return out;
}

Vector normal_of(const Solid& shape, Reals near) {
  const TopoDS_Shape& s = shape_of(shape);
  switch (s.ShapeType()) {
    case TopAbs_FACE:
      return face_normal(TopoDS::Face(s), near);
    case TopAbs_EDGE:
    case TopAbs_WIRE:
      return curve_normal(s);
    default:
      throw Refused("only faces, wires and edges have one");
  }
}

}  // namespace assemcad
