#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <ElCLib.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <Geom2d_Curve.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Cone.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Lin.hxx>
#include <gp_Pln.hxx>
#include <gp_Sphere.hxx>
#include <gp_Torus.hxx>

#include <cmath>

#include "common.h"
#include "integrals.h"

namespace assemcad {

namespace {

// Two faces whose normals differ by less than this (radians) at an edge run smoothly into each
// other: well above what approximated fillets leave, well below any edge that is meant.
constexpr double SMOOTH_ANGLE = 1e-3;
// Points along an edge, its ends included.
constexpr int SAMPLES = 9;

// The normal that points out of the material.
gp_Vec outward(const BRepAdaptor_Surface& surface, const TopoDS_Face& face, double u, double v) {
  gp_Pnt point;
  gp_Vec du;
  gp_Vec dv;
  surface.D1(u, v, point, du, dv);
  gp_Vec normal = du.Crossed(dv);
  if (face.Orientation() == TopAbs_REVERSED) {
    normal.Reverse();
  }
  return normal;
}

// Where the axis passes a point nearest.
gp_Pnt on_axis(const gp_Ax1& axis, const gp_Pnt& near) {
  const gp_Lin line(axis);
  return ElCLib::Value(ElCLib::Parameter(line, near), line);
}

void axial(FaceRaw& out, const gp_Ax3& position, const gp_Pnt& centroid) {
  out.axis = xyz(position.Direction());
  out.origin = xyz(on_axis(position.Axis(), centroid));
}

FaceRaw facts(const TopoDS_Face& face) {
  FaceRaw out{};
  const Integrals found = integrals(face);
  const gp_Pnt centroid = found.area_center;
  const BRepAdaptor_Surface surface(face);
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  BRepTools::UVBounds(face, u0, u1, v0, v1);
  const double u = 0.5 * (u0 + u1);
  const double v = 0.5 * (v0 + v1);
  const gp_Pnt middle = surface.Value(u, v);
  const gp_Vec normal = outward(surface, face, u, v);

  out.area = found.area;
  out.bounds = raw_bounds(tight_box(face));
  out.origin = xyz(centroid);
  out.span = u1 - u0;
  gp_Pnt core = centroid;
  switch (surface.GetType()) {
    case GeomAbs_Plane:
      out.kind = 0;
      out.normal = xyz(gp_Dir(normal));
      out.span = 0.0;
      return out;
    case GeomAbs_Cylinder: {
      const gp_Cylinder cylinder = surface.Cylinder();
      out.kind = 1;
      out.radius = cylinder.Radius();
      axial(out, cylinder.Position(), centroid);
      core = on_axis(cylinder.Axis(), middle);
      break;
    }
    case GeomAbs_Cone: {
      const gp_Cone cone = surface.Cone();
      out.kind = 2;
      out.half_angle = std::abs(cone.SemiAngle());
      axial(out, cone.Position(), centroid);
      const gp_Vec up(cone.Location(), pnt(out.origin));
      const double along = up.Dot(gp_Vec(cone.Position().Direction()));
      out.radius = std::abs(cone.RefRadius() + along * std::tan(cone.SemiAngle()));
      core = on_axis(cone.Axis(), middle);
      break;
    }
    case GeomAbs_Sphere: {
      const gp_Sphere sphere = surface.Sphere();
      out.kind = 3;
      out.radius = sphere.Radius();
      out.axis = xyz(sphere.Position().Direction());
      out.origin = xyz(sphere.Location());
      core = sphere.Location();
      break;
    }
    case GeomAbs_Torus: {
      const gp_Torus torus = surface.Torus();
      out.kind = 4;
      out.radius = torus.MajorRadius();
      out.minor_radius = torus.MinorRadius();
      out.axis = xyz(torus.Position().Direction());
      out.origin = xyz(torus.Location());
      const gp_Vec arm = gp_Vec(on_axis(torus.Axis(), middle), middle);
      const gp_Pnt foot = torus.Location();
      core = arm.Magnitude() > 0.0 ? foot.Translated(arm.Normalized() * torus.MajorRadius()) : foot;
      break;
    }
    default:
      out.kind = 5;
      out.span = 0.0;
      return out;
  }
  // A normal towards the core of the surface means that the material is around it: a hole.
  out.inward = normal.Dot(gp_Vec(middle, core)) > 0.0;
  if (out.kind <= 2) {
    // The axial range of the face, from the origin along the axis.
    const gp_Vec axis(dir(out.axis));
    const gp_Pnt origin = pnt(out.origin);
    const double a = gp_Vec(origin, surface.Value(u, v0)).Dot(axis);
    const double b = gp_Vec(origin, surface.Value(u, v1)).Dot(axis);
    out.low = std::min(a, b);
    out.high = std::max(a, b);
  }
  return out;
}

// How the faces meet at the middle of an edge: 0 convex, 1 concave, 2 smooth, 3 seam or no two faces.
std::uint8_t turn(const TopoDS_Edge& edge, const TopTools_ListOfShape& faces, double middle,
                  const gp_Vec& tangent) {
  if (faces.Extent() != 2 || faces.First().IsSame(faces.Last())) {
    return 3;
  }
  gp_Vec normals[2];
  bool along = true;
  int i = 0;
  for (TopTools_ListOfShape::Iterator it(faces); it.More(); it.Next(), ++i) {
    const TopoDS_Face& face = TopoDS::Face(it.Value());
    double first = 0;
    double last = 0;
    const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
    if (curve.IsNull()) {
      return 3;
    }
    const gp_Pnt2d uv = curve->Value(middle);
    normals[i] = outward(BRepAdaptor_Surface(face), face, uv.X(), uv.Y());
    if (normals[i].Magnitude() <= 0.0) {
      return 3;
    }
    if (i == 0) {
      for (TopExp_Explorer own(face, TopAbs_EDGE); own.More(); own.Next()) {
        if (own.Current().IsSame(edge)) {
          along = own.Current().Orientation() != TopAbs_REVERSED;
        }
      }
    }
  }
  if (normals[0].Angle(normals[1]) < SMOOTH_ANGLE) {
    return 2;
  }
  // Material lies to the left of the edge as its face runs along it.
  const double sign = normals[0].Crossed(normals[1]).Dot(along ? tangent : tangent.Reversed());
  return sign > 0.0 ? 0 : 1;
}

EdgeRaw facts(const TopoDS_Edge& edge, const TopTools_ListOfShape& faces) {
  EdgeRaw out{};
  if (BRep_Tool::Degenerated(edge)) {
    out.kind = 3;
    out.turn = 3;
    const gp_Pnt point = BRep_Tool::Pnt(TopExp::FirstVertex(edge));
    out.start = out.end = out.middle = xyz(point);
    out.bounds.min = out.bounds.max = xyz(point);
    return out;
  }
  const BRepAdaptor_Curve curve(edge);
  const double first = curve.FirstParameter();
  const double last = curve.LastParameter();
  const double middle = 0.5 * (first + last);
  gp_Pnt point;
  gp_Vec tangent;
  curve.D1(middle, point, tangent);
  out.start = xyz(curve.Value(first));
  out.end = xyz(curve.Value(last));
  out.middle = xyz(point);
  if (tangent.Magnitude() > 0.0) {
    out.tangent = xyz(gp_Dir(tangent));
  }
  out.length = GCPnts_AbscissaPoint::Length(curve, 1e-9);
  out.bounds = raw_bounds(tight_box(edge));
  for (int i = 0; i < SAMPLES; ++i) {
    const gp_Pnt sample = curve.Value(first + (last - first) * i / (SAMPLES - 1));
    for (const double n : xyz(sample)) {
      out.samples.push_back(n);
    }
  }
  switch (curve.GetType()) {
    case GeomAbs_Line:
      out.kind = 0;
      break;
    case GeomAbs_Circle: {
      const gp_Circ circle = curve.Circle();
      out.kind = 1;
      out.radius = circle.Radius();
      out.center = xyz(circle.Location());
      out.axis = xyz(circle.Axis().Direction());
      break;
    }
    default:
      out.kind = 2;
  }
  out.turn = turn(edge, faces, middle, tangent);
  return out;
}

}  // namespace

std::uint8_t turn_of(const TopoDS_Edge& edge, const TopTools_ListOfShape& faces) {
  const BRepAdaptor_Curve curve(edge);
  const double middle = 0.5 * (curve.FirstParameter() + curve.LastParameter());
  gp_Pnt point;
  gp_Vec tangent;
  curve.D1(middle, point, tangent);
  return turn(edge, faces, middle, tangent);
}

rust::Vec<FaceRaw> faces(const Solid& solid) {
  TopTools_IndexedMapOfShape map;
  TopExp::MapShapes(shape_of(solid), TopAbs_FACE, map);
  rust::Vec<FaceRaw> out;
  for (Standard_Integer i = 1; i <= map.Extent(); ++i) {
    out.push_back(facts(TopoDS::Face(map(i))));
  }
  return out;
}

rust::Vec<EdgeRaw> edges(const Solid& solid) {
  // The order of the indices that `fillet` and `chamfer` take.
  TopTools_IndexedMapOfShape map;
  TopExp::MapShapes(shape_of(solid), TopAbs_EDGE, map);
  TopTools_IndexedDataMapOfShapeListOfShape faces;
  TopExp::MapShapesAndUniqueAncestors(solid.shape, TopAbs_EDGE, TopAbs_FACE, faces);
  rust::Vec<EdgeRaw> out;
  for (Standard_Integer i = 1; i <= map.Extent(); ++i) {
    out.push_back(facts(TopoDS::Edge(map(i)), faces.FindFromKey(map(i))));
  }
  return out;
}

}  // namespace assemcad
