#include <BRepBuilderAPI_Copy.hxx>
#include <BRepLib_ToolTriangulatedShape.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <IMeshTools_Parameters.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>

#include "common.h"

namespace assemcad {

namespace {

// The edges as the triangles of their faces have them, so that the two lie on each other exactly.
void add_lines(const TopoDS_Shape& shape, MeshRaw& out) {
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  TopTools_IndexedDataMapOfShapeListOfShape faces;
  TopExp::MapShapesAndUniqueAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces);
  for (Standard_Integer e = 1; e <= edges.Extent(); ++e) {
    const TopoDS_Edge& edge = TopoDS::Edge(edges(e));
    const TopTools_ListOfShape& around = faces.FindFromKey(edge);
    if (BRep_Tool::Degenerated(edge) || around.IsEmpty()) {
      continue;
    }
    TopLoc_Location location;
    const Handle(Poly_Triangulation) part =
        BRep_Tool::Triangulation(TopoDS::Face(around.First()), location);
    const Handle(Poly_PolygonOnTriangulation) line =
        BRep_Tool::PolygonOnTriangulation(edge, part, location);
    if (line.IsNull()) {
      throw Invalid("an edge has no place in the triangles of its face");
    }
    for (Standard_Integer i = 1; i <= line->NbNodes(); ++i) {
      for (const double n : xyz(part->Node(line->Node(i)).Transformed(location.Transformation()))) {
        out.lines.push_back(n);
      }
    }
    out.line_ends.push_back(static_cast<std::uint32_t>(out.lines.size() / 3));
    out.line_turns.push_back(turn_of(edge, around));
  }
}

}  // namespace

TopoDS_Shape meshed(const Solid& solid, double deflection, double angle) {
  // A copy: a mesh left on the shape would be taken for the next one's, and change its bytes.
  TopoDS_Shape shape =
      BRepBuilderAPI_Copy(shape_of(solid), Standard_True, Standard_False).Shape();
  IMeshTools_Parameters parameters;
  parameters.Deflection = deflection;
  parameters.Angle = angle;
  parameters.InParallel = Standard_False;
  // Plates with hundreds of holes take a fifth of the time that the other one takes.
  parameters.MeshAlgo = IMeshTools_MeshAlgoType_Delabella;
  BRepMesh_IncrementalMesh mesher(shape, parameters);
  if (!mesher.IsDone()) {
    throw Invalid("it could not be meshed");
  }
  return shape;
}

MeshRaw mesh(const Solid& solid, double deflection, double angle) {
  const TopoDS_Shape shape = meshed(solid, deflection, angle);

  MeshRaw out;
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  for (Standard_Integer f = 1; f <= faces.Extent(); ++f) {
    const TopoDS_Face& face = TopoDS::Face(faces(f));
    TopLoc_Location location;
    const Handle(Poly_Triangulation) part = BRep_Tool::Triangulation(face, location);
    if (part.IsNull() || part->NbTriangles() == 0) {
      throw Invalid("a face could not be meshed");
    }
    BRepLib_ToolTriangulatedShape::ComputeNormals(face, part);
    const gp_Trsf t = location.Transformation();
    const bool turned = face.Orientation() == TopAbs_REVERSED;
    const std::uint32_t base = static_cast<std::uint32_t>(out.positions.size() / 3);
    for (Standard_Integer i = 1; i <= part->NbNodes(); ++i) {
      const gp_Pnt point = part->Node(i).Transformed(t);
      gp_Dir normal = part->Normal(i).Transformed(t);
      if (turned) {
        normal.Reverse();
      }
      for (const double n : xyz(point)) {
        out.positions.push_back(n);
      }
      for (const double n : xyz(normal)) {
        out.normals.push_back(n);
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
  }
  add_lines(shape, out);
  return out;
}

}  // namespace assemcad
