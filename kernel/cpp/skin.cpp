#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <gp_Circ.hxx>
#include <gp_Cone.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Pln.hxx>
#include <gp_Sphere.hxx>
#include <gp_Torus.hxx>

#include <algorithm>
#include <cmath>

#include "common.h"

namespace assemcad {

namespace {

// The surface of a face with all its numbers, and its side: whether the outward normal is the one that
// points away from the axis, the centre or, for a torus, the circle in the middle of its tube.
void add_surface(const BRepAdaptor_Surface& surface, const TopoDS_Face& face, SkinFaceRaw& out) {
  gp_Ax3 position;
  switch (surface.GetType()) {
    case GeomAbs_Plane:
      out.kind = 0;
      position = surface.Plane().Position();
      break;
    case GeomAbs_Cylinder:
      out.kind = 1;
      position = surface.Cylinder().Position();
      out.radius = surface.Cylinder().Radius();
      break;
    case GeomAbs_Cone:
      out.kind = 2;
      position = surface.Cone().Position();
      out.radius = surface.Cone().RefRadius();
      out.other = std::tan(surface.Cone().SemiAngle());
      break;
    case GeomAbs_Sphere:
      out.kind = 3;
      position = surface.Sphere().Position();
      out.radius = surface.Sphere().Radius();
      break;
    case GeomAbs_Torus:
      out.kind = 4;
      position = surface.Torus().Position();
      out.radius = surface.Torus().MajorRadius();
      out.other = surface.Torus().MinorRadius();
      break;
    default:
      out.kind = 5;
      return;
  }
  out.origin = xyz(position.Location());
  out.axis = xyz(position.Direction());
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  BRepTools::UVBounds(face, u0, u1, v0, v1);
  gp_Pnt point;
  gp_Vec du;
  gp_Vec dv;
  surface.D1(0.5 * (u0 + u1), 0.5 * (v0 + v1), point, du, dv);
  gp_Vec normal = du.Crossed(dv);
  if (face.Orientation() == TopAbs_REVERSED) {
    normal.Reverse();
  }
  const gp_Vec axis(position.Direction());
  const gp_Vec arm(position.Location(), point);
  const gp_Vec across = arm - axis * arm.Dot(axis);
  switch (out.kind) {
    case 0:
      out.axis = xyz(gp_Dir(normal));
      out.outward = true;
      return;
    case 3:
      out.outward = normal.Dot(arm) > 0.0;
      break;
    case 4: {
      const gp_Vec core = across.Magnitude() > 0.0 ? across.Normalized() * out.radius : across;
      out.outward = normal.Dot(arm - core) > 0.0;
      break;
    }
    default:
      out.outward = normal.Dot(across) > 0.0;
  }
  out.low = v0;
  out.high = v1;
}

// How far the triangles of a face are off its surface, looked at in the middle of each triangle and of
// its sides.
double off_surface(const BRepAdaptor_Surface& surface, const Handle(Poly_Triangulation) & part,
                   const gp_Trsf& t, double deflection) {
  if (surface.GetType() == GeomAbs_Plane) {
    return 0.0;
  }
  if (!part->HasUVNodes()) {
    return deflection;
  }
  double most = 0.0;
  for (Standard_Integer i = 1; i <= part->NbTriangles(); ++i) {
    Standard_Integer n[3];
    part->Triangle(i).Get(n[0], n[1], n[2]);
    gp_XYZ sum;
    gp_XY sum_uv;
    for (int k = 0; k < 3; ++k) {
      const int l = (k + 1) % 3;
      const gp_XYZ here = part->Node(n[k]).Transformed(t).XYZ();
      const gp_XYZ next = part->Node(n[l]).Transformed(t).XYZ();
      const gp_XY uv = 0.5 * (part->UVNode(n[k]).XY() + part->UVNode(n[l]).XY());
      const gp_Pnt on = surface.Value(uv.X(), uv.Y());
      most = std::max(most, (on.XYZ() - 0.5 * (here + next)).Modulus());
      sum += here / 3.0;
      sum_uv += part->UVNode(n[k]).XY() / 3.0;
    }
    const gp_Pnt on = surface.Value(sum_uv.X(), sum_uv.Y());
    most = std::max(most, (on.XYZ() - sum).Modulus());
  }
  return most;
}

void add_triangles(const TopoDS_Face& face, double deflection, SkinFaceRaw& facts, SkinRaw& out) {
  TopLoc_Location location;
  const Handle(Poly_Triangulation) part = BRep_Tool::Triangulation(face, location);
  if (part.IsNull() || part->NbTriangles() == 0) {
    throw Invalid("a face could not be meshed");
  }
  const gp_Trsf t = location.Transformation();
  const bool turned = face.Orientation() == TopAbs_REVERSED;
  const std::uint32_t base = static_cast<std::uint32_t>(out.positions.size() / 3);
  for (Standard_Integer i = 1; i <= part->NbNodes(); ++i) {
    for (const double n : xyz(part->Node(i).Transformed(t))) {
      out.positions.push_back(n);
    }
  }
  for (Standard_Integer i = 1; i <= part->NbTriangles(); ++i) {
    Standard_Integer a = 0;
    Standard_Integer b = 0;
    Standard_Integer c = 0;
    part->Triangle(i).Get(a, b, c);
    if (turned) {
      std::swap(b, c);
    }
    for (const Standard_Integer node : {a, b, c}) {
      out.triangles.push_back(base + static_cast<std::uint32_t>(node - 1));
    }
  }
  facts.triangles_end = static_cast<std::uint32_t>(out.triangles.size() / 3);
  const BRepAdaptor_Surface surface(face);
  add_surface(surface, face, facts);
  facts.off = off_surface(surface, part, t, deflection);
}

SkinEdgeRaw edge_facts(const TopoDS_Edge& edge, const TopTools_ListOfShape& around) {
  SkinEdgeRaw out{};
  if (BRep_Tool::Degenerated(edge)) {
    out.kind = 3;
    out.turn = 3;
    out.start = out.end = out.middle = xyz(BRep_Tool::Pnt(TopExp::FirstVertex(edge)));
    return out;
  }
  const BRepAdaptor_Curve curve(edge);
  const double first = curve.FirstParameter();
  const double last = curve.LastParameter();
  out.start = xyz(curve.Value(first));
  out.end = xyz(curve.Value(last));
  out.middle = xyz(curve.Value(0.5 * (first + last)));
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
      // Its axis looks along z of its own frame: the angle grows with the parameter.
      out.sweep = last - first;
      break;
    }
    default:
      out.kind = 2;
  }
  out.turn = turn_of(edge, around);

  // How far the chain of the triangles' nodes is off the curve, looked at in the middle of each link.
  TopLoc_Location location;
  const Handle(Poly_Triangulation) part =
      BRep_Tool::Triangulation(TopoDS::Face(around.First()), location);
  const Handle(Poly_PolygonOnTriangulation) line =
      BRep_Tool::PolygonOnTriangulation(edge, part, location);
  if (line.IsNull() || !line->HasParameters()) {
    throw Invalid("an edge has no place in the triangles of its face");
  }
  const gp_Trsf t = location.Transformation();
  for (Standard_Integer i = 1; i < line->NbNodes(); ++i) {
    const gp_XYZ here = part->Node(line->Node(i)).Transformed(t).XYZ();
    const gp_XYZ next = part->Node(line->Node(i + 1)).Transformed(t).XYZ();
    const gp_Pnt on = curve.Value(0.5 * (line->Parameter(i) + line->Parameter(i + 1)));
    out.off = std::max(out.off, (on.XYZ() - 0.5 * (here + next)).Modulus());
  }
  return out;
}

}  // namespace

SkinRaw skin(const Solid& solid, double deflection, double angle) {
  const TopoDS_Shape shape = meshed(solid, deflection, angle);
  SkinRaw out;
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  TopTools_IndexedDataMapOfShapeListOfShape around;
  TopExp::MapShapesAndUniqueAncestors(shape, TopAbs_EDGE, TopAbs_FACE, around);
  for (Standard_Integer e = 1; e <= edges.Extent(); ++e) {
    const TopTools_ListOfShape& faces = around.FindFromKey(edges(e));
    if (faces.IsEmpty()) {
      throw Invalid("an edge bounds no face");
    }
    out.edges.push_back(edge_facts(TopoDS::Edge(edges(e)), faces));
  }
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  std::vector<std::uint32_t> shell_of(faces.Extent() + 1, 0);
  TopTools_IndexedMapOfShape shells;
  TopExp::MapShapes(shape, TopAbs_SHELL, shells);
  for (Standard_Integer s = 1; s <= shells.Extent(); ++s) {
    for (TopExp_Explorer it(shells(s), TopAbs_FACE); it.More(); it.Next()) {
      shell_of[faces.FindIndex(it.Current())] = static_cast<std::uint32_t>(s - 1);
    }
  }
  for (Standard_Integer f = 1; f <= faces.Extent(); ++f) {
    SkinFaceRaw facts{};
    const TopoDS_Face& face = TopoDS::Face(faces(f));
    facts.shell = shell_of[f];
    add_triangles(face, deflection, facts, out);
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
      const std::uint32_t index = static_cast<std::uint32_t>(edges.FindIndex(it.Current()) - 1);
      out.face_edges.push_back(index);
      facts.off = std::max(facts.off, out.edges[index].off);
    }
    facts.edges_end = static_cast<std::uint32_t>(out.face_edges.size());
    out.faces.push_back(facts);
  }
  return out;
}

}  // namespace assemcad
